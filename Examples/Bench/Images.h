// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Images.h
 * @brief Images from pixels, and PNG files from images.
 */
#ifndef Images_h
#define Images_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkUnsignedCharArray;

namespace NBufferBench
{

/// An RGB image of RGBA bytes, row 0 at the bottom.
vtkSmartPointer<vtkImageData> MakeImage(vtkUnsignedCharArray* rgba, int width, int height);

/// Throws std::runtime_error when the file cannot be written.
void WritePNG(vtkImageData* image, const std::string& fileName);

/// Make a folder and those above it; throws std::runtime_error when it cannot be made.
void MakeFolder(const std::string& folder);

} // namespace NBufferBench

#endif
