// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frames.h"

#include "vtkErrorCode.h"
#include "vtkImageExtractComponents.h"
#include "vtkNBufferClock.h"
#include "vtkNBufferVTKVersion.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace NBufferExamples
{

double RenderTimed(vtkRenderWindow* window)
{
  const vtkNBufferClock clock;
  window->Render();
  window->WaitForCompletion();
  return clock.GetMilliseconds();
}

double GetMedian(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

vtkSmartPointer<vtkUnsignedCharArray> GrabPixels(vtkRenderWindow* window)
{
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  const int* size = window->GetActualSize();
  // The front buffer was shown, so that its samples, if there are any, are resolved.
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  return pixels;
}

vtkSmartPointer<vtkImageData> MakeColorImage(vtkRenderWindow* window, vtkUnsignedCharArray* rgba)
{
  const int* size = window->GetActualSize();
  vtkNew<vtkImageData> image;
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(rgba);
  vtkNew<vtkImageExtractComponents> colors;
  colors->SetInputData(image);
  colors->SetComponents(0, 1, 2);
  colors->Update();
  return colors->GetOutput();
}

long long CountDifferingBytes(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  const vtkIdType count = a->GetNumberOfValues();
  if (b->GetNumberOfValues() != count)
  {
    return std::max(count, b->GetNumberOfValues());
  }
  long long differing = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    differing += a->GetValue(i) != b->GetValue(i);
  }
  return differing;
}

void CheckWritable(const std::string& fileName)
{
  if (!fileName.empty() && !std::ofstream(fileName, std::ios::app))
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

void WritePNG(vtkImageData* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(image);
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

void WriteFrame(vtkRenderWindow* window, const std::string& fileName)
{
  WritePNG(MakeColorImage(window, GrabPixels(window)), fileName);
}

void CheckDisplay(vtkRenderWindow* window, bool isShown, const std::string& option)
{
  const bool isX = window->IsA("vtkXOpenGLRenderWindow");
  const char* display = std::getenv("DISPLAY");
  if (isX && (!display || !*display))
  {
    throw std::runtime_error(
      "this VTK draws in X windows only, and DISPLAY is not set; xvfb-run has a display in memory");
  }
  const bool isInMemory =
    window->IsA("vtkOSOpenGLRenderWindow") || window->IsA("vtkEGLRenderWindow");
  if (isShown && isInMemory)
  {
    throw std::runtime_error(std::string("no window can be opened: VTK chose a ") +
      window->GetClassName() + ", which draws in memory; use " + option + ", or set DISPLAY");
  }
}

void PrepareWindow(vtkRenderWindow* window)
{
#if VTKNBUFFER_HAS_INITIALIZE
  window->Initialize();
#else
  vtkRenderer* renderer = window->GetRenderers()->GetFirstRenderer();
  renderer->DrawOff();
  window->Render();
  renderer->DrawOn();
#endif
  if (GetDevice(window).empty())
  {
    throw std::runtime_error(std::string("no OpenGL in a ") + window->GetClassName() +
      "; VTK_DEFAULT_OPENGL_WINDOW may name another class of windows");
  }
}

std::string GetDevice(vtkRenderWindow* window)
{
  const char* text = window->ReportCapabilities();
  std::cmatch found;
  const bool isNamed =
    text && std::regex_search(text, found, std::regex("OpenGL renderer string: *(.*)"));
  return isNamed ? found[1].str() : std::string();
}

} // namespace NBufferExamples
