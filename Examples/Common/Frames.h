// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Frames.h
 * @brief Frames of a window: timed, read, compared, and written to a file.
 */
#ifndef Frames_h
#define Frames_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string>
#include <vector>

class vtkRenderWindow;

namespace NBufferExamples
{

/// Renders, waits until the image is finished, and returns the milliseconds that both took.
double RenderTimed(vtkRenderWindow* window);

/// Returns the median of at least one number, the higher one of two in the middle.
double GetMedian(std::vector<double> values);

/// Returns the RGBA bytes of the frame that was rendered last, row 0 at the bottom.
vtkSmartPointer<vtkUnsignedCharArray> GrabPixels(vtkRenderWindow* window);

/// Returns the colours of such bytes as an image of the window's size.
vtkSmartPointer<vtkImageData> MakeColorImage(vtkRenderWindow* window, vtkUnsignedCharArray* rgba);

/// Returns how many bytes of two frames differ: all of them if the frames differ in size.
long long CountDifferingBytes(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b);

/// Throws std::runtime_error, at the beginning of a long run, if the file cannot be written. An
/// empty name passes.
void CheckWritable(const std::string& fileName);

///@{
/// Write an image, or the frame that a window rendered last. Throw std::runtime_error if the file
/// cannot be written.
void WritePNG(vtkImageData* image, const std::string& fileName);
void WriteFrame(vtkRenderWindow* window, const std::string& fileName);
///@}

/// Throws std::runtime_error if a window cannot be drawn (VTK ends the program where it finds no X
/// server) or, if `isShown`, cannot be seen; `option` is what draws a picture instead.
void CheckDisplay(vtkRenderWindow* window, bool isShown, const std::string& option);

/// Makes the graphics context of a window now, so that its time is not part of the first frame.
/// Throws std::runtime_error if there is no OpenGL.
void PrepareWindow(vtkRenderWindow* window);

/// Returns GL_RENDERER, or an empty text if the window has no OpenGL.
std::string GetDevice(vtkRenderWindow* window);

} // namespace NBufferExamples

#endif
