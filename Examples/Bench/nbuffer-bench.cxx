// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nbuffer-bench.cxx
 * @brief Measures and verifies vtkNBufferCuller and vtkShadowVolumeClampPass on any scene; each
 * subcommand is a file.
 */
#include "Command.h"

#include <exception>
#include <iostream>

int main(int argc, char* argv[])
{
  CLI::App app("Measure and verify occlusion culling and shadows with N-buffers");
  app.set_version_flag("--version", NBUFFER_VERSION);
  app.require_subcommand(1);
  NBufferBench::Run run;
  NBufferBench::AddWalkCommand(app, argv[0], run);
  NBufferBench::AddFillCommand(app, argv[0], run);
  NBufferBench::AddFirstCommand(app, argv[0], run);
  NBufferBench::AddPicturesCommand(app, argv[0], run);
  NBufferBench::AddRanksCommand(app, argv[0], run);
  NBufferBench::AddShadowCommand(app, argv[0], run);
  NBufferBench::AddStudyCommand(app, argv[0], run);
  NBufferBench::AddVolumesCommand(app, argv[0], run);
  NBufferBench::AddDefaultsCommand(app, run);
  CLI11_PARSE(app, argc, argv);
  try
  {
    return run();
  }
  catch (const std::exception& error)
  {
    std::cerr << "nbuffer-bench: " << error.what() << "\n";
    return NBufferBench::Failure;
  }
}
