// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Actors that share a mapper and need different shaders. VTK draws them by those that it has made
// last, so that the image depends on what has been drawn before, in this frame and in earlier ones.
#include "HazardBuilder.h"

#include "vtkProperty.h"

#include <utility>

namespace TestScene
{
namespace
{
using Decision = vtkNBufferDecision;
using Verdict = vtkNBufferVerdict;

/// Frames in which only the camera moves, a little.
void Walk(HazardBuilder& scene, int frames)
{
  for (int i = 0; i < frames; ++i)
  {
    scene.NextFrame();
    scene.LookAtWall(0.01 * scene.GetFrame());
  }
}

/// Actors without a texture are drawn by the shaders of one that has a texture. They show the
/// texture that any other prop has left in the texture unit, here that of a prop outside the view:
/// first while the actor with a texture is visible, then without it.
NamedScenario TexturesOfPropsOutside()
{
  HazardBuilder scene("TexturesOfPropsOutside");
  scene.BeExact();
  // Order-independent transparency, which VTK 9.1 cannot switch off, makes shaders anew.
  scene.Scene.Renderers.front().OIT = false;
  const int first = scene.Box({ -3.0, 0.0, 0.0 }, { 2.0, 2.0, 2.0 }).Id;
  const int outside = scene.Box({ 900.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }).Id;
  scene.Scene.Props[outside].Texture = Translucency::Opaque;
  Prop& translucent = scene.Box({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  translucent.Position.x = 3.0;
  translucent.Texture = Translucency::Some;
  const int textured = translucent.Id;
  Prop& last = scene.Box({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  last.Position.x = 6.0;
  scene.Scene.Props[textured].MapperOf = last.MapperOf = first;
  const std::vector<int> all = { first, outside, last.Id };
  scene.LookAtWall();
  for (int i = 0; i < 6; ++i)
  {
    scene.Change(ChangeKind::Visible, textured, { i < 3 ? 1.0 : 0.0 });
    if (VTKNBUFFER_HAS_OIT_SWITCH || i < 4)
    {
      scene.ExpectVerdict(all, Verdict::SharedMapper);
    }
    Walk(scene, 1);
  }
  // As soon as the shaders have been made anew, props are left out again.
  scene.Change(ChangeKind::Color, first, { 1.0, 0.0, 0.0 });
  Walk(scene, 1);
  scene.ExpectVerdict({ outside }, Verdict::Outside);
  return scene.Finish();
}

/// A surface and its wireframe with one mapper keep their order, and the other props are culled.
/// Between them, before and after them props of the same shape are drawn late, in the frames in
/// which what has hidden them is gone.
NamedScenario SurfaceAndWireframe()
{
  HazardBuilder scene("SurfaceAndWireframe");
  scene.BeExact();
  scene.AddWall();
  std::vector<int> late;
  const int hidden = scene.Sphere({ 0.0, 0.0, -8.0 }, 1.0).Id;
  late.push_back(scene.Sphere({ 0.0, 0.0, 4.0 }, 1.0).Id);
  const int surface = scene.Sphere({ 0.0, 0.0, 4.0 }, 1.0).Id;
  late.push_back(scene.Sphere({ 0.0, 0.0, 4.0 }, 1.0).Id);
  Prop& lines = scene.Sphere({ 0.0, 0.0, 4.0 }, 1.0);
  lines.MapperOf = surface;
  lines.Representation = Representation::Wireframe;
  const int wireframe = lines.Id;
  late.push_back(scene.Sphere({ 0.0, 0.0, 4.0 }, 1.0).Id);
  const int blocker = scene.Box({ 0.0, 0.0, 6.5 }, { 4.0, 4.0, 0.2 }).Id;
  scene.LookAtWall();
  Walk(scene, 1);
  for (int i = 0; i < 2; ++i)
  {
    scene.Change(ChangeKind::Visible, blocker, { 1.0 });
    Walk(scene, 4);
    scene.ExpectDecision(Decision::Culled);
    scene.ExpectVerdict({ surface }, Verdict::SharedMapper);
    late.push_back(hidden);
    scene.ExpectVerdict(late, Verdict::Hidden);
    late.pop_back();
    Walk(scene, 1);
    scene.Change(ChangeKind::Visible, blocker, { 0.0 });
    scene.ExpectDecision(Decision::Culled);
    scene.ExpectVerdict({ hidden }, Verdict::Hidden);
    scene.ExpectVerdict(late, Verdict::Visible);
    Walk(scene, 1);
  }
  // Where one of them changes, the order of all props is kept for a frame.
  scene.Change(ChangeKind::Color, wireframe, { 1.0, 0.5, 0.0 });
  scene.ExpectDecision(Decision::Blending);
  Walk(scene, 1);
  scene.ExpectDecision(Decision::Culled);
  return scene.Finish();
}

/// A hidden actor needs other shaders for some frames. Without the culler the mapper makes its
/// shaders anew where it draws this actor, also in the first frame in which its needs are those of
/// the other actor again.
NamedScenario HiddenActorMakesShaders()
{
  HazardBuilder scene("HiddenActorMakesShaders");
  scene.BeExact();
  scene.AddWall();
  const int before = scene.Sphere({ 0.0, 0.0, 4.0 }, 1.0).Id;
  Prop& behind = scene.Sphere({ 0.0, 0.0, 0.0 }, 1.0);
  behind.Position = { 1.0, 0.0, -8.0 };
  behind.MapperOf = before;
  const int hidden = behind.Id;
  scene.Scene.Props[before].Flat = scene.Scene.Props[hidden].Flat = true;
  scene.LookAtWall();
  Walk(scene, 3);
  scene.ExpectVerdict({ hidden }, Verdict::Hidden);
  for (const int representation : { VTK_WIREFRAME, VTK_SURFACE })
  {
    Walk(scene, 1);
    scene.Change(ChangeKind::Representation, hidden, { static_cast<double>(representation) });
    scene.ExpectVerdict({ before }, Verdict::SharedMapper);
    scene.ExpectDecision(Decision::Blending);
  }
  Walk(scene, 4);
  scene.ExpectVerdict({ hidden }, Verdict::Hidden);
  return scene.Finish();
}

/// Two large props that share a mapper are divided in the first two frames. Returns their numbers.
std::pair<int, int> AddDividedSharers(HazardBuilder& scene)
{
  scene.Scene.Culler.MinimumNumberOfPrimitives = 2;
  const int first = scene.Sphere({ -2.0, 0.0, 0.0 }, 1.5).Id;
  Prop& second = scene.Sphere({ 0.0, 0.0, 0.0 }, 1.0);
  second.Position.x = 2.0;
  second.MapperOf = first;
  const int other = second.Id;
  scene.Scene.Props[first].Flat = scene.Scene.Props[other].Flat = true;
  scene.Sphere({ 2.0, 40.0, 0.0 }, 1.0);
  scene.LookAtWall();
  Walk(scene, 2);
  return { first, other };
}

/// Large props that share a mapper have been divided, and one of them has needed other shaders
/// since. They leave the renderer's list and come back, which must not make their shaders anew.
NamedScenario DividedPropsLeaveTheList(DefaultCuller culler)
{
  HazardBuilder scene("DividedPropsLeaveTheList");
  scene.Scene.Culler.DefaultCuller = culler;
  const auto [first, other] = AddDividedSharers(scene);
  scene.Change(ChangeKind::Representation, first, { static_cast<double>(VTK_WIREFRAME) });
  Walk(scene, 1);
  scene.Change(ChangeKind::Color, other, { 1.0, 0.5, 0.0 });
  Walk(scene, 1);
  for (const double visible : { 0.0, 1.0 })
  {
    Walk(scene, 1);
    if (culler == DefaultCuller::NoTakeOver)
    {
      scene.LookFrom(
        { 0.0, visible > 0.0 ? 0.0 : 40.0, 20.0 }, { 0.0, visible > 0.0 ? 0.0 : 40.0, 0.0 });
    }
    else
    {
      scene.Change(ChangeKind::Visible, first, { visible });
      scene.Change(ChangeKind::Visible, other, { visible });
    }
  }
  Walk(scene, 2);
  scene.ExpectVerdict({ other }, Verdict::SharedMapper);
  return scene.Finish();
}

/// Large props that share a mapper have been divided and leave the renderer's list. When they come
/// back, one of them needs other shaders. The first of them still has those that it had before.
NamedScenario DividedPropsComeBackChanged()
{
  HazardBuilder scene("DividedPropsComeBackChanged");
  const auto [first, other] = AddDividedSharers(scene);
  for (const double visible : { 0.0, 1.0 })
  {
    Walk(scene, 1);
    scene.Change(ChangeKind::Visible, first, { visible });
    scene.Change(ChangeKind::Visible, other, { visible });
  }
  scene.Change(ChangeKind::Representation, other, { static_cast<double>(VTK_WIREFRAME) });
  Walk(scene, 2);
  scene.ExpectVerdict({ first }, Verdict::SharedMapper);
  return scene.Finish();
}
}

std::vector<NamedScenario> GetSharedHazards()
{
  return { TexturesOfPropsOutside(), SurfaceAndWireframe(), HiddenActorMakesShaders(),
    DividedPropsLeaveTheList(DefaultCuller::NoTakeOver),
    DividedPropsLeaveTheList(DefaultCuller::Removed), DividedPropsComeBackChanged() };
}
}
