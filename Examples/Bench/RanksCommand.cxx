// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RanksCommand.cxx
 * @brief The subcommand ranks, which simulates parallel programs of many ranks.
 */
#include "Command.h"
#include "Ranks.h"
#include "Report.h"
#include "Spread.h"
#include "VisibleProps.h"

#include <iostream>
#include <memory>
#include <set>

namespace NBufferBench
{
namespace
{
struct RanksOptions
{
  ViewOptions View;
  std::vector<int> Ranks = { 1, 4, 16 };
  std::string Spread = "kd";
  int TileSize = 4;
  bool Mask = false;
  bool Merge = false;
  std::string JSON;
};

int RunRanksCommand(RanksOptions& options)
{
  CheckWritable(options.JSON);
  const NBufferExamples::Scene scene = options.View.LoadScene();
  const NBufferExamples::CameraPath path = options.View.MakePath(scene, 1);
  Session& session = Session::New(scene, options.View.Window);
  const std::vector<int> pixels = FindPixelOwners(session, path.back());
  std::set<int> owners(pixels.begin(), pixels.end());
  owners.erase(-1); // The background.
  Json::Value report;
  options.View.Describe(scene, session, report);
  report["spread"] = options.Spread;
  report["tile"] = options.TileSize;
  report["mask"] = options.Mask;
  report["merged_ranks"] = options.Merge;
  report["own_a_pixel"] = static_cast<int>(owners.size());
  std::cout << owners.size() << " props own a pixel\n";
  int errors = 0;
  for (int ranks : options.Ranks)
  {
    const RankCounts counts = SimulateRanks(session, path.back(), ranks,
      NBufferExamples::SpreadActors(scene, options.Spread, ranks),
      std::vector<int>(owners.begin(), owners.end()), options.TileSize, options.Mask,
      options.Merge);
    Json::Value& entry = report["ranks"][std::to_string(ranks)];
    entry["drawn_local"] = counts.Local;
    entry["drawn_shared"] = counts.Shared;
    entry["busiest"] = counts.Busiest;
    entry["idle"] = counts.Idle;
    entry["bytes"] = static_cast<Json::Int64>(counts.Bytes);
    entry["visible_hidden"] = counts.VisibleHidden;
    errors += counts.VisibleHidden;
    std::cout << ranks << " ranks: " << counts.Local << (options.Merge ? " units" : " props")
              << " drawn by their own depth, " << counts.Shared << " by that of all ("
              << counts.Busiest << " by one rank, " << counts.Idle << " ranks draw none), "
              << counts.Bytes << " bytes, " << counts.VisibleHidden << " visible props hidden"
              << std::endl;
  }
  WriteJSON(report, options.JSON);
  return errors == 0 ? Success : ImagesDiffer;
}
}

void AddRanksCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("ranks",
    "Spread the scene over ranks of a parallel program, simulated one after the other, and count "
    "what their cullers draw in the last frame of the path");
  auto options = std::make_shared<RanksOptions>();
  options->View.AddTo(*command, program);
  command->add_option("--ranks", options->Ranks, "Numbers of ranks, separated by commas")
    ->delimiter(',')
    ->check(CLI::Range(1, 100000));
  command->add_option("--spread", options->Spread, "How props belong to ranks")
    ->check(CLI::IsMember({ "kd", "random" }));
  command->add_option("--tile", options->TileSize, "The side of a tile in pixels")
    ->check(CLI::IsMember({ 1, 2, 4, 8 }));
  command->add_flag("--mask", options->Mask,
    "Tiles of 4 x 4 pixels with a mask of the nearer ones, which no exchange sends");
  command->add_flag("--merge-ranks", options->Merge,
    "The props of each rank are one mesh, of which units are counted");
  command->add_option("--json", options->JSON, "File for the figures");
  command->callback([options, &run]() { run = [options]() { return RunRanksCommand(*options); }; });
}

} // namespace NBufferBench
