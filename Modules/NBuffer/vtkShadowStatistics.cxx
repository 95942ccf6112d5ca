// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowStatistics.h"

#include "vtkNBufferJSON.h"

#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr const char* ShadowVerdictNames[] = { "Whole", "Boxed", "Clamped", "ThroughLightPlane",
  "NoReceiver", "BeforeCaster", "BehindLight", "OutsideCone", "Empty" };
static_assert(std::size(ShadowVerdictNames) == vtkShadowStatistics::NumberOfVerdicts);

constexpr const char* SkipNames[] = { "NotAnActor", "NotASurface", "Translucent",
  "NotAPlainMapper" };
static_assert(std::size(SkipNames) == NumberOfShadowSkips);

constexpr const char* ShadowDecisionNames[] = { "None", "Drawn", "Still", "NoLight", "NoCaster",
  "NoReceiver", "Failed" };
static_assert(std::size(ShadowDecisionNames) == int(vtkShadowDecision::NumberOfDecisions));

constexpr const char* StageNames[] = { "depth", "draw", "color" };
static_assert(std::size(StageNames) == NumberOfShadowStages);
}

const char* vtkShadowStatistics::GetName(vtkShadowVerdict verdict)
{
  return vtkNBufferJSON::GetName(ShadowVerdictNames, verdict);
}

const char* vtkShadowStatistics::GetName(vtkShadowSkip reason)
{
  return vtkNBufferJSON::GetName(SkipNames, reason);
}

const char* vtkShadowStatistics::GetName(vtkShadowDecision decision)
{
  return vtkNBufferJSON::GetName(ShadowDecisionNames, decision);
}

const char* vtkShadowStatistics::GetName(vtkShadowStage stage)
{
  return vtkNBufferJSON::GetName(StageNames, stage);
}

std::string vtkShadowStatistics::GetAsJSON() const
{
  Json::Value json(Json::objectValue);
  json["decision"] = GetName(this->Decision);
  json["lights"] = this->Lights;
  json["casters"] = this->Casters;
  json["verdicts"] = vtkNBufferJSON::ByName<vtkShadowVerdict>(this->Verdicts, GetName);
  json["skipped"] = vtkNBufferJSON::ByName<vtkShadowSkip>(this->Skipped, GetName);
  json["updates"] = this->Updates;
  json["silhouettes"] = this->Silhouettes;
  json["pieces"] = this->Pieces;
  json["draws"] = this->Draws;
  json["z_pass"] = this->ZPass;
  json["boxes"] = this->Boxes;
  json["stencil_clears"] = this->StencilClears;
  json["slabs"] = this->Slabs;
  json["triangles"] = static_cast<Json::Int64>(this->Triangles);
  json["receivers"] = static_cast<Json::Int64>(this->Receivers);
  json["fragments"] = static_cast<Json::Int64>(this->Fragments);
  json["litmaps"] = this->Litmaps;
  json["unclamped_lights"] = this->UnclampedLights;
  Json::Value& lights = json["light_costs"] = Json::Value(Json::arrayValue);
  for (const vtkShadowLightCost& cost : this->LightCosts)
  {
    Json::Value light;
    light["has_litmaps"] = cost.HasLitmaps;
    light["whole_estimate"] = cost.WholeEstimate;
    light["litmap_estimate"] = cost.LitmapEstimate;
    light["time"] = cost.Time;
    lights.append(light);
  }
  json["read_backs"] = this->ReadBacks;
  json["failed_frames"] = this->FailedFrames;
  json["debug_draws"] = this->DebugDraws;
  json["samples"] = this->Samples;
  json["pixel_frames"] = this->PixelFrames;
  Json::Value& times = json["milliseconds"];
  times["casters"] = this->CasterTime;
  times["depth"] = this->DepthTime;
  times["read"] = this->ReadTime;
  times["litmaps"] = this->LitmapTime;
  times["plan"] = this->PlanTime;
  times["draw"] = this->DrawTime;
  times["measure"] = this->MeasureTime;
  json["device_milliseconds"] = vtkNBufferJSON::ByName<vtkShadowStage>(this->DeviceTimes, GetName);
  return vtkNBufferJSON::Write(json);
}
VTK_ABI_NAMESPACE_END
