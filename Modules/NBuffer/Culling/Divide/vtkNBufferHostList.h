// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferHostList.h
 * @brief Makes the lists of what is drawn of a large prop on the host, from VTK's own buffers.
 *
 * The host keeps no copy of these buffers. It maps them, which costs nothing with a software
 * renderer. On graphics devices compute shaders make the lists (vtkNBufferUnitDevice); one without
 * compute shaders waits until its driver has copied the buffer.
 */
#ifndef vtkNBufferHostList_h
#define vtkNBufferHostList_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferUnitDevice.h"
#include "vtkNBufferUnits.h"

#include <cstddef>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferHostList
{
/**
 * Copy the records of the primitives in `ranges` that are also in `part`, in their order. The
 * ranges are in ascending order, as those of vtkNBufferUnits::GetRanges(), and a source has one
 * record for each primitive of the part. If the name of the source is 0, the record of a primitive
 * is its number. Returns the number of records that were copied, or nothing if OpenGL maps no
 * buffer, for lack of memory.
 */
VTKNBUFFER_EXPORT std::optional<std::size_t> Copy(const std::vector<vtkNBufferUnits::Range>& ranges,
  const vtkNBufferUnits::Range& part, const std::vector<vtkNBufferUnitDevice::Records>& records);
}
VTK_ABI_NAMESPACE_END
#endif
