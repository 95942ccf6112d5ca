// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferStatistics.h"

#include "vtkNBufferJSON.h"

#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr const char* VerdictNames[] = { "Unknown", "Outside", "Hidden", "Visible", "NearPlane",
  "Untested", "NotAPlainActor", "NotAPlainMapper", "Translucent", "NotASurface", "DepthOffset",
  "ShaderReplaced", "OtherCoordinates", "NoBounds", "SharedMapper", "Blended" };
static_assert(std::size(VerdictNames) == vtkNBufferStatistics::NumberOfVerdicts);

constexpr const char* DecisionNames[] = { "None", "Culled", "Still", "Frozen", "NothingHeld",
  "FewCandidates", "BackedOff", "Disabled", "Selecting", "Shadows", "RenderPass", "HiddenLines",
  "Exporting", "Delegated", "UnsupportedWindow", "OtherCuller", "Blending", "OtherView",
  "NoContext", "OldContext", "NoFloatTextures", "NoDepth" };
static_assert(std::size(DecisionNames) == int(vtkNBufferDecision::NumberOfDecisions));
}

const char* vtkNBufferStatistics::GetName(vtkNBufferVerdict verdict)
{
  return vtkNBufferJSON::GetName(VerdictNames, verdict);
}

const char* vtkNBufferStatistics::GetName(vtkNBufferDecision decision)
{
  return vtkNBufferJSON::GetName(DecisionNames, decision);
}

std::string vtkNBufferStatistics::GetAsJSON() const
{
  Json::Value json(Json::objectValue);
  json["decision"] = GetName(this->Decision);
  json["props"] = this->Props;
  json["drawn"] = this->GetNumberOfPropsDrawn();
  json["candidates"] = this->Candidates;
  json["tested"] = this->Tested;
  json["passed_coarse_test"] = this->PassedCoarseTest;
  json["held_back"] = this->HeldBack;
  json["redrawn"] = this->Redrawn;
  json["refreshed"] = this->Refreshed;
  json["failed_frames"] = this->FailedFrames;
  json["verdicts"] = vtkNBufferJSON::ByName<vtkNBufferVerdict>(this->Verdicts, GetName);
  json["rounds"] = this->Rounds;
  for (int drawn : this->DrawnInRound)
  {
    json["drawn_in_round"].append(drawn);
  }
  json["levels"] = this->Levels;
  json["texels"] = static_cast<Json::Int64>(this->Texels);
  json["queries"] = static_cast<Json::Int64>(this->Queries);
  json["lookups"] = static_cast<Json::Int64>(this->Lookups);
  json["read_backs"] = this->ReadBacks;
  json["bytes_read"] = static_cast<Json::Int64>(this->BytesRead);
  json["hidden_by_triangles"] = this->HiddenByTriangles;
  json["units"] = this->Units;
  json["units_outside"] = this->UnitsOutside;
  json["units_kept"] = this->UnitsKept;
  json["units_fresh"] = this->UnitsFresh;
  json["units_hidden"] = this->UnitsHidden;
  json["units_on_device"] = this->UnitsOnDevice;
  json["fresh_draws"] = this->FreshDraws;
  json["tie_queries"] = this->TieQueries;
  json["slivers"] = this->Slivers;
  json["nodes"] = static_cast<Json::Int64>(this->Nodes);
  json["refits"] = this->Refits;
  json["builds"] = this->Builds;
  Json::Value& times = json["milliseconds"];
  times["cull"] = this->CullTime;
  times["refresh"] = this->RefreshTime;
  times["frustum"] = this->FrustumTime;
  times["read"] = this->ReadTime;
  times["build"] = this->BuildTime;
  times["test"] = this->TestTime;
  times["pixel_test"] = this->PixelTestTime;
  times["sliver_test"] = this->SliverTestTime;
  times["draw"] = this->DrawTime;
  times["device_build"] = this->DeviceBuildTime;
  return vtkNBufferJSON::Write(json);
}
VTK_ABI_NAMESPACE_END
