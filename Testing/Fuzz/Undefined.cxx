// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Undefined.h"

#include "ScenePasses.h"

#include "vtkNBufferVTKVersion.h"

#include "vtkRenderWindow.h"

#include <algorithm>
#include <optional>

namespace TestScene
{
namespace
{
/// Whether a renderer of the scenario has such a pass from the beginning or is given one by a
/// change.
template <typename Predicate>
bool HasPass(const Scenario& scene, const Predicate& predicate)
{
  return std::any_of(scene.Renderers.begin(), scene.Renderers.end(),
           [&predicate](const Renderer& renderer) { return predicate(renderer.Pass); }) ||
    std::any_of(scene.Changes.begin(), scene.Changes.end(),
      [&predicate](const Change& change)
      {
        return change.Kind == ChangeKind::Pass && !change.Values.empty() &&
          predicate(static_cast<PassKind>(static_cast<int>(change.Values.front())));
      });
}

void RemoveChanges(Scenario& scene, ChangeKind kind, std::optional<int> target = {})
{
  scene.Changes.erase(
    std::remove_if(scene.Changes.begin(), scene.Changes.end(),
      [kind, target](const Change& change)
      { return change.Kind == kind && change.Target == target.value_or(change.Target); }),
    scene.Changes.end());
}

bool HasChange(const Scenario& scene, ChangeKind kind, int target)
{
  return std::any_of(scene.Changes.begin(), scene.Changes.end(),
    [kind, target](const Change& change)
    { return change.Kind == kind && change.Target == target; });
}

/// Sets the clipping ranges of those views for which VTK would compute them from the bounds of
/// props.
void SetClippingRanges(std::vector<View>& views)
{
  for (View& view : views)
  {
    if (view.Near == 0.0 && view.Far == 0.0)
    {
      const double distance = glm::length(view.Position - view.FocalPoint);
      view.Near = 0.02 * distance;
      view.Far = 10.0 * distance;
    }
  }
}

bool IsSSAO(PassKind pass)
{
  return pass == PassKind::SSAO;
}

bool HasAmbientOcclusion(const Scenario& scene)
{
  return HasPass(scene, IsSSAO) ||
    std::any_of(scene.Renderers.begin(), scene.Renderers.end(),
      [](const Renderer& renderer) { return renderer.SSAO; }) ||
    std::any_of(scene.Changes.begin(), scene.Changes.end(),
      [](const Change& change) { return change.Kind == ChangeKind::SSAO; });
}

/// Sets the renderers of parts to those in which they are drawn, with the assemblies before them.
void SetRenderersOfParts(Scenario& scene)
{
  for (Prop& part : scene.Props)
  {
    const auto whole = std::find_if(scene.Props.begin(), scene.Props.end(),
      [&part](const Prop& prop) { return prop.Id == part.PartOf; });
    part.Renderer = whole != scene.Props.end() ? whole->Renderer : part.Renderer;
  }
}

/// Whether a prop may have the mapper of its MapperOf. VTK crashes with a follower that has no
/// mapper, and if only one of two actors with the same mapper has a property of back faces. The
/// culler does not examine props of other renderers (docs/limits.md).
bool MayShareMapper(const Scenario& scene, const Prop& prop)
{
  return std::none_of(scene.Props.begin(), scene.Props.end(),
    [&prop](const Prop& owner)
    {
      return owner.Id == prop.MapperOf &&
        (owner.Renderer != prop.Renderer || (owner.BackOpacity < 1.0) != (prop.BackOpacity < 1.0) ||
          (owner.Kind == PropKind::NoMapper && prop.Kind == PropKind::Follower));
    });
}
}

void RemoveUndefined(Scenario& scene)
{
  SetRenderersOfParts(scene);
  // Each composite mapper keeps a texture unit (docs/limits.md), of which there may be only 32.
  int left = 24;
  for (Prop& prop : scene.Props)
  {
    if (prop.Kind == PropKind::Composite && left-- <= 0)
    {
      prop.Kind = PropKind::Actor;
    }
  }
  if (std::any_of(scene.Props.begin(), scene.Props.end(),
        [](const Prop& prop) { return prop.Kind == PropKind::Splats; }))
  {
    // VTK does not make the shaders of splats anew when its global offsets of polygons change. A
    // new pass does, and property keys that a pass gives to an actor that has none.
    RemoveChanges(scene, ChangeKind::PolygonOffset);
    RemoveChanges(scene, ChangeKind::NewContext);
  }
  for (Prop& prop : scene.Props)
  {
    // Without a culler that reads bounds VTK finds out whether the scalars are translucent before
    // the filter has run.
    if (prop.Kind == PropKind::Piped && prop.Scalars == Translucency::Some)
    {
      prop.Kind = PropKind::Actor;
    }
    // VTK does not notice that a block has moved: its bounds are those of the time when they were
    // computed last, which may be earlier with a culler than without one. Its own culler leaves the
    // prop out by these bounds.
    if (prop.Kind == PropKind::Composite && HasChange(scene, ChangeKind::MovePoints, prop.Id))
    {
      SetClippingRanges(scene.Views);
      scene.Culler.DefaultCuller = DefaultCuller::Removed;
    }
    // VTK keeps the opacity of instances until mapper or data change (docs/limits.md).
    if (prop.Kind == PropKind::Glyphs)
    {
      RemoveChanges(scene, ChangeKind::Opacity, prop.Id);
    }
    // VTK draws a selection of a mapper from buffers that it has released, also with another actor
    // of the mapper, and crashes. Where the prop has edges, the colors of the selection are
    // arbitrary.
    if (HasChange(scene, ChangeKind::MarkedCells, prop.Id))
    {
      prop.Edges = false;
      RemoveChanges(scene, ChangeKind::Edges, prop.Id);
      const auto getMapper = [](const Prop& p) { return p.MapperOf >= 0 ? p.MapperOf : p.Id; };
      for (const Prop& other : scene.Props)
      {
        if (getMapper(other) == getMapper(prop))
        {
          RemoveChanges(scene, ChangeKind::Rejoin, other.Id);
        }
      }
      RemoveChanges(scene, ChangeKind::NewContext);
    }
    if (!MayShareMapper(scene, prop))
    {
      prop.MapperOf = -1;
    }
    // Glyphs of lines are as wide as the lines drawn before them (docs/limits.md).
    if (prop.Kind == PropKind::Glyphs && prop.Representation == Representation::Wireframe)
    {
      prop.Representation = Representation::Surface;
    }
    // VTK 9.1 does not compile the shader of clipped glyphs with edges, and crashes. It draws
    // splats with edges in another color each time.
    if (prop.Kind == PropKind::Splats ||
      (prop.Kind == PropKind::Glyphs &&
        (!prop.ClippingPlane.empty() || HasChange(scene, ChangeKind::ClippingPlane, prop.Id))))
    {
      prop.Edges = false;
      RemoveChanges(scene, ChangeKind::Edges, prop.Id);
    }
  }
  if (std::any_of(scene.Renderers.begin(), scene.Renderers.end(),
        [](const Renderer& renderer) { return renderer.Shadows; }))
  {
    // VTK cannot compile the shader of an unlit prop with shadow maps, and draws the prop with
    // whatever program was bound before.
    for (Prop& prop : scene.Props)
    {
      prop.Lighting = true;
    }
  }
  if (HasAmbientOcclusion(scene))
  {
    // Ambient occlusion does not clear its framebuffer if the renderer does not erase. Before VTK
    // 9.7 it shows undrawn parts of it in a renderer that fills a part of a window.
    for (Renderer& renderer : scene.Renderers)
    {
      renderer.Erase = true;
#if !VTKNBUFFER_HAS_SSAO_IN_PARTS
      renderer.Viewport = { 0.0, 0.0, 1.0, 1.0 };
#endif
    }
    // It blends normals, and those of flat triangles may be NaN, also in front of them
    // (docs/limits.md).
    for (Prop& prop : scene.Props)
    {
      prop.Flat = false;
    }
#if !VTKNBUFFER_HAS_SSAO_IN_PARTS
    RemoveChanges(scene, ChangeKind::Viewport);
#endif
  }
  // Split stereo scales the whole window, with what earlier frames left outside of the viewports.
  // Windows that have drawn different numbers of frames differ, as they do with shadows.
  if (HasPass(scene, HasShadowVolumes) &&
    scene.Window.Stereo == VTK_STEREO_SPLITVIEWPORT_HORIZONTAL)
  {
    scene.Window.Stereo = VTK_STEREO_CHECKERBOARD;
  }
  if (HasPass(scene, HasShadowVolumes))
  {
    const bool sharesProps = std::any_of(scene.Renderers.begin(), scene.Renderers.end(),
      [](const Renderer& renderer) { return renderer.SharesProps; });
    for (Prop& prop : scene.Props)
    {
      // In a second renderer VTK draws a billboard where it was in the first one, unless this was
      // modified since. Giving it a new pass, as the reference does in each frame, modifies it.
      if (prop.Kind == PropKind::Billboard && sharesProps)
      {
        prop.Kind = PropKind::Actor;
      }
    }
  }
  // With a render pass, a selector draws props before it has set their numbers.
  if (HasPass(scene, [](PassKind pass) { return pass != PassKind::None; }))
  {
    RemoveChanges(scene, ChangeKind::Select);
  }
  // An overlay inside of an SSAO pass writes to only one of three attachments.
  if (HasPass(scene, IsSSAO))
  {
    for (Prop& prop : scene.Props)
    {
      prop.Kind = prop.Kind == PropKind::Text ? PropKind::Actor : prop.Kind;
    }
  }
}
}
