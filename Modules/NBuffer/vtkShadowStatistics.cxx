// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowStatistics.h"

#include "vtkNBufferJSON.h"

VTK_ABI_NAMESPACE_BEGIN
const char* vtkShadowStatistics::GetName(vtkShadowVerdict verdict)
{
  switch (verdict)
  {
    case vtkShadowVerdict::Whole:
      return "Whole";
    case vtkShadowVerdict::Boxed:
      return "Boxed";
    case vtkShadowVerdict::Clamped:
      return "Clamped";
    case vtkShadowVerdict::ThroughLightPlane:
      return "ThroughLightPlane";
    case vtkShadowVerdict::NoReceiver:
      return "NoReceiver";
    case vtkShadowVerdict::BeforeCaster:
      return "BeforeCaster";
    case vtkShadowVerdict::BehindLight:
      return "BehindLight";
    case vtkShadowVerdict::OutsideCone:
      return "OutsideCone";
    case vtkShadowVerdict::Empty:
      return "Empty";
    case vtkShadowVerdict::NumberOfVerdicts:
      break;
  }
  return "Invalid";
}

const char* vtkShadowStatistics::GetName(vtkShadowSkip reason)
{
  switch (reason)
  {
    case vtkShadowSkip::NotAnActor:
      return "NotAnActor";
    case vtkShadowSkip::NotASurface:
      return "NotASurface";
    case vtkShadowSkip::Translucent:
      return "Translucent";
    case vtkShadowSkip::NotAPlainMapper:
      return "NotAPlainMapper";
    case vtkShadowSkip::NumberOfSkips:
      break;
  }
  return "Invalid";
}

const char* vtkShadowStatistics::GetName(vtkShadowDecision decision)
{
  switch (decision)
  {
    case vtkShadowDecision::None:
      return "None";
    case vtkShadowDecision::Drawn:
      return "Drawn";
    case vtkShadowDecision::Still:
      return "Still";
    case vtkShadowDecision::NoLight:
      return "NoLight";
    case vtkShadowDecision::NoCaster:
      return "NoCaster";
    case vtkShadowDecision::NoReceiver:
      return "NoReceiver";
    case vtkShadowDecision::Failed:
      return "Failed";
    case vtkShadowDecision::NumberOfDecisions:
      break;
  }
  return "Invalid";
}

const char* vtkShadowStatistics::GetName(vtkShadowStage stage)
{
  switch (stage)
  {
    case vtkShadowStage::Depth:
      return "depth";
    case vtkShadowStage::Draw:
      return "draw";
    case vtkShadowStage::Color:
      return "color";
    case vtkShadowStage::NumberOfStages:
      break;
  }
  return "Invalid";
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
  json["device_milliseconds"] = vtkNBufferJSON::ByName<vtkShadowStage>(this->DeviceTimes, GetName);
  return vtkNBufferJSON::Write(json);
}
VTK_ABI_NAMESPACE_END
