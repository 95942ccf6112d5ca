// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Player.h"

#include "Fill.h"
#include "Judge.h"
#include "ReversedDepth.h"
#include "SceneBuilder.h"
#include "ScenePasses.h"
#include "SceneProps.h"
#include "TestedBackend.h"
#include "Tune.h"

#include "vtkNBufferVTKVersion.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkDataObject.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"

#include <algorithm>
#include <sstream>

namespace TestScene
{
namespace
{
/// Of vtkMapper::SetResolveCoincidentTopologyZShift: VTK's, and one that is seen.
constexpr double DefaultShift = 0.01;
constexpr double LargeShift = 0.05;

void SetStereo(vtkRenderWindow* window, int type)
{
  window->SetStereoRender(type >= 0);
  if (type >= 0)
  {
    window->SetStereoType(type);
  }
}

/// VTK draws the first frame after a change of stereo with the matrices of the frame before, but
/// only if it drew anything there. With a culler that may be nothing, where VTK alone draws props
/// outside of the view. Here the camera keeps the matrices in any case.
void KeepMatrices(vtkRenderer* renderer)
{
  if (auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera()))
  {
    vtkMatrix4x4* matrices[3] = {};
    vtkMatrix3x3* normals = nullptr;
    camera->GetKeyMatrices(renderer, matrices[0], normals, matrices[1], matrices[2]);
  }
}

void SetSize(vtkRenderWindow* window, double width, double height)
{
  constexpr double largest = 2048.0;
  window->SetSize(static_cast<int>(std::min(std::max(width, 1.0), largest)),
    static_cast<int>(std::min(std::max(height, 1.0), largest)));
}

void SetUp(vtkRenderer* renderer, const Renderer& description, int index)
{
  renderer->SetViewport(description.Viewport.data());
  renderer->SetLayer(description.Layer);
  renderer->SetErase(description.Erase);
  renderer->SetPreserveDepthBuffer(description.PreserveDepth);
  renderer->SetBackground(0.1 + 0.2 * index, 0.2, 0.3);
  renderer->SetUseSSAO(description.SSAO);
  renderer->SetSSAOKernelSize(8);
  renderer->SetUseFXAA(description.FXAA);
  renderer->SetUseDepthPeeling(description.DepthPeeling);
  renderer->SetMaximumNumberOfPeels(3);
#if VTKNBUFFER_HAS_OIT_SWITCH
  renderer->SetUseOIT(description.OIT);
#endif
  renderer->SetUseHiddenLineRemoval(description.HiddenLines);
  if (description.Shadows && VTKNBUFFER_HAS_LASTING_SHADOW_MAPS)
  {
    renderer->SetUseShadows(true);
    renderer->AddLight(MakeLight(SceneBuilder().Spot({ 8.0, 9.0, 14.0 }, { 0.0, 0.0, 0.0 }, 60.0)));
  }
}
}

Player::~Player()
{
  this->End();
}

void Player::DropWindow()
{
  this->End();
  this->Window = nullptr;
}

void Player::Begin(const Scenario& scenario)
{
  this->End();
  const TestScene::Window& window = scenario.Window;
  if (this->Window && this->Window->GetStencilCapable() != window.StencilCapable)
  {
    this->DropWindow();
  }
  this->Scene = &scenario;
  if (!this->Window)
  {
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetOffScreenRendering(1);
    this->Window->SetStencilCapable(window.StencilCapable);
  }
  this->Window->SetMultiSamples(window.MultiSamples);
  SetSize(this->Window, window.Width, window.Height);
  this->Window->SetLineSmoothing(window.LineSmoothing);
  SetStereo(this->Window, window.Stereo);
  const int tiles = std::min(std::max(window.TileScale, 1), 4);
  this->Window->SetTileScale(tiles, tiles);
  this->Window->SetTileViewport(0.0, 0.0, 1.0 / tiles, 1.0 / tiles);
  this->AddRenderers();
  this->Lighting.Begin(scenario, this->Renderers);
  this->AddCullers();
  this->Props.resize(scenario.Props.size());
  this->Present.resize(scenario.Props.size(), false);
  for (std::size_t i = 0; i < scenario.Props.size(); ++i)
  {
    this->Draws.push_back(std::make_shared<int>(0));
    this->Places[scenario.Props[i].Id] = static_cast<int>(i);
  }
}

void Player::End()
{
  // Props, passes and renderers that go delete their objects in the context that is current, some
  // of VTK's without asking which it is: those of the other stage's window have the same names.
  this->MakeCurrent();
  for (const auto& renderer : this->Renderers)
  {
    renderer->RemoveAllViewProps();
    this->Window->RemoveRenderer(renderer);
  }
  this->Props.clear();
  this->Present.clear();
  this->Places.clear();
  this->Lighting.End();
  this->Renderers.clear();
  this->Cullers.clear();
  this->Culler = nullptr;
  this->Draws.clear();
  this->DrawnWithOthers.clear();
  this->Scene = nullptr;
  vtkMapper::SetResolveCoincidentTopologyToDefault();
  vtkMapper::SetResolveCoincidentTopologyZShift(DefaultShift);
}

void Player::AddRenderers()
{
  int layers = 1;
  for (std::size_t i = 0; i < this->Scene->Renderers.size(); ++i)
  {
    const TestScene::Renderer& description = this->Scene->Renderers[i];
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    SetUp(renderer, description, static_cast<int>(i));
    if (description.SharesCamera && i > 0)
    {
      renderer->SetActiveCamera(this->Renderers[0]->GetActiveCamera());
    }
    else
    {
      if (description.Pass == PassKind::Reversed)
      {
        vtkNew<ReversedCamera> reversed;
        reversed->SetInfiniteFar(description.InfiniteFar);
        renderer->SetActiveCamera(reversed);
      }
      else
      {
        renderer->SetActiveCamera(vtkNew<vtkCamera>());
      }
    }
    layers = std::max(layers, description.Layer + 1);
    this->Window->SetNumberOfLayers(layers);
    this->Window->AddRenderer(renderer);
    this->Renderers.push_back(renderer);
  }
}

void Player::AddCullers()
{
  const TestScene::Culler& settings = this->Scene->Culler;
  for (const auto& renderer : this->Renderers)
  {
    if (this->Part == Role::Reference || settings.DefaultCuller == DefaultCuller::Removed)
    {
      renderer->GetCullers()->RemoveAllItems();
    }
    if (this->Part != Role::Culled)
    {
      continue;
    }
    if (this->Cullers.empty() || settings.OnePerRenderer)
    {
      auto culler = vtkSmartPointer<vtkNBufferCuller>::New();
      culler->SetBackend(GetTestedBackend(settings.Backend));
      Tune(culler, &vtkNBufferTuning::BaseFactor, settings.BaseFactor);
      Tune(
        culler, &vtkNBufferTuning::MinimumNumberOfCandidates, settings.MinimumNumberOfCandidates);
      Tune(culler, &vtkNBufferTuning::MaximumNumberOfRounds, settings.MaximumNumberOfRounds);
      Tune(culler, &vtkNBufferTuning::RoundSize, settings.RoundSize);
      Tune(culler, &vtkNBufferTuning::HierarchySize, settings.HierarchySize);
      Tune(culler, &vtkNBufferTuning::ObserveAfter, settings.ObserveAfter);
      Tune(culler, &vtkNBufferTuning::TestTriangles, settings.TestTriangles);
      Tune(culler, &vtkNBufferTuning::TestPixels, settings.TestPixels);
      culler->SetTestSlivers(settings.TestSlivers);
      culler->SetDivideProps(settings.DivideProps);
      Tune(
        culler, &vtkNBufferTuning::MinimumNumberOfPrimitives, settings.MinimumNumberOfPrimitives);
      Tune(culler, &vtkNBufferTuning::UnitSize, settings.UnitSize);
      Tune(culler, &vtkNBufferTuning::DivideAfter, 0);
      Tune(culler, &vtkNBufferTuning::MinimumNumberOfUnitsOnDevice, 1);
      // The same units in the same frame, whenever the scenario is run.
      Tune(culler, &vtkNBufferTuning::DivideInBackground, false);
      Tune(culler, &vtkNBufferTuning::TimeUnits, false);
      Tune(culler, &vtkNBufferTuning::ReuseWhenStill, settings.ReuseWhenStill);
      Tune(culler, &vtkNBufferTuning::BackOff, settings.BackOff);
      Tune(culler, &vtkNBufferTuning::TakeOverFrustumCulling,
        settings.DefaultCuller != DefaultCuller::NoTakeOver);
      this->Cullers.push_back(culler);
    }
    else
    {
      this->Cullers.push_back(this->Cullers.front());
    }
    this->Culler = this->Cullers.front();
  }
}

//------------------------------------------------------------------------------------------------
std::string Player::Prepare(int frame)
{
  this->MakeCurrent();
  this->Frame = frame;
  this->JoinAndLeave(frame);
  std::string found;
  for (const Change& change : this->Scene->Changes)
  {
    if (change.Frame != frame)
    {
      continue;
    }
    if (change.Kind == ChangeKind::Select)
    {
      found += this->Select();
    }
    else
    {
      this->Lighting.Apply(change);
      this->ApplyToRenderer(change);
      this->ApplyToWindow(change);
      this->ApplyToCullers(change);
      this->ApplyToProp(change);
    }
  }
  for (const View& view : this->Scene->Views)
  {
    if (view.Frame == frame)
    {
      this->Look(view);
    }
  }
  if (frame == this->Scene->Culler.AddedInFrame)
  {
    this->ApplyToCullers({ frame, ChangeKind::CullerPresent, 0, { 1.0 } });
  }
  return found;
}

void Player::UsePasses(ShadowPasses passes)
{
  this->MakeCurrent();
  this->Lighting.UsePasses(passes);
}

void Player::JoinAndLeave(int frame)
{
  for (int i = 0; i < static_cast<int>(this->Props.size()); ++i)
  {
    const Prop& description = this->Scene->Props[i];
    const bool present =
      description.From <= frame && (description.Until < 0 || frame < description.Until);
    if (present != this->Present[i])
    {
      this->Join(i, present);
    }
  }
}

void Player::Join(int prop, bool present)
{
  const Prop& description = this->Scene->Props[prop];
  const int index = description.Renderer;
  if (index < 0 || index >= this->GetNumberOfRenderers())
  {
    return;
  }
  vtkSmartPointer<vtkProp>& object = this->Props[prop];
  if (!object)
  {
    object = MakeProp(description, this->Renderers[index]->GetActiveCamera());
    const auto owner = this->Places.find(description.MapperOf);
    if (owner != this->Places.end() && ShareMapper(object, this->Props[owner->second]))
    {
      this->DrawnWithOthers.insert({ prop, owner->second });
    }
    if (this->Lighting.HasShadows())
    {
      LightRig::SetCasts(object, description.Casts);
    }
    if (auto* actor = vtkActor::SafeDownCast(object))
    {
      this->CountDraws(actor);
    }
  }
  this->Present[prop] = present;
  const auto whole = this->Places.find(description.PartOf);
  if (whole != this->Places.end() && whole->second < prop &&
    SetPart(this->Props[whole->second], object, present))
  {
    // It is drawn where and when the assembly is.
    this->DrawnWithOthers.insert(prop);
    return;
  }
  for (int i = 0; i < this->GetNumberOfRenderers(); ++i)
  {
    if (i != index && (index != 0 || !this->Scene->Renderers[i].SharesProps))
    {
      continue;
    }
    if (present)
    {
      this->Renderers[i]->AddViewProp(object);
    }
    else
    {
      this->Renderers[i]->RemoveViewProp(object);
    }
  }
}

void Player::Look(const View& view)
{
  if (view.Renderer >= 0 && view.Renderer < this->GetNumberOfRenderers())
  {
    SetView(this->Renderers[view.Renderer], view);
  }
}

//------------------------------------------------------------------------------------------------
void Player::ApplyToProp(const Change& change)
{
  const auto found = this->Places.find(change.Target);
  if (found == this->Places.end() || !this->Props[found->second])
  {
    return;
  }
  const int prop = found->second;
  if (change.Kind != ChangeKind::Rejoin)
  {
    ChangeProp(this->Props[prop], this->Scene->Props[prop], change);
  }
  else if (this->Present[prop])
  {
    this->Join(prop, false);
    this->Join(prop, true);
  }
}

void Player::ApplyToRenderer(const Change& change)
{
  if (change.Target < 0 || change.Target >= this->GetNumberOfRenderers())
  {
    return;
  }
  vtkRenderer* renderer = this->Renderers[change.Target];
  const double value = GetValue(change, 0);
  switch (change.Kind)
  {
    case ChangeKind::Viewport:
      renderer->SetViewport(value, GetValue(change, 1), GetValue(change, 2), GetValue(change, 3));
      break;
    case ChangeKind::Pass:
      if (vtkRenderPass* old = renderer->GetPass())
      {
        old->ReleaseGraphicsResources(this->Window);
      }
      this->Lighting.SetPassKind(change.Target, static_cast<PassKind>(static_cast<int>(value)));
      break;
    case ChangeKind::FXAA:
      renderer->SetUseFXAA(value != 0.0);
      break;
    case ChangeKind::SSAO:
      renderer->SetUseSSAO(value != 0.0);
      break;
    case ChangeKind::Erase:
      renderer->SetErase(value != 0.0);
      break;
    case ChangeKind::PreserveDepth:
      renderer->SetPreserveDepthBuffer(value != 0.0);
      break;
    default:
      break;
  }
}

void Player::ApplyToWindow(const Change& change)
{
  const double value = GetValue(change, 0);
  switch (change.Kind)
  {
    case ChangeKind::WindowSize:
      SetSize(this->Window, value, GetValue(change, 1));
      break;
    case ChangeKind::MultiSamples:
      this->Window->SetMultiSamples(static_cast<int>(value));
      break;
    case ChangeKind::Stereo:
      for (const auto& renderer : this->Renderers)
      {
        KeepMatrices(renderer);
      }
      SetStereo(this->Window, static_cast<int>(value));
      break;
    case ChangeKind::NewContext:
      this->Window->Finalize();
      for (const auto& renderer : this->Renderers)
      {
        RenewPasses(renderer);
      }
      break;
    case ChangeKind::PolygonOffset:
      // One switch for both stages: the same twice is no change.
      vtkMapper::SetResolveCoincidentTopology(std::clamp(static_cast<int>(value), 0, 2));
      vtkMapper::SetResolveCoincidentTopologyZShift(LargeShift);
      break;
    default:
      break;
  }
}

void Player::ApplyToCullers(const Change& change)
{
  const auto value = static_cast<int>(GetValue(change, 0));
  for (std::size_t i = 0; i < this->Cullers.size(); ++i)
  {
    vtkNBufferCuller* culler = this->Cullers[i];
    vtkCullerCollection* cullers = this->Renderers[i]->GetCullers();
    switch (change.Kind)
    {
      case ChangeKind::CullerEnabled:
        culler->SetEnabled(value != 0);
        break;
      case ChangeKind::CullerBackend:
        culler->SetBackend(value);
        break;
      case ChangeKind::CullerBaseFactor:
        Tune(culler, &vtkNBufferTuning::BaseFactor, value);
        break;
      case ChangeKind::CullerRoundSize:
        Tune(culler, &vtkNBufferTuning::RoundSize, value);
        break;
      case ChangeKind::CullerPresent:
        cullers->RemoveItem(culler);
        if (value != 0)
        {
          this->Renderers[i]->AddCuller(culler);
          if (this->Scene->Culler.DefaultCuller == DefaultCuller::Behind &&
            cullers->GetNumberOfItems() == 2)
          {
            const vtkSmartPointer<vtkCuller> first =
              vtkCuller::SafeDownCast(cullers->GetItemAsObject(0));
            cullers->RemoveItem(first);
            cullers->AddItem(first);
          }
        }
        break;
      default:
        break;
    }
  }
}

std::string Player::Select()
{
  // Before the first frame there is nothing to select from.
  if (this->Frame == 0)
  {
    return "";
  }
  // A tile is all that is drawn of a tiled window, whose GetSize() is that of all tiles.
  const int* size = this->Window->GetActualSize();
  const int area[4] = { 0, 0, size[0] - 1, size[1] - 1 };
  std::ostringstream text;
  for (const auto& [index, found] :
    TestScene::Select(*this, area, vtkDataObject::FIELD_ASSOCIATION_CELLS))
  {
    text << (index < 0 ? -1 : this->Scene->Props[index].Id) << ": " << found.Pixels << " ";
  }
  return text.str();
}
}
