// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PicturesCommand.cxx
 * @brief The pictures that show what the culler does; the README shows them.
 */
#include "Chart.h"
#include "Command.h"
#include "Images.h"
#include "LevelImages.h"
#include "Panels.h"
#include "Report.h"
#include "VerdictPicture.h"
#include "Walk.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNBufferLevels.h"

#include <algorithm>
#include <cstring>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::CameraPose;
using NBufferExamples::Scene;

struct PicturesOptions
{
  ViewOptions View;
  std::string Folder;
  bool Chart = true;
};

struct Frame
{
  vtkSmartPointer<vtkUnsignedCharArray> Pixels;
  vtkSmartPointer<vtkImageData> Image;
  int Drawn = 0;
};

/// A frame of the path in a mode, with the few frames before it so that the culler is in swing.
Frame RenderFrame(Session& session, const CameraPath& path, std::size_t frame, Mode& mode)
{
  mode.Enter(session.GetRenderer());
  for (std::size_t i = frame - std::min<std::size_t>(frame, 3); i <= frame; ++i)
  {
    session.SetPose(path[i]);
    session.Render();
  }
  Frame result;
  result.Pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  session.ReadPixels(result.Pixels);
  const int* size = session.GetWindow()->GetActualSize();
  result.Image = MakeImage(result.Pixels, size[0], size[1]);
  result.Drawn = session.GetRenderer()->GetNumberOfPropsRendered();
  return result;
}

std::string Describe(const Frame& frame, const std::string& culler)
{
  return culler + ": " + std::to_string(frame.Drawn) + " props drawn";
}

/// Level 0 of the depth of the frame rendered last, and two levels above.
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
  const std::vector<vtkSmartPointer<vtkImageData>> images =
    MakeLevelImages(levels, which, range[0], range[1]);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < which.size(); ++i)
  {
    const std::string side = std::to_string(1 << which[i]);
    WritePNG(images[i], folder + "/level-" + std::to_string(which[i]) + ".png");
    panels.push_back({ images[i],
      which[i] == 0
        ? "level 0: the depth"
        : "level " + std::to_string(which[i]) + ": farthest in " + side + " x " + side });
  }
  WritePNG(ComposePanels(panels, 0.5), folder + "/levels.png");
}

double GetReach(const Scene& scene)
{
  // Far enough to see what the first rows of houses hide.
  return scene.Plan ? 420.0 : 0.5 * scene.GetBounds().GetDiagonalLength();
}

int RunPictures(PicturesOptions& options)
{
  MakeFolder(options.Folder);
  const Scene scene = options.View.LoadScene();
  const CameraPath path = options.View.MakePath(scene, 120);
  Session& session = Session::New(scene, options.View.Window);

  // Measured first: everything after it recolours the scene.
  if (options.Chart)
  {
    WalkOptions walk;
    walk.Mode = options.View.Mode;
    walk.Progress = ShowProgress;
    const WalkResult result = RunWalk(session, path, walk);
    WriteChart(result, scene.Name + ", " + options.View.GetPathName(scene) + " walk",
      options.Folder + "/frame-times");
    PrintTable(MakeReport(result), std::cout);
  }

  session.GetRenderer()->SetBackground(0.86, 0.91, 0.96);
  session.GetRenderer()->SetBackground2(0.45, 0.65, 0.88);
  session.GetRenderer()->GradientBackgroundOn();
  const std::size_t middle = path.size() / 2;
  Mode stock("stock", options.View.Mode);
  Mode nbuffer("nbuffer", options.View.Mode);
  const Frame without = RenderFrame(session, path, middle, stock);
  const Frame with = RenderFrame(session, path, middle, nbuffer);
  const vtkIdType bytes = without.Pixels->GetNumberOfValues();
  const bool same = bytes == with.Pixels->GetNumberOfValues() &&
    std::memcmp(without.Pixels->GetPointer(0), with.Pixels->GetPointer(0),
      static_cast<std::size_t>(bytes)) == 0;
  WritePNG(without.Image, options.Folder + "/frame-stock.png");
  WritePNG(with.Image, options.Folder + "/frame-nbuffer.png");
  WritePNG(ComposePanels({ { without.Image, Describe(without, "VTK's default culler") },
                           { with.Image, Describe(with, "vtkNBufferCuller") } },
             0.6),
    options.Folder + "/frames.png");
  std::cout << Describe(without, "stock") << ", " << Describe(with, "nbuffer")
            << ", the images are " << (same ? "the same" : "NOT THE SAME") << "\n";
  const vtkNBufferStatistics statistics = nbuffer.GetNBufferCuller()->GetStatistics();
  const std::string hierarchy = DescribeHierarchy(statistics);
  std::cout << hierarchy << (hierarchy.empty() ? "" : "\n");

  WriteLevels(session, options.Folder);

  std::vector<vtkNBufferVerdict> verdicts;
  for (vtkActor* actor : scene.Actors)
  {
    verdicts.push_back(nbuffer.GetNBufferCuller()->GetVerdict(actor));
  }
  WritePNG(MakeVerdictPicture(session, scene, verdicts, statistics, path[middle], GetReach(scene)),
    options.Folder + "/culled.png");
  return same ? Success : ImagesDiffer;
}
}

void AddPicturesCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("pictures",
    "Draw what the culler does: the same frame with and without it, what is drawn and culled from "
    "above, levels of the N-buffer, a chart of frame times");
  auto options = std::make_shared<PicturesOptions>();
  options->View.Program = program;
  options->View.AddTo(*command);
  options->View.AddCullerTo(*command);
  command->add_option("--out", options->Folder, "Folder for the pictures")->required();
  command->add_flag(
    "--chart,!--no-chart", options->Chart, "Measure a walk and draw its frame times");
  command->callback([options, &run]() { run = [options]() { return RunPictures(*options); }; });
}

} // namespace NBufferBench
