// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageComparison.h
 * @brief Pictures against baselines, by vtkImageDifference.
 *
 * README.md in this folder says how pixels are compared, and why with these numbers.
 */
#ifndef ImageComparison_h
#define ImageComparison_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

/// Grey levels, of 255, by which a channel of a pixel may differ.
constexpr int PixelTolerance = 24;

/// The largest error at which two pictures are alike.
constexpr double LargestImageError = 8.0;

/**
 * How far two RGB pictures are apart: over all pixels but those of the border, two wide, the sum of
 * what the channels differ by beyond PixelTolerance, in units of 3 x 255. A pixel that is black in
 * one and white in the other counts 0.91. Infinite for pictures of different sizes.
 */
double GetImageError(vtkImageData* first, vtkImageData* second);

/// A PNG file; throws std::runtime_error if it cannot be read.
vtkSmartPointer<vtkImageData> ReadPicture(const std::string& fileName);

#endif
