// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelImages.h
 * @brief Levels of an N-buffer as coloured images.
 */
#ifndef LevelImages_h
#define LevelImages_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkNBufferLevels;

namespace NBufferBench
{

/**
 * One image per level asked for. Colours follow the logarithm of the distance from the eye, from
 * the nearest in level 0 (dark) to the farthest (light); where nothing was drawn it is white.
 * `near` and `far` are the distances of the clipping planes of a perspective camera.
 */
std::vector<vtkSmartPointer<vtkImageData>> MakeLevelImages(
  const vtkNBufferLevels& levels, const std::vector<int>& which, double near, double far);

} // namespace NBufferBench

#endif
