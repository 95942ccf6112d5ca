// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageComparison.h
 * @brief Compares pictures with baselines by vtkImageDifference.
 *
 * README.md in this folder says how pixels are compared, and why with these numbers.
 */
#ifndef ImageComparison_h
#define ImageComparison_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

/// The difference of a channel (0 to 255) that counts as no difference.
constexpr int PixelTolerance = 24;

/// Two pictures are alike if their error, as GetImageError() returns it, is not larger than this.
constexpr double LargestImageError = 8.0;

/**
 * Returns the error of two RGB pictures: the sum over all pixels, except for a border of two
 * pixels, of what the channels differ by beyond PixelTolerance, divided by 3 x 255. A pixel that is
 * black in one picture and white in the other adds 0.91. The error of pictures of different sizes
 * is infinite.
 */
double GetImageError(vtkImageData* first, vtkImageData* second);

/// Reads a PNG file. Throws std::runtime_error if it cannot be read.
vtkSmartPointer<vtkImageData> ReadPicture(const std::string& fileName);

#endif
