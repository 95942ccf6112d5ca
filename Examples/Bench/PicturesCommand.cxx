// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PicturesCommand.cxx
 * @brief The subcommand pictures: images that show what the culler does; the README shows them.
 */
#include "Command.h"
#include "VerdictPicture.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkImageActor.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
#include "vtkNBufferLevels.h"
#include "vtkPointData.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::Scene;
using Image = vtkSmartPointer<vtkImageData>;

struct Panel
{
  Image Picture;
  std::string Caption;
};

/// Returns images of one size beside each other on white, each drawn `scale` times its size with
/// its caption below.
Image ComposePanels(const std::vector<Panel>& panels, double scale)
{
  constexpr int captionHeight = 36; // pixels
  constexpr int gap = 6;            // pixels
  const int* size = panels.front().Picture->GetDimensions();
  const auto width = static_cast<int>(std::lround(scale * size[0]));
  const int height = static_cast<int>(std::lround(scale * size[1])) + captionHeight;
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  int left = 0; // pixels
  for (const Panel& panel : panels)
  {
    vtkNew<vtkImageActor> actor;
    actor->GetMapper()->SetInputData(panel.Picture);
    actor->SetPosition(left / scale, 0.0, 0.0);
    renderer->AddActor(actor);
    vtkNew<vtkTextActor> caption;
    caption->SetInput(panel.Caption.c_str());
    caption->SetPosition(left + 0.5 * width, 0.5 * captionHeight);
    vtkTextProperty* font = caption->GetTextProperty();
    font->SetFontFamilyToArial();
    font->SetFontSize(18);
    font->SetColor(0.1, 0.1, 0.1);
    font->SetJustificationToCentered();
    font->SetVerticalJustificationToCentered();
    renderer->AddViewProp(caption);
    left += width + gap;
  }
  const int total = left - gap;
  // The unit of the world is a pixel of the images, whose pixels have their centres at 0, 1, 2, ...
  const double center[2] = { 0.5 * (total / scale - 1.0),
    0.5 * (size[1] - 1 - captionHeight / scale) };
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height / scale);
  camera->SetFocalPoint(center[0], center[1], 0.0);
  camera->SetPosition(center[0], center[1], 100.0);
  camera->SetClippingRange(1.0, 200.0);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(total, height);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}

struct Frame
{
  vtkSmartPointer<vtkUnsignedCharArray> Pixels;
  Image Picture;
  int Drawn = 0;
};

/// Renders a frame of the path in a mode, after the few frames before it, which the culler needs.
Frame RenderFrame(Session& session, const CameraPath& path, std::size_t frame, Mode& mode)
{
  mode.Enter(session.GetRenderer());
  for (std::size_t i = frame - std::min<std::size_t>(frame, 3); i <= frame; ++i)
  {
    session.SetPose(path[i]);
    session.Render();
  }
  Frame result;
  result.Pixels = session.ReadPixels();
  result.Picture = session.MakeImage(result.Pixels);
  result.Drawn = session.GetRenderer()->GetNumberOfPropsRendered();
  return result;
}

std::string Describe(const Frame& frame, const std::string& culler)
{
  return culler + ": " + std::to_string(frame.Drawn) + " props drawn";
}

/// Returns a level as an image. Colours (those of viridis) follow the logarithm of the distance
/// from the eye, from the nearest in level 0 (dark) to the farthest (light); where nothing was
/// drawn, the image is white. `range` has the distances of the clipping planes.
Image MakeLevelImage(vtkNBufferLevels& levels, int level, const double range[2])
{
  const vtkIdType texels = static_cast<vtkIdType>(levels.GetWidth()) * levels.GetHeight();
  const auto makeDistances = [&](int which)
  {
    vtkNew<vtkFloatArray> distances;
    distances->SetNumberOfValues(texels);
    for (vtkIdType i = 0; i < texels; ++i)
    {
      const double depth = levels.GetLevelData(which)[i];
      distances->SetValue(i,
        depth < 1.0 ? static_cast<float>(
                        std::log(range[0] * range[1] / (range[1] - depth * (range[1] - range[0]))))
                    : std::numeric_limits<float>::quiet_NaN());
    }
    return vtkSmartPointer<vtkFloatArray>(distances);
  };
  double logarithms[2];
  makeDistances(0)->GetFiniteRange(logarithms);
  // The ground reaches to the horizon, which would leave one colour for everything else.
  const double length = std::clamp(logarithms[1] - logarithms[0], std::log(2.0), std::log(300.0));
  constexpr double viridis[][3] = { { 0.267, 0.005, 0.329 }, { 0.254, 0.265, 0.530 },
    { 0.164, 0.471, 0.558 }, { 0.135, 0.659, 0.518 }, { 0.478, 0.821, 0.318 },
    { 0.993, 0.906, 0.144 } };
  vtkNew<vtkColorTransferFunction> colors;
  for (int i = 0; i < 6; ++i)
  {
    colors->AddRGBPoint(
      logarithms[0] + length * i / 5.0, viridis[i][0], viridis[i][1], viridis[i][2]);
  }
  colors->SetNanColor(1.0, 1.0, 1.0);
  auto image = Image::New();
  image->SetDimensions(levels.GetWidth(), levels.GetHeight(), 1);
  image->GetPointData()->SetScalars(vtkSmartPointer<vtkUnsignedCharArray>::Take(
    colors->MapScalars(makeDistances(level), VTK_COLOR_MODE_MAP_SCALARS, -1, VTK_RGB)));
  return image;
}

/// Writes level 0 of the depth of the frame that was rendered last, and two levels above.
void WriteLevels(Session& session, const std::string& folder)
{
  const int* size = session.GetWindow()->GetActualSize();
  vtkNew<vtkFloatArray> depth;
  session.GetWindow()->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depth);
  vtkNBufferLevels levels;
  levels.BuildBase(depth->GetPointer(0), size[0], size[1], 1, vtkNBufferExtremum::Maximum);
  const std::vector<int> which = { 0, 4, 6 };
  levels.BuildLevels(which.back() + 1);
  if (levels.GetNumberOfLevels() <= which.back())
  {
    throw std::runtime_error("the image is too small for the pictures of the levels");
  }
  double range[2];
  session.GetRenderer()->GetActiveCamera()->GetClippingRange(range);
  std::vector<Panel> panels;
  for (int level : which)
  {
    const std::string side = std::to_string(1 << level);
    const std::string name = "level " + std::to_string(level);
    panels.push_back({ MakeLevelImage(levels, level, range),
      level == 0 ? name + ": the depth" : name + ": farthest in " + side + " x " + side });
  }
  WritePNG(ComposePanels(panels, 0.5), folder + "/levels.png");
}

int RunPictures(const ViewOptions& view, const std::string& folder)
{
  MakeFolder(folder);
  const Scene scene = view.LoadScene();
  const CameraPath path = view.MakePath(scene, 120);
  Session& session = Session::New(scene, view.Window);
  session.GetRenderer()->SetBackground(0.86, 0.91, 0.96);
  session.GetRenderer()->SetBackground2(0.45, 0.65, 0.88);
  session.GetRenderer()->GradientBackgroundOn();
  const std::size_t middle = path.size() / 2;
  Mode stock("stock");
  Mode nbuffer("nbuffer", view.Backend);
  const Frame without = RenderFrame(session, path, middle, stock);
  const Frame with = RenderFrame(session, path, middle, nbuffer);
  const vtkIdType bytes = without.Pixels->GetNumberOfValues();
  const bool same = bytes == with.Pixels->GetNumberOfValues() &&
    std::equal(
      without.Pixels->GetPointer(0), without.Pixels->GetPointer(bytes), with.Pixels->GetPointer(0));
  WritePNG(without.Picture, folder + "/frame-stock.png");
  WritePNG(with.Picture, folder + "/frame-nbuffer.png");
  WritePNG(ComposePanels({ { without.Picture, Describe(without, "VTK's default culler") },
                           { with.Picture, Describe(with, "vtkNBufferCuller") } },
             0.6),
    folder + "/frames.png");
  std::cout << Describe(without, "stock") << ", " << Describe(with, "nbuffer")
            << ", the images are " << (same ? "the same" : "NOT THE SAME") << "\n";
  const vtkNBufferStatistics statistics = nbuffer.GetNBufferCuller()->GetStatistics();
  const std::string hierarchy = DescribeHierarchy(statistics);
  std::cout << hierarchy << (hierarchy.empty() ? "" : "\n");

  WriteLevels(session, folder);

  std::vector<vtkNBufferVerdict> verdicts;
  for (vtkActor* actor : scene.Actors)
  {
    verdicts.push_back(nbuffer.GetNBufferCuller()->GetVerdict(actor));
  }
  // Far enough to see what the first rows of houses hide.
  const double reach = scene.Plan ? 420.0 : 0.5 * scene.GetBounds().GetDiagonalLength();
  WritePNG(MakeVerdictPicture(session, scene, verdicts, statistics, path[middle], reach),
    folder + "/culled.png");
  return same ? Success : ImagesDiffer;
}
}

void AddPicturesCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("pictures",
    "Draw what the culler does: the same frame with and without it, what is drawn and culled from "
    "above, and levels of the N-buffer");
  auto view = std::make_shared<ViewOptions>();
  auto folder = std::make_shared<std::string>();
  view->AddTo(*command, program);
  view->AddCullerTo(*command);
  command->add_option("--out", *folder, "Folder for the pictures")->required();
  command->callback(
    [view, folder, &run]() { run = [view, folder]() { return RunPictures(*view, *folder); }; });
}

} // namespace NBufferBench
