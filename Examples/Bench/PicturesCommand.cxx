// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PicturesCommand.cxx
 * @brief The subcommand pictures: images that show what the culler does; the README shows them.
 */
#include "Command.h"
#include "LevelPicture.h"
#include "Panels.h"
#include "VerdictPicture.h"

#include "vtkCamera.h"
#include "vtkNBufferLevels.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::Scene;
using Image = vtkSmartPointer<vtkImageData>;

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

/// Writes level 0 of the depth of the frame that was rendered last, and two levels above.
void WriteLevels(Session& session, const std::string& folder)
{
  vtkNBufferLevels levels;
  const std::vector<int> which = { 0, 4, 6 };
  NBufferExamples::ReadLevels(session.GetWindow(), which.back() + 1, levels);
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
    panels.push_back({ NBufferExamples::MakeLevelImage(levels, level, range),
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
  const bool same = NBufferExamples::CountDifferingBytes(without.Pixels, with.Pixels) == 0;
  WritePNG(without.Picture, folder + "/frame-stock.png");
  WritePNG(with.Picture, folder + "/frame-nbuffer.png");
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
