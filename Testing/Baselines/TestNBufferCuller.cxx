// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNBufferCuller.cxx
 * @brief A picture of the culler, compared with a baseline as VTK's own tests are.
 *
 *     nbuffer-cxx-tests TestNBufferCuller -D DATA -T FOLDER -V BASELINE [-I] [--no-culler]
 *
 * From left to right: walls of cones, one behind the other, drawn with the culler; the same from
 * above, what was culled in red; levels 0 and 4 of the N-buffer over the depth of the first view.
 * Without the culler nothing is red, and the picture must not be like the baseline.
 */
#include "LevelPicture.h"

#include "vtkNBufferCuller.h"
#include "vtkNBufferLevels.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#if VTKNBUFFER_HAS_VTK_TESTING
#include "vtkRegressionTestImage.h"
#else
#include "ImageComparison.h"
#include "vtkPNGWriter.h"
#include "vtkWindowToImageFilter.h"
#endif

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace
{
#if !VTKNBUFFER_HAS_VTK_TESTING
// VTK's wheels do not have the module TestingRendering. ImageComparison.h, which is stricter,
// compares in place of vtkTesting; results and arguments mean the same.
struct vtkTesting
{
  enum ReturnValue
  {
    FAILED = 0,
    PASSED = 1,
    DO_INTERACTOR = 3
  };
};
int CompareWithBaseline(int argc, char* argv[], vtkRenderWindow* window)
{
  std::string baseline;
  std::string folder = ".";
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "-I")
    {
      return vtkTesting::DO_INTERACTOR;
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
    return error <= LargestImageError ? vtkTesting::PASSED : vtkTesting::FAILED;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return vtkTesting::FAILED;
  }
}
#define vtkRegressionTestImage(window) CompareWithBaseline(argc, argv, window)
#endif

constexpr int Side = 240; // pixels of a view
constexpr int Views = 4;

/// The view at a place in the window.
void Place(vtkRenderer* renderer, int view)
{
  renderer->SetViewport(
    static_cast<double>(view) / Views, 0.0, static_cast<double>(view + 1) / Views, 1.0);
}

/// 12 walls of 20 x 12 cones.
std::vector<vtkSmartPointer<vtkActor>> MakeWalls()
{
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0.0, 0.0, 1.0);
  cone->SetRadius(0.8);
  cone->SetResolution(8);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (int i = 0; i < 12 * 20 * 12; ++i)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(i % 20, i / 20 % 12, i / 240 * -2);
    actors.emplace_back(actor);
  }
  return actors;
}

vtkSmartPointer<vtkRenderer> MakePictureView(vtkImageData* picture, int view)
{
  vtkNew<vtkImageActor> image;
  image->GetMapper()->SetInputData(picture);
  image->InterpolateOff();
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(image);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->ResetCamera();
  renderer->GetActiveCamera()->SetParallelScale(0.5 * Side);
  Place(renderer, view);
  return renderer;
}
}

int TestNBufferCuller(int argc, char* argv[])
{
  const bool isCulled = std::none_of(
    argv, argv + argc, [](const char* argument) { return std::string(argument) == "--no-culler"; });
  const std::vector<vtkSmartPointer<vtkActor>> actors = MakeWalls();
  vtkNew<vtkRenderer> frame;
  frame->SetBackground(0.45, 0.65, 0.88);
  for (vtkActor* actor : actors)
  {
    frame->AddActor(actor);
  }
  vtkNew<vtkNBufferCuller> culler;
  if (isCulled)
  {
    frame->AddCuller(culler);
  }
  // From the left of the walls, so that something is seen between them.
  vtkCamera* camera = frame->GetActiveCamera();
  camera->SetPosition(-4.0, 8.0, 26.0);
  camera->SetFocalPoint(8.0, 5.5, -6.0);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(Side, Side);
  window->AddRenderer(frame);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  window->Render();

  vtkNBufferLevels levels;
  NBufferExamples::ReadLevels(window, 5, levels);
  double range[2];
  camera->GetClippingRange(range);

  vtkNew<vtkRenderer> above;
  above->SetBackground(1.0, 1.0, 1.0);
  for (vtkActor* actor : actors)
  {
    const bool isHidden = culler->GetVerdict(actor) == vtkNBufferVerdict::Hidden;
    vtkNew<vtkActor> copy;
    copy->ShallowCopy(actor);
    vtkNew<vtkProperty> property;
    property->SetColor(isHidden ? 0.85 : 0.6, isHidden ? 0.1 : 0.6, isHidden ? 0.1 : 0.6);
    copy->SetProperty(property);
    above->AddActor(copy);
  }
  above->GetActiveCamera()->SetPosition(-9.0, 30.0, 20.0);
  above->GetActiveCamera()->SetFocalPoint(9.5, 5.5, -11.0);
  above->ResetCamera();

  window->SetSize(Views * Side, Side);
  Place(frame, 0);
  Place(above, 1);
  window->AddRenderer(above);
  window->AddRenderer(MakePictureView(NBufferExamples::MakeLevelImage(levels, 0, range), 2));
  window->AddRenderer(MakePictureView(NBufferExamples::MakeLevelImage(levels, 4, range), 3));
  window->Render();

  const int result = vtkRegressionTestImage(window);
  if (result == vtkTesting::DO_INTERACTOR)
  {
    interactor->Start();
  }
  return result == vtkTesting::FAILED ? EXIT_FAILURE : EXIT_SUCCESS;
}
