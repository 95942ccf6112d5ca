// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Memory.h
 * @brief How much of the heap the process and the module's own code use.
 *
 * GetModuleBlocks() finds leaks of the module as vtkDebugLeaks finds leaks of VTK's objects, but
 * needs no special build of VTK: the program replaces operator new and records every block whose
 * caller is in the module's shared library. Every object of the module owns such blocks, except for
 * its props, which ForeignProps in LeakScene.h watches. Objects and strings that VTK and the C++
 * library allocate for the module count in GetHeapBytes() alone.
 */
#ifndef Memory_h
#define Memory_h

namespace Memory
{
/// Returns the bytes of the heap that the whole process uses, or -1 where that is unknown.
long long GetHeapBytes();

/// Returns the number of blocks that the module's code has allocated and that have not been freed.
/// Returns -1 where they are not counted: under AddressSanitizer and valgrind, which check for
/// leaks themselves, and with a static module.
long long GetModuleBlocks();

/// Returns the size of these blocks in bytes, or -1 where they are not counted.
long long GetModuleBytes();
}

#endif
