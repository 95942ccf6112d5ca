// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegressionTest.h"

#include "ImageComparison.h"

#if VTKNBUFFER_HAS_VTK_TESTING
#include "vtkRegressionTestImage.h"
#else
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"
#endif

#include <exception>
#include <iostream>
#include <string>

#if VTKNBUFFER_HAS_VTK_TESTING

static_assert(RegressionTestFailed == vtkTesting::FAILED &&
  RegressionTestIsInteractive == vtkTesting::DO_INTERACTOR);

int RunRegressionTest(int argc, char* argv[], vtkRenderWindow* window)
{
  return vtkRegressionTestImage(window);
}

#else

int RunRegressionTest(int argc, char* argv[], vtkRenderWindow* window)
{
  std::string baseline;
  std::string folder = ".";
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "-I")
    {
      return RegressionTestIsInteractive;
    }
    if (i + 1 < argc && (argument == "-V" || argument == "-T"))
    {
      (argument == "-V" ? baseline : folder) = argv[++i];
    }
  }
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->Update();
  const std::string name =
    folder + "/" + baseline.substr(baseline.find_last_of("/\\") + 1); // also without a folder
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(name.c_str());
  writer->Write();
  try
  {
    const double error = GetImageError(ReadPicture(baseline), picture->GetOutput());
    std::cout << name << ": error " << error << ", at most " << LargestImageError << "\n";
    return error <= LargestImageError ? 1 : RegressionTestFailed;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return RegressionTestFailed;
  }
}

#endif
