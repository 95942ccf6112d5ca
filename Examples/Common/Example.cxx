// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Example.h"

#include "Frames.h"
#include "SizeOption.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLight.h"
#include "vtkNBufferCuller.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkShadowVolumeClampPass.h"
#include "vtkSphereSource.h"

#include <CLI/CLI.hpp>

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
/// CLI::Range lets it pass, as it is neither below the lowest nor above the highest number.
std::string RefuseNaN(const std::string& text)
{
  return std::isnan(std::strtod(text.c_str(), nullptr)) ? text + " is not a number" : std::string();
}
}

Example::Example(const std::string& description, const std::string& feature)
  : App(std::make_unique<CLI::App>(description))
{
  this->App->add_option(
    "--out", this->Out, "Folder for pictures (PNG); without it a window opens, q closes it");
  AddSizeOption(*this->App, this->Size, "Of the picture, in pixels");
  this->App->add_flag_callback(
    "--no-" + feature, [this]() { this->On = false; }, "The same scene without " + feature);
  this->Renderer->SetAutomaticLightCreation(0);
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
}

Example::~Example() = default;

template <typename Number>
void Example::AddOption(
  const std::string& name, Number& value, const std::string& help, Number lowest, Number highest)
{
  this->App->add_option(name, value, help)
    ->check(CLI::Range(lowest, highest))
    ->check(RefuseNaN)
    ->capture_default_str();
}
template void Example::AddOption(const std::string&, int&, const std::string&, int, int);
template void Example::AddOption(const std::string&, double&, const std::string&, double, double);

int Example::Run(int argc, char* argv[], const std::function<void()>& show)
{
  try
  {
    this->App->parse(argc, argv);
    show();
    return 0;
  }
  catch (const CLI::ParseError& error)
  {
    return this->App->exit(error);
  }
  catch (const std::exception& error)
  {
    std::cerr << argv[0] << ": " << error.what() << "\n";
    return 1;
  }
}

vtkActor* Example::AddMesh(vtkPolyData* mesh, const Triple& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetAmbient(0.25);
  this->Renderer->AddActor(actor);
  return actor;
}

vtkActor* Example::AddCuboid(const Triple& centre, const Triple& size, const Triple& color)
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(size[0]);
  box->SetYLength(size[1]);
  box->SetZLength(size[2]);
  box->SetCenter(centre[0], centre[1], centre[2]);
  box->Update();
  return this->AddMesh(box->GetOutput(), color);
}

vtkActor* Example::AddGlobe(const Triple& centre, double radius, const Triple& color)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(centre[0], centre[1], centre[2]);
  ball->SetRadius(radius);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  ball->Update();
  return this->AddMesh(ball->GetOutput(), color);
}

void Example::AddCuboids(const Triple& color, const Boxes& boxes, double x, double y, double turn)
{
  for (const auto& [centre, size] : boxes)
  {
    vtkActor* actor = this->AddCuboid(centre, size, color);
    actor->SetPosition(x, y, 0.0);
    actor->RotateZ(turn);
  }
}

void Example::AddFill(double intensity)
{
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(intensity);
  this->Renderer->AddLight(fill);
}

void Example::Compare(
  vtkNBufferCuller* culler, int frames, const std::function<void(int)>& setCamera)
{
  this->PrepareWindow("comparing");
  const auto draw = [&](int frame, bool withCuller)
  {
    setCamera(frame);
    culler->SetEnabled(withCuller && this->On);
    return RenderTimed(this->Window);
  };
  constexpr int patience = 100;
  for (int i = 0; i < patience && this->On && culler->GetStatistics().Units == 0; ++i)
  {
    draw(i % 2, true);
  }
  draw(0, true); // The first frame with units draws more of them than the next ones.
  draw(0, false);
  std::vector<double> times[2];
  long long bytes = 0;
  const char* second = this->On ? " ms, with the culler " : " ms, once more ";
  std::cout << std::fixed << std::setprecision(1);
  for (int frame = 0; frame < frames; ++frame)
  {
    times[0].push_back(draw(frame, false));
    const vtkSmartPointer<vtkUnsignedCharArray> expected = GrabPixels(this->Window);
    times[1].push_back(draw(frame, true));
    bytes += CountDifferingBytes(expected, GrabPixels(this->Window));
    const vtkNBufferStatistics& counts = culler->GetStatistics();
    std::cout << "frame " << frame << ": stock VTK " << times[0].back() << second << times[1].back()
              << " ms, " << counts.UnitsKept + counts.UnitsFresh << " units drawn, "
              << counts.UnitsHidden << " hidden, " << counts.UnitsOutside << " outside\n";
  }
  const double stock = GetMedian(times[0]);
  const double own = GetMedian(times[1]);
  std::cout << "medians: stock VTK " << stock << second << own << " ms";
  if (this->On)
  {
    std::cout << ", " << stock / own << " times as fast";
  }
  std::cout << "; " << bytes << " bytes differ\n";
  if (bytes > 0)
  {
    throw std::runtime_error("the culler changes the image");
  }
}

void Example::PrepareWindow(const std::string& name)
{
  CheckDisplay(this->Window, this->Out.empty(), "--out FOLDER");
  this->Window->SetSize(this->Size[0], this->Size[1]);
  this->Window->SetWindowName(name.c_str());
  this->Window->SetOffScreenRendering(this->Out.empty() ? 0 : 1);
}

void Example::Show(const std::string& picture, vtkShadowVolumeClampPass* pass)
{
  this->PrepareWindow(picture);
  if (this->Out.empty())
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    interactor->SetRenderWindow(this->Window);
    interactor->SetInteractorStyle(style);
    this->Window->Render();
    interactor->Start();
    return;
  }
  vtksys::SystemTools::MakeDirectory(this->Out);
  this->Window->Render();
  WriteFrame(this->Window, this->Out + "/" + picture + ".png");
  if (!pass)
  {
    return;
  }
  const vtkShadowStatistics& statistics = pass->GetStatistics();
  std::cout << picture << ": " << statistics.GetAsJSON() << "\n";
  if (this->On && statistics.Decision != vtkShadowDecision::Drawn)
  {
    throw std::runtime_error(picture + " has no shadows");
  }
}

} // namespace NBufferExamples
