// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelPicture.h
 * @brief The levels of an N-buffer as pictures.
 */
#ifndef LevelPicture_h
#define LevelPicture_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

class vtkNBufferLevels;
class vtkRenderWindow;

namespace NBufferExamples
{

/// Builds up to `count` levels over the depth of the frame that was rendered last; level 0 is that
/// depth. The levels end where one texel would cover the whole image.
void ReadLevels(vtkRenderWindow* window, int count, vtkNBufferLevels& levels);

/// Returns a level as an image. Colours (those of viridis) follow the logarithm of the distance
/// from the eye, from the nearest in level 0 (dark) to the farthest (light); where nothing was
/// drawn, the image is white. `range` has the distances of the clipping planes.
vtkSmartPointer<vtkImageData> MakeLevelImage(
  vtkNBufferLevels& levels, int level, const double range[2]);

} // namespace NBufferExamples

#endif
