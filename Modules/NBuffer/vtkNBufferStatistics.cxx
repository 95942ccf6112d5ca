// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferStatistics.h"

#include "vtkNBufferJSON.h"

VTK_ABI_NAMESPACE_BEGIN
const char* vtkNBufferStatistics::GetName(vtkNBufferVerdict verdict)
{
  switch (verdict)
  {
    case vtkNBufferVerdict::Unknown:
      return "Unknown";
    case vtkNBufferVerdict::Outside:
      return "Outside";
    case vtkNBufferVerdict::Hidden:
      return "Hidden";
    case vtkNBufferVerdict::Visible:
      return "Visible";
    case vtkNBufferVerdict::NearPlane:
      return "NearPlane";
    case vtkNBufferVerdict::Untested:
      return "Untested";
    case vtkNBufferVerdict::NotAPlainActor:
      return "NotAPlainActor";
    case vtkNBufferVerdict::NotAPlainMapper:
      return "NotAPlainMapper";
    case vtkNBufferVerdict::Translucent:
      return "Translucent";
    case vtkNBufferVerdict::NotASurface:
      return "NotASurface";
    case vtkNBufferVerdict::DepthOffset:
      return "DepthOffset";
    case vtkNBufferVerdict::ShaderReplaced:
      return "ShaderReplaced";
    case vtkNBufferVerdict::OtherCoordinates:
      return "OtherCoordinates";
    case vtkNBufferVerdict::NoBounds:
      return "NoBounds";
    case vtkNBufferVerdict::NumberOfVerdicts:
      break;
  }
  return "Invalid";
}

const char* vtkNBufferStatistics::GetName(vtkNBufferDecision decision)
{
  switch (decision)
  {
    case vtkNBufferDecision::None:
      return "None";
    case vtkNBufferDecision::Culled:
      return "Culled";
    case vtkNBufferDecision::Still:
      return "Still";
    case vtkNBufferDecision::Frozen:
      return "Frozen";
    case vtkNBufferDecision::NothingHeld:
      return "NothingHeld";
    case vtkNBufferDecision::FewCandidates:
      return "FewCandidates";
    case vtkNBufferDecision::BackedOff:
      return "BackedOff";
    case vtkNBufferDecision::Disabled:
      return "Disabled";
    case vtkNBufferDecision::Selecting:
      return "Selecting";
    case vtkNBufferDecision::Shadows:
      return "Shadows";
    case vtkNBufferDecision::RenderPass:
      return "RenderPass";
    case vtkNBufferDecision::HiddenLines:
      return "HiddenLines";
    case vtkNBufferDecision::Exporting:
      return "Exporting";
    case vtkNBufferDecision::Delegated:
      return "Delegated";
    case vtkNBufferDecision::UnsupportedWindow:
      return "UnsupportedWindow";
    case vtkNBufferDecision::OtherCuller:
      return "OtherCuller";
    case vtkNBufferDecision::Blending:
      return "Blending";
    case vtkNBufferDecision::OtherView:
      return "OtherView";
    case vtkNBufferDecision::NoContext:
      return "NoContext";
    case vtkNBufferDecision::OldContext:
      return "OldContext";
    case vtkNBufferDecision::NoFloatTextures:
      return "NoFloatTextures";
    case vtkNBufferDecision::NoDepth:
      return "NoDepth";
    case vtkNBufferDecision::NumberOfDecisions:
      break;
  }
  return "Invalid";
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
