// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeStudy.h"

#include "VisibleProps.h"

#include "DrawStage.h"
#include "RayOracle.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferGL.h"
#include "vtkShadowLitmapSource.h"
#include "vtkShadowReceiverProjector.h"
#include "vtkShadowReceivers.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPoints.h"
#include "vtkProp.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

namespace NBufferBench
{

VolumeStudy::VolumeStudy(Session& session, vtkInformation* casterKeys)
  : Where(session)
{
  for (vtkProp* prop : session.GetProps())
  {
    if (prop->GetVisibility() && (!casterKeys || prop->HasKeys(casterKeys)))
    {
      this->Places.emplace(prop, this->GetNumberOfCasters());
    }
  }
  this->Casters.Update(session.GetRenderer(), casterKeys);
  this->LightingMargin = this->Casters.GetLightingMargin();
  if (this->Casters.GetCasters().size() != this->Places.size())
  {
    throw std::runtime_error("volumes can be studied only where every prop is one caster");
  }
}

int VolumeStudy::GetPlace(vtkProp* prop) const
{
  const auto found = this->Places.find(prop);
  return found == this->Places.end() ? -1 : found->second;
}

CasterPixels VolumeStudy::FindNearestCasters(vtkLight* source) const
{
  const Oracle oracle(this->Where.GetRenderer());
  const RenderedTriangles& triangles = oracle.GetTriangles();
  const OracleLight light(source);
  CasterPixels nearest;
  for (int y = 0; y < oracle.GetHeight(); ++y)
  {
    for (int x = 0; x < oracle.GetWidth(); ++x)
    {
      nearest.push_back(-1);
      Oracle::Receiver receiver;
      if (!oracle.GetReceiver(x, y, 0.0, 0.0, receiver))
      {
        continue;
      }
      double least = std::numeric_limits<double>::infinity();
      oracle.VisitCasters(receiver, light,
        [&](int owner, double t)
        {
          const int caster = this->GetPlace(triangles.Actors[static_cast<std::size_t>(owner)].Prop);
          if (caster >= 0 && t < least)
          {
            least = t;
            nearest.back() = caster;
          }
          return true;
        });
    }
  }
  return nearest;
}

bool VolumeStudy::IsConvex(int caster) const
{
  const vtkShadowCaster& mesh = *this->Casters.GetCasters()[static_cast<std::size_t>(caster)];
  const std::vector<vtkIdType> triangles(mesh.GetTriangles().begin(), mesh.GetTriangles().end());
  return vtkShadowTopology(mesh.GetPoints(), triangles).IsConvex();
}

void VolumeStudy::Check(bool done) const
{
  if (!done)
  {
    throw std::runtime_error(this->Error);
  }
}

void VolumeStudy::Begin(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  this->Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const auto lights = vtkShadowLightSource::Find(renderer, [](vtkLight*) { return true; });
  if (lights.size() != 1 || lights[0].Geometry.Kind == vtkShadowLightKind::Point)
  {
    throw std::runtime_error("volumes are studied under one sun or one spot");
  }
  this->Light = lights[0].Geometry;
  this->Space = std::make_unique<vtkShadowLightSpace>(this->Light);
  this->Camera = std::make_unique<vtkShadowCamera>(renderer);
  int* viewport = this->Camera->Plan.Viewport;
  glGetIntegerv(GL_VIEWPORT, viewport);
  this->Check(this->Target.Reserve(this->Window, viewport[0] + viewport[2],
    viewport[1] + viewport[3], 1, vtkNBufferGL::GetSamplePlaces(), this->Error));
  for (vtkShadowCaster* caster : this->Casters.GetCasters())
  {
    caster->UpdateParts(0, this->Light, *this->Space, this->Camera->NearBounds);
  }
}

void VolumeStudy::Run(const NBufferExamples::CameraPose& pose, const std::function<void()>& work)
{
  const std::vector<vtkProp*> props = this->Where.GetProps();
  std::exception_ptr error; // VTK does not expect exceptions where it draws.
  vtkNew<NBufferPeers::DrawStage> stage;
  stage->Function = [&](vtkRenderer* renderer)
  {
    try
    {
      this->Begin(renderer);
      vtkOpenGLState* state = this->Window->GetState();
      state->PushFramebufferBindings();
      state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Target.GetDepthFramebuffer());
      state->vtkglDepthMask(GL_TRUE);
      glClearBufferfv(GL_DEPTH, 0, &vtkNBufferDepthConvention::Background);
      for (vtkProp* prop : props)
      {
        prop->RenderOpaqueGeometry(renderer);
      }
      state->PopFramebufferBindings();
      const vtkShadowCounter::Scope scope(this->Window, this->Camera->Plan.Viewport);
      this->Check(this->Target.ReadDepth(
        this->Window, this->Camera->Plan.Viewport, this->Depth, this->Error));
      work();
    }
    catch (...)
    {
      error = std::current_exception();
    }
    return static_cast<int>(props.size());
  };
  this->Where.SetPose(pose);
  RenderOnly(this->Where, { stage });
  if (error)
  {
    std::rethrow_exception(error);
  }
}

std::vector<float> VolumeStudy::GetDepthFor(const VolumeWay& way, int caster) const
{
  std::vector<float> depth = this->Depth;
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    if (way.Only ? (*way.Only)[i] != caster : (*way.Excluded)[i] == caster)
    {
      depth[i] = vtkNBufferDepthConvention::Background;
    }
  }
  return depth;
}

void VolumeStudy::MakeLitmap(
  const VolumeWay& way, const std::vector<float>& depth, vtkShadowLitmap& litmap, Result& result)
{
  vtkNBufferClock clock;
  vtkShadowView view = this->Camera->GetView();
  const int resolution = way.Tuning.LitmapResolution;
  if (vtkShadowLitmapSource* source = way.Tuning.LitmapSource.get())
  {
    const vtkShadowBlock range =
      vtkShadowReceivers::GetRange(depth.data(), view, this->Light, *this->Space);
    this->Check(source->BeginFrame(this->Renderer, depth.data(), view, this->Error) &&
      source->Fill(*this->Space, range, resolution, litmap, this->Error));
  }
  else
  {
    view.LightingMargin = this->LightingMargin;
    vtkShadowReceivers::Scatter(depth.data(), view, this->Light, *this->Space, resolution, litmap);
  }
  if (!way.Tiles)
  {
    litmap.GetTiles().Begin(0, 0);
  }
  result.ScatterTime = clock.Restart();
  litmap.Build();
  result.LevelsTime = clock.Restart();
}

VolumeStudy::Result VolumeStudy::Draw(
  const VolumeWay& way, const std::function<bool(int caster)>& isCounted)
{
  Result result;
  vtkShadowPlan::View view = this->Camera->Plan;
  view.Boxes = way.Boxes;
  if (way.Reach && this->Light.Kind == vtkShadowLightKind::Spot)
  {
    vtkShadowView receivers = this->Camera->GetView();
    receivers.LightingMargin = this->LightingMargin;
    view.ConeReach =
      vtkShadowReceiverProjector(receivers, this->Light, *this->Space).GetConeReach();
  }
  this->Draws.clear();
  this->Store.BeginFrame();
  const auto add = [&](const std::vector<int>& casters, const vtkShadowLitmap* litmap)
  {
    vtkShadowPlan plan(this->Light, view, way.Mode,
      litmap ? std::vector<vtkShadowPlan::Face>{ { this->Space.get(), litmap } }
             : std::vector<vtkShadowPlan::Face>(),
      way.Tuning);
    for (const int caster : casters)
    {
      const std::size_t before = plan.GetDraws().size();
      for (const vtkShadowPart& part :
        this->Casters.GetCasters()[static_cast<std::size_t>(caster)]->GetParts(0))
      {
        plan.Draw(plan.Decide(part), part, this->Store);
      }
      result.Drawn += plan.GetDraws().size() > before;
    }
    this->Draws.insert(this->Draws.end(), plan.GetDraws().begin(), plan.GetDraws().end());
  };

  const CasterPixels* special = way.Only ? way.Only : way.Excluded;
  std::set<int> own; // The casters whose receivers are not those of the others.
  if (special)
  {
    own.insert(special->begin(), special->end());
    own.erase(-1);
  }
  std::vector<int> common;
  for (int i = 0; i < this->GetNumberOfCasters(); ++i)
  {
    if (!isCounted || isCounted(i))
    {
      if (own.count(i) == 0)
      {
        common.push_back(i);
      }
    }
    else
    {
      own.erase(i);
    }
  }
  vtkShadowLitmap litmap;
  if (way.Mode == vtkShadowMode::Unclamped)
  {
    add(common, nullptr);
  }
  else if (!way.Only)
  {
    this->MakeLitmap(way, this->Depth, litmap, result);
    add(common, &litmap);
  }
  for (const int caster : own)
  {
    this->MakeLitmap(way, this->GetDepthFor(way, caster), litmap, result);
    add({ caster }, &litmap);
  }

  const int* viewport = this->Camera->Plan.Viewport;
  this->Counter.ClearMask(this->Target, 0, viewport);
  this->Check(this->Buffer.Upload(this->Store, this->Error));
  const vtkShadowDraw* first = this->Draws.data();
  const vtkShadowDraw* const end = first + this->Draws.size();
  while (first != end)
  {
    // As many as the stencil can count, as in vtkShadowMaskMaker.
    int count = first->MaximumCount;
    const vtkShadowDraw* last = first + 1;
    while (
      last != end && (last->Again || count + last->MaximumCount <= vtkShadowCaster::MaximumCount))
    {
      count += last->Again ? 0 : last->MaximumCount;
      ++last;
    }
    result.Pieces += static_cast<int>(
      std::count_if(first, last, [](const vtkShadowDraw& draw) { return !draw.Again; }));
    this->Counter.ClearStencil(this->Target, viewport);
    this->Check(this->Counter.Count(this->Window, this->Target, this->Buffer, this->Camera->Plan,
                  first, last, &result.Fragments, this->Error) &&
      this->Counter.Resolve(this->Window, this->Target, 0, 0, viewport, this->Error));
    first = last;
  }
  this->Check(this->Target.ReadMask(this->Window, viewport, 0, -1, result.Mask, this->Error));
  return result;
}

vtkSmartPointer<vtkPolyData> VolumeStudy::GetVolumes(double reach) const
{
  const vtkShadowVolume& volume = this->Store.GetVolume();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec4& vertex : volume.GetVertices())
  {
    const glm::dvec3 place = glm::dvec3(vertex) * (vertex.w == 0.0 ? reach : 1.0);
    points->InsertNextPoint(place.x, place.y, place.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const vtkShadowDraw& draw : this->Draws)
  {
    for (int i = 0; !draw.Again && i < draw.NumberOfIndices; i += 3)
    {
      triangles->InsertNextCell(3);
      for (int j = 0; j < 3; ++j)
      {
        triangles->InsertCellPoint(
          volume.GetIndices()[static_cast<std::size_t>(draw.FirstIndex + i + j)]);
      }
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

std::vector<vtkShadowBlock> VolumeStudy::GetPieces() const
{
  const vtkShadowVolume& volume = this->Store.GetVolume();
  std::vector<vtkShadowBlock> pieces;
  for (const vtkShadowDraw& draw : this->Draws)
  {
    if (!draw.Again)
    {
      pieces.emplace_back();
    }
    for (int i = 0; i < draw.NumberOfIndices; ++i)
    {
      const glm::dvec4& vertex =
        volume.GetVertices()[volume.GetIndices()[static_cast<std::size_t>(draw.FirstIndex + i)]];
      if (vertex.w != 0.0)
      {
        pieces.back().Add(glm::dvec3(vertex));
      }
    }
  }
  return pieces;
}

std::vector<glm::dvec3> VolumeStudy::GetReceivers() const
{
  const vtkShadowView view = this->Camera->GetView();
  std::vector<glm::dvec3> places;
  for (std::size_t i = 0; i < this->Depth.size(); ++i)
  {
    if (vtkNBufferDepthConvention::IsDrawn(this->Depth[i]))
    {
      const auto x = static_cast<double>(i % static_cast<std::size_t>(view.Width));
      const auto y = static_cast<double>(i / static_cast<std::size_t>(view.Width));
      const glm::dvec4 place = view.ClipToWorld *
        glm::dvec4(2.0 * (x + 0.5) / view.Width - 1.0, 2.0 * (y + 0.5) / view.Height - 1.0,
          2.0 * this->Depth[i] - 1.0, 1.0);
      places.push_back(view.Origin + glm::dvec3(place) / place.w);
    }
  }
  return places;
}

} // namespace NBufferBench
