// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Memory.h
 * @brief What the process and the module's own code hold on the heap.
 *
 * GetModuleBlocks() does for the module what vtkDebugLeaks does for classes, without a VTK that was
 * built for it: the program replaces operator new and records every block whose caller lies in the
 * code of the module's shared library. All that the module makes owns such blocks, except for its
 * props (see Spy in LeakScene.h). Objects and strings that VTK and the C++ library allocate for it
 * only count in GetHeapBytes().
 */
#ifndef Memory_h
#define Memory_h

namespace Memory
{
/// Bytes that the whole process has in use on the heap, or -1 where that is unknown.
long long GetHeapBytes();

/// Blocks that the module's code allocated and nobody has freed, or -1 where they are not counted:
/// under AddressSanitizer and valgrind, whose own checks for leaks stand in, and with a static
/// module.
long long GetModuleBlocks();

/// Their size in bytes; -1 likewise.
long long GetModuleBytes();
}

#endif
