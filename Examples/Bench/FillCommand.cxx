// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FillCommand.cxx
 * @brief The subcommand fill: the fragments of shadow volumes from the paper's method to the
 * module's, one step at a time, and with receivers left out that a caster need not draw for.
 */
#include "Command.h"
#include "Report.h"
#include "ShadowScene.h"
#include "Tune.h"
#include "VisibleProps.h"
#include "VolumeStudy.h"

#include "RayOracle.h"
#include "RerenderedLitmap.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkShadowVolumeClampPass.h"

#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <set>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::CameraPose;

struct FillOptions
{
  ViewOptions View;
  std::vector<double> Lamp;
  std::vector<int> Litmaps = { 64, 256, 1024 };
  bool GroundCasts = false;
  bool Own = false;
  bool Spread = false;
  bool Spot = false;
  std::string JSON;
};

/// What the ways whose receivers are chosen need to know about each pixel of a frame.
struct PixelFacts
{
  CasterPixels Owner;          ///< The caster that the pixel shows.
  CasterPixels OwnerConvex;    ///< The same, if it is proven to be convex.
  CasterPixels OwnerConvexLit; ///< The same, if the surface there faces the light, too.
  CasterPixels Nearest; ///< The caster that a ray from the pixel's place to the light meets first.
  std::vector<bool> IsCertain;  ///< Whether rounding does not decide about the shadow there.
  std::vector<bool> IsShadowed; ///< Whether it is in shadow by rays, if the light may reach it.
  std::vector<bool> IsReached;  ///< Whether the light reaches it if nothing shadows it.
  std::vector<bool> IsShown;    ///< Whether shadows change the pixel of the image.
};

class FillStudy
{
public:
  FillStudy(Session& session, vtkLight* light, vtkInformation* keys, const FillOptions& options)
    : Where(session)
    , Light(light)
    , Volumes(session, keys)
    , Options(options)
  {
    this->Pass->SetCasterKeys(keys);
    for (int i = 0; i < this->Volumes.GetNumberOfCasters(); ++i)
    {
      this->IsConvex.push_back(options.Own && this->Volumes.IsConvex(i));
    }
  }

  Json::Value Run(const CameraPath& path)
  {
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      ShowProgress("fill, frame " + std::to_string(i + 1) + " of " + std::to_string(path.size()));
      this->CountPass(path[i]);
      const PixelFacts facts = this->FindFacts(path[i]);
      this->Volumes.Run(path[i], [&]() { this->CountFrame(facts); });
    }
    const double frames = static_cast<double>(path.size());
    for (Json::Value& way : this->Ways)
    {
      for (const char* count : { "fragments", "drawn", "pieces" })
      {
        way[count] = Round(way[count].asDouble() / frames);
      }
    }
    for (Json::Value& way : this->Ways)
    {
      for (const char* whole : { "whole", "reach" })
      {
        const double all = this->Ways[this->Numbers.at(whole)]["fragments"].asDouble();
        way["percent_of_" + std::string(whole)] =
          Round(all > 0.0 ? 100.0 * way["fragments"].asDouble() / all : 0.0);
      }
    }
    Json::Value report;
    report["ways"] = this->Ways;
    report["frames"] = static_cast<Json::UInt64>(path.size());
    report["casters"] = this->Volumes.GetNumberOfCasters();
    report["lost"] = static_cast<Json::Int64>(this->Lost);
    report["differing_ways"] = this->Differing;
    report["scatter_ms"] = Summarize(this->ScatterTimes);
    report["levels_ms"] = Summarize(this->LevelsTimes);
    return report;
  }

private:
  /// The ways that the pass has, too, by their names here.
  struct PassWay
  {
    const char* Name;
    int Mode;
    int SlabGap;
  };
  static constexpr PassWay PassWays[] = { { "whole", vtkShadowVolumeClampPass::Unclamped, 4 },
    { "exact", vtkShadowVolumeClampPass::Scissored, 4 },
    { "one slab", vtkShadowVolumeClampPass::Clamped, 64 },
    { "slabs", vtkShadowVolumeClampPass::Clamped, 4 } };

  void CountPass(const CameraPose& pose)
  {
    this->Where.GetRenderer()->SetPass(this->Pass);
    Tune(this->Pass.Get(), &vtkShadowTuning::CountFragments, true);
    for (const PassWay& way : PassWays)
    {
      this->Pass->SetMode(way.Mode);
      Tune(this->Pass.Get(), &vtkShadowTuning::SlabGap, way.SlabGap);
      this->Where.SetPose(pose);
      this->Where.Render();
      this->OfPass[way.Name] = std::max(this->Pass->GetStatistics().Fragments, 0LL);
    }
    // What the default mode draws is known from the pass alone: it decides by estimates of times.
    this->Pass->SetMode(vtkShadowVolumeClampPass::Automatic);
    Tune(this->Pass.Get(), &vtkShadowTuning::SlabGap, 4);
    this->Where.SetPose(pose);
    this->Where.Render();
    const vtkShadowStatistics& statistics = this->Pass->GetStatistics();
    VolumeStudy::Result result;
    result.Fragments = std::max(statistics.Fragments, 0LL);
    result.Drawn = statistics.Draws;
    result.Pieces = statistics.Pieces;
    this->Add("auto", result);
    Tune(this->Pass.Get(), &vtkShadowTuning::CountFragments, false);
    this->Where.GetRenderer()->SetPass(nullptr);
  }

  PixelFacts FindFacts(const CameraPose& pose)
  {
    PixelFacts facts;
    const std::vector<vtkProp*> props = this->Where.GetProps();
    for (const int place : FindPixelOwners(this->Where, pose))
    {
      facts.Owner.push_back(
        place < 0 ? -1 : this->Volumes.GetPlace(props[static_cast<std::size_t>(place)]));
    }
    if (this->Options.Own)
    {
      this->FindShown(pose, facts);
      this->CastRays(facts);
    }
    return facts;
  }

  /// Finds the pixels of the image that shadows change.
  void FindShown(const CameraPose& pose, PixelFacts& facts)
  {
    vtkSmartPointer<vtkUnsignedCharArray> images[2];
    this->Where.GetRenderer()->SetPass(this->Pass);
    this->Pass->SetMode(vtkShadowVolumeClampPass::Scissored);
    for (const bool casts : { false, true })
    {
      this->Pass->SetLightCasts(this->Light, casts);
      this->Where.SetPose(pose);
      this->Where.Render();
      images[casts] = this->Where.ReadPixels();
    }
    this->Where.GetRenderer()->SetPass(nullptr);
    for (std::size_t i = 0; i < facts.Owner.size(); ++i)
    {
      const unsigned char* a = images[0]->GetPointer(static_cast<vtkIdType>(4 * i));
      const unsigned char* b = images[1]->GetPointer(static_cast<vtkIdType>(4 * i));
      facts.IsShown.push_back(!std::equal(a, a + 3, b));
    }
  }

  void CastRays(PixelFacts& facts)
  {
    facts.Nearest = this->Volumes.FindNearestCasters(this->Light);
    const Oracle oracle(this->Where.GetRenderer(),
      [this](vtkProp* prop) { return this->Volumes.GetPlace(prop) >= 0; });
    const OracleLight light(this->Light);
    const OracleImage image = oracle.Cast(light);
    const RenderedTriangles& triangles = oracle.GetTriangles();
    for (std::size_t i = 0; i < facts.Owner.size(); ++i)
    {
      facts.IsCertain.push_back(!image.Ambiguous[i]);
      facts.IsShadowed.push_back(image.Samples[i] == OracleSample::Shadowed);
      facts.IsReached.push_back(
        image.Samples[i] == OracleSample::Lit || image.Samples[i] == OracleSample::Shadowed);
      const int owner = facts.Owner[i];
      facts.OwnerConvex.push_back(
        owner >= 0 && this->IsConvex[static_cast<std::size_t>(owner)] ? owner : -1);
      facts.OwnerConvexLit.push_back(-1);
      Oracle::Receiver receiver;
      double toLight[3];
      if (oracle.GetReceiver(static_cast<int>(i) % image.Width, static_cast<int>(i) / image.Width,
            0.0, 0.0, receiver))
      {
        light.GetDirectionTo(receiver.Position, toLight);
        vtkProp* prop = triangles
                          .Actors[static_cast<std::size_t>(
                            triangles.Owners[static_cast<std::size_t>(receiver.Triangle)])]
                          .Prop;
        if (this->Volumes.GetPlace(prop) == owner && vtkMath::Dot(receiver.Normal, toLight) > 0.0)
        {
          facts.OwnerConvexLit.back() = facts.OwnerConvex.back();
        }
      }
    }
  }

  /// Adds counts to the entry of a way.
  void Add(const std::string& name, const VolumeStudy::Result& result)
  {
    const auto [number, isNew] = this->Numbers.try_emplace(name, this->Ways.size());
    Json::Value& entry = this->Ways[number->second];
    entry["name"] = name;
    const auto add = [&entry](const char* member, double count)
    { entry[member] = entry[member].asDouble() + count; };
    add("fragments", static_cast<double>(result.Fragments));
    add("drawn", result.Drawn);
    add("pieces", result.Pieces);
  }

  /// Draws a way, and adds its counts to its entry.
  VolumeStudy::Result Count(
    const std::string& name, const VolumeWay& way, const std::function<bool(int)>& isCounted = {})
  {
    const VolumeStudy::Result result = this->Volumes.Draw(way, isCounted);
    this->Add(name, result);
    const auto ofPass = this->OfPass.find(name);
    if (ofPass != this->OfPass.end() && ofPass->second != result.Fragments)
    {
      std::cerr << "nbuffer-bench: " << name << ": " << result.Fragments
                << " fragments, the pass has " << ofPass->second << "\n";
      this->Differing += 1;
    }
    return result;
  }

  void CountFrame(const PixelFacts& facts)
  {
    VolumeWay whole;
    whole.Mode = vtkShadowMode::Unclamped;
    this->Count("whole", whole);
    whole.Reach = true;
    this->Count("reach", whole);

    const std::set<int> seen(facts.Owner.begin(), facts.Owner.end());
    for (const int resolution : this->Options.Litmaps)
    {
      const std::string at = resolution == 256 ? std::string() : "@" + std::to_string(resolution);
      VolumeWay way;
      way.Tuning.LitmapResolution = resolution;
      way.Tuning.SlabGap = 64;
      way.Tiles = false;
      way.Boxes = false;
      way.Tuning.LitmapSource = this->Paper;
      this->Count("paper" + at, way);
      if (resolution == 256)
      {
        this->Count("paper, casters that are seen", way,
          [&seen](int caster) { return seen.count(caster) > 0; });
        way.Boxes = true;
        this->Count("paper, box", way);
        way.Boxes = false;
      }
      way.Tuning.LitmapSource = nullptr;
      this->Count("scattered" + at, way);
    }

    VolumeWay way;
    way.Tiles = false;
    way.Boxes = false;
    way.Mode = vtkShadowMode::Culled;
    this->Count("scattered, not clamped", way);
    way.Mode = vtkShadowMode::Clamped;
    this->Count("scattered, slabs", way);
    way.Boxes = true;
    this->Count("scattered, slabs, box", way);
    way.Tiles = true;
    this->Count("slabs", way);
    way.Tuning.SlabGap = 64;
    this->Count("one slab", way);
    way.Tuning.SlabGap = 4;
    way.Mode = vtkShadowMode::Scissored;
    const VolumeStudy::Result exact = this->Count("exact", way);
    this->ScatterTimes.push_back(exact.ScatterTime);
    this->LevelsTimes.push_back(exact.LevelsTime);
    if (this->Options.Own)
    {
      this->CountOwn(way, exact, facts);
    }
  }

  /// Draws the way exact without the receivers that some casters could do without.
  void CountOwn(VolumeWay way, const VolumeStudy::Result& exact, const PixelFacts& facts)
  {
    const struct
    {
      const char* Name;
      const CasterPixels* Excluded;
      const CasterPixels* Only;
      bool IsSound; ///< By proof.
    } choices[] = { { "exact, own lit sides out", &facts.OwnerConvexLit, nullptr, true },
      { "exact, own out if convex", &facts.OwnerConvex, nullptr, false },
      { "exact, own out", &facts.Owner, nullptr, false },
      { "exact, nearest caster only", nullptr, &facts.Nearest, true } };
    for (const auto& choice : choices)
    {
      way.Excluded = choice.Excluded;
      way.Only = choice.Only;
      const VolumeStudy::Result result = this->Count(choice.Name, way);
      long long lost = 0;
      long long shown = 0;
      for (std::size_t i = 0; i < result.Mask.size(); ++i)
      {
        // Where a rasteriser's errors have put `exact` on the other side than rays, nothing is
        // lost.
        const bool isKnown = facts.IsCertain[i] &&
          (!facts.IsReached[i] || (exact.Mask[i] != 0) == facts.IsShadowed[i]);
        const bool isLost = isKnown && result.Mask[i] != exact.Mask[i];
        lost += isLost && facts.IsReached[i];
        shown += isLost && facts.IsShown[i];
      }
      Json::Value& entry = this->Ways[this->Numbers.at(choice.Name)];
      entry["lost"] = entry["lost"].asDouble() + static_cast<double>(lost);
      entry["lost_shown"] = entry["lost_shown"].asDouble() + static_cast<double>(shown);
      entry["is_sound"] = choice.IsSound;
      this->Lost += choice.IsSound ? lost : 0;
    }
  }

  Session& Where;
  vtkLight* Light;
  VolumeStudy Volumes;
  const FillOptions& Options;
  vtkNew<vtkShadowVolumeClampPass> Pass;
  std::shared_ptr<NBufferPeers::RerenderedLitmap> Paper =
    std::make_shared<NBufferPeers::RerenderedLitmap>();
  std::vector<bool> IsConvex;              ///< Whether each caster is proven to be a convex body.
  std::map<std::string, long long> OfPass; ///< The fragments of the pass in this frame.
  std::map<std::string, Json::ArrayIndex> Numbers;
  Json::Value Ways = Json::Value(Json::arrayValue);
  long long Lost = 0;               ///< Samples in wrong light by ways that are proven to be sound.
  std::vector<double> ScatterTimes; ///< Of the litmaps of exact.
  std::vector<double> LevelsTimes;
  int Differing = 0; ///< Counts that differ from those of the pass.
};

/// Replaces the sun by a spot in the same direction, as far away as the scene is large, that lights
/// all of the scene.
void MakeSpot(const NBufferExamples::Scene& scene, vtkLight* sun)
{
  const vtkBoundingBox bounds = scene.GetBounds();
  glm::dvec3 center;
  glm::dvec3 toSun;
  bounds.GetCenter(glm::value_ptr(center));
  sun->GetPosition(glm::value_ptr(toSun));
  const double size = bounds.GetDiagonalLength();
  const glm::dvec3 position = center + size * vtkNBufferGLM::Normalize(toSun);
  constexpr double angle = 30.0; // Its sine is that of the sphere around the bounds.
  sun->PositionalOn();
  sun->SetConeAngle(angle);
  sun->SetExponent(0.0);
  sun->SetPosition(glm::value_ptr(position));
  sun->SetFocalPoint(glm::value_ptr(center));
}

int RunFill(FillOptions& options)
{
  CheckWritable(options.JSON);
  const std::string& name = options.View.SceneNames.front();
  const SpotLamp lamp = options.Lamp.empty() ? SpotLamp() : ReadLamp(name, options.Lamp);
  const NBufferExamples::Scene scene = LoadShadowScene(options.View);
  CameraPath path;
  const int step = options.Spread ? 60 : 1;
  const int frames = options.View.Frames > 0 ? options.View.Frames : 4;
  const CameraPath all = NBufferExamples::MakePath(
    scene, options.View.GetPathName(scene), step * frames, options.View.Seed);
  for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(step))
  {
    path.push_back(all[i]);
  }
  Session& session = Session::New(scene, options.View.Window);
  vtkLight* light = LightScene(name, scene, path, session.GetRenderer(), lamp);
  if (options.Spot)
  {
    MakeSpot(scene, light);
  }
  vtkSmartPointer<vtkInformation> keys;
  if (!options.GroundCasts)
  {
    keys = MarkCasters(scene);
  }
  session.SetPose(path.front());
  session.Render();
  Json::Value report = FillStudy(session, light, keys, options).Run(path);
  options.View.Describe(scene, session, report);
  report["scene"] = name == "city-sun" || name == "city-spot" ? name : scene.Name;
  report["ground_casts"] = options.GroundCasts;
  report["spot"] = options.Spot;
  for (const Json::Value& way : report["ways"])
  {
    std::cout << way["name"].asString() << ": " << way["fragments"].asDouble() << " fragments, "
              << way["percent_of_whole"].asDouble() << " % of whole, "
              << way["percent_of_reach"].asDouble() << " % of those in reach, "
              << way["drawn"].asDouble() << " casters, " << way["pieces"].asDouble() << " pieces";
    if (way.isMember("lost"))
    {
      std::cout << ", " << way["lost"].asDouble() << " samples lost, "
                << way["lost_shown"].asDouble() << " of them shown";
    }
    std::cout << "\n";
  }
  std::cout << "litmap of exact: scattered in " << report["scatter_ms"]["median"].asDouble()
            << " ms, levels in " << report["levels_ms"]["median"].asDouble() << " ms\n";
  WriteJSON(report, options.JSON);
  return report["lost"].asInt64() > 0 || report["differing_ways"].asInt() > 0 ? ImagesDiffer
                                                                              : Success;
}
}

void AddFillCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("fill",
    "Count the fragments of shadow volumes from the paper's method (re-rendered litmap, one slab, "
    "no boxes of pixels) to the module's, one step at a time");
  auto options = std::make_shared<FillOptions>();
  options->View.SceneNames = { "city-sun" };
  options->View.SceneHelp = "as those of shadow";
  options->View.Window.Size = { 640, 480 };
  options->View.AddTo(*command, program);
  command->add_option("--litmaps", options->Litmaps, "Lexels along each side of litmaps")
    ->delimiter(',')
    ->check(CLI::Range(1, 4096))
    ->capture_default_str();
  command->add_flag("--own", options->Own,
    "Also leave out, by rays, receivers that a caster need not draw for: its own, or all that "
    "another caster shadows");
  command->add_flag("--spread", options->Spread,
    "Render only every sixtieth pose of a path that is as much longer");
  command->add_flag("--spot", options->Spot,
    "Replace the sun by a spot in the same direction, as far away as the scene is large, which "
    "lights all of the scene");
  command->add_flag("--ground-caster", options->GroundCasts, "As of shadow");
  command->add_option("--lamp", options->Lamp, "As of shadow")->delimiter(',')->expected(4);
  command->add_option("--json", options->JSON, "File for the figures");
  command->callback([options, &run]() { run = [options]() { return RunFill(*options); }; });
}

} // namespace NBufferBench
