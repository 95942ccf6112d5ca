// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nbuffer-view.cxx
 * @brief `nbuffer-view FILE...`: a file of the user's own in a window, with and without the culler.
 */
#include "FileFormats.h"
#include "Frames.h"
#include "LoadScene.h"
#include "SizeOption.h"
#include "Viewer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace
{
/// Exit codes. Wrong options end with a code of CLI11, above 100.
enum ExitCode
{
  Success = 0,
  Failure = 1,     ///< An error; its message went to stderr.
  ImagesDiffer = 2 ///< A verification in --keys found bytes that differ.
};

struct Options
{
  std::vector<std::string> Files;
  std::string Picture;
  std::string Keys;
  std::array<int, 2> Size = { 1280, 800 };
  bool Whole = false;
  int Up = -1; ///< -1: as is usual in files of this kind.
};

/// Formats with a description have a line each; those that are read by one library share some.
std::string DescribeFormats()
{
  constexpr std::size_t column = 13;
  constexpr std::size_t width = 90;
  std::map<std::string, std::string> endings; // By the description.
  for (const NBufferExamples::FileFormat& format : NBufferExamples::GetFileFormats())
  {
    std::string& list = endings[format.Kind];
    const std::size_t line = list.rfind('\n') == std::string::npos ? 0 : list.rfind('\n') + 1;
    const bool isFull = list.size() - line + format.Ending.size() > width;
    list += (list.empty() ? "  " : isFull ? "\n  " : " ") + format.Ending;
  }
  std::string text;
  for (auto& [kind, list] : endings)
  {
    const bool isLong = list.size() > 4 * column;
    if (!isLong)
    {
      list.resize(std::max(list.size() + 2, 2 * column), ' ');
    }
    text += isLong ? "  " + kind + ":\n" + list + "\n" : list + kind + "\n";
  }
  return text;
}

std::string MakeFooter()
{
  NBufferView::Keys keys;
  NBufferView::Viewer::AddKeys(keys, nullptr);
  std::string text = "Keys in the window, and words of --keys:\n\n" + keys.Describe() + "\n\n";
  text +=
    "  --keys also knows the pointer: @x,y moves it there, which shows the name of the part;\n"
    "  @x,y>x,y drags with the left button. Places are pixels from the lower left corner.\n\n"
    "Files that this build reads, each also compressed (.gz) except for boards:\n\n";
  return text + DescribeFormats() +
    "\nInstead of a file: city and plant, two scenes that come with the program.\n"
    "Several files make one scene if they are of: " +
    NBufferExamples::ListEndings(true);
}

int Show(const Options& options, const char* program)
{
  NBufferExamples::CheckWritable(options.Picture);
  NBufferExamples::SceneOptions sceneOptions;
  sceneOptions.Program = program;
  sceneOptions.SplitRegions = !options.Whole;
  sceneOptions.Progress = [](const std::string& text) { std::cout << text << std::endl; };
  NBufferExamples::Scene scene = NBufferExamples::LoadScene(options.Files, sceneOptions);
  scene.UpAxis = options.Up >= 0 ? options.Up : scene.UpAxis;

  // It lives until the process ends: VTK searches the buffers of all props for each prop that is
  // destroyed, which takes seconds for a city.
  auto& viewer = *new NBufferView::Viewer(scene, options.Size, options.Picture.empty());
  viewer.Play(options.Keys);
  if (options.Picture.empty())
  {
    viewer.Run();
  }
  else
  {
    viewer.WritePicture(options.Picture);
  }
  std::cout.flush();
  return viewer.GetDifferingBytes() == 0 ? Success : ImagesDiffer;
}
}

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Shows files in a window, without what is hidden in them");
  app.footer(MakeFooter());
  app.add_option("FILE", options.Files, "The file, or several that go together")->required();
  app.add_option(
    "--offscreen", options.Picture, "Write a picture (PNG) to this file; no window is opened");
  app.add_option("--keys", options.Keys, "Keys to press at first, such as \"c s Up Up v\"");
  NBufferExamples::AddSizeOption(app, options.Size, "Of the window, in pixels");
  app.add_flag("--whole", options.Whole,
    "A file with one mesh stays one part, instead of one for each connected region");
  app.add_option("--up", options.Up, "The axis that points up: x, y or z; default: by the format")
    ->transform(
      CLI::CheckedTransformer(std::map<std::string, int>{ { "x", 0 }, { "y", 1 }, { "z", 2 } }));
  try
  {
    app.parse(argc, argv);
    return Show(options, argv[0]);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error);
  }
  catch (const std::exception& error)
  {
    std::cerr << "nbuffer-view: " << error.what() << "\n";
    return Failure;
  }
}
