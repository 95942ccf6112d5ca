// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Families.h"

#include "vtkRenderWindow.h"

namespace TestScene
{
namespace
{
/// Render passes and the other ways to draw of one renderer.
void MakePasses(Writer& writer, Renderer& renderer)
{
  if (writer.Chance(0.12))
  {
    renderer.Pass = writer.Any({ PassKind::RenderSteps, PassKind::OpaqueTranslucent,
      PassKind::OpaqueTwice, PassKind::TranslucentFirst, PassKind::Default, PassKind::DepthPeeling,
      PassKind::DualDepthPeeling, PassKind::SSAO, PassKind::FXAA, PassKind::Framebuffer,
      PassKind::Sobel, PassKind::SSAA });
  }
  renderer.SSAO = writer.Chance(0.04);
  renderer.FXAA = writer.Chance(0.04);
  renderer.DepthPeeling = writer.Chance(0.08);
  renderer.OIT = writer.Chance(0.5);
  renderer.HiddenLines = writer.Chance(0.01);
  renderer.Shadows = writer.Chance(0.005);
}
}

void MakeWindow(Writer& writer)
{
  Window& window = writer.Scene.Window;
  window.Width = writer.Integer(40, 160);
  window.Height = writer.Integer(40, 130);
  if (writer.Chance(0.08))
  {
    window.Width = writer.Any({ 1, 2, 3, 7, 33, 300 });
    window.Height = writer.Any({ 1, 2, 5, 64, 250 });
  }
  const bool slits = writer.Scene.Family == "slits";
  if (writer.Chance(slits ? 0.5 : 0.15))
  {
    window.MultiSamples = writer.Any({ 2, 4, 4, 8 });
  }
  window.StencilCapable = writer.Chance(0.03);
  window.LineSmoothing = writer.Chance(0.02);
  if (writer.Chance(0.04))
  {
    window.Stereo = writer.Any({ VTK_STEREO_RED_BLUE, VTK_STEREO_INTERLACED, VTK_STEREO_LEFT,
      VTK_STEREO_RIGHT, VTK_STEREO_CHECKERBOARD, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL });
  }
  window.TileScale = writer.Chance(0.02) ? 2 : 1;
}

void MakeCuller(Writer& writer)
{
  Culler& culler = writer.Scene.Culler;
  const bool isMoved = writer.Chance(0.3);
  culler.DefaultCuller = isMoved
    ? writer.Any({ DefaultCuller::Before, DefaultCuller::Behind, DefaultCuller::NoTakeOver })
    : culler.DefaultCuller;
  culler.OnePerRenderer = writer.Chance(0.3);
  culler.AddedInFrame = writer.Chance(0.05) ? 1 : 0;
  culler.Backend = writer.Any({ 0, 1, 1, 2 });
  culler.BaseFactor = writer.Any({ 1, 1, 2, 4, 4, 8 });
  culler.MinimumNumberOfCandidates = writer.Chance(0.1) ? writer.Integer(1, 40) : 1;
  culler.MaximumNumberOfRounds = writer.Integer(1, 8);
  culler.RoundSize = writer.Any({ 1, 2, 4, 8, 12, 64 });
  // Not drawn, so that the rest of a scenario stays what it was for its seed.
  culler.HierarchySize = writer.Scene.Seed % 3 == 0 ? culler.HierarchySize : 0;
  culler.TestTriangles = writer.Scene.Seed % 3 != 0;
  culler.ObserveAfter = writer.Scene.Seed % 4 == 0 ? 0 : 1;
  culler.TestPixels = writer.Chance(0.6);
  culler.ReuseWhenStill = writer.Chance(0.8);
  culler.BackOff = writer.Chance(0.1);
  culler.MinimumNumberOfPrimitives = writer.Any({ 2, 6, 50, 20000, 20000 });
  culler.UnitSize = writer.Any({ 1, 2, 5, 20 });
}

void MakeRenderers(Writer& writer)
{
  Scenario& scene = writer.Scene;
  MakePasses(writer, scene.Renderers[0]);
  if (writer.Chance(0.2))
  {
    scene.Renderers[0].Viewport = { writer.Between(0.0, 0.3), writer.Between(0.0, 0.3),
      writer.Between(0.7, 1.0), writer.Between(0.7, 1.0) };
  }
  if (!writer.Chance(0.12))
  {
    return;
  }
  Renderer second;
  MakePasses(writer, second);
  switch (writer.Integer(0, 3))
  {
    case 0: // beside it, with the same props
      second.SharesProps = true;
      second.Viewport = { 0.5, 0.0, 1.0, 1.0 };
      scene.Renderers[0].Viewport = { 0.0, 0.0, 0.5, 1.0 };
      break;
    case 1: // the same camera in another shape
      second.SharesProps = second.SharesCamera = true;
      second.Viewport = { 0.0, 0.6, 1.0, 1.0 };
      scene.Renderers[0].Viewport = { 0.0, 0.0, 1.0, 0.6 };
      break;
    case 2: // a layer over it
      second.Layer = 1;
      second.SharesCamera = true;
      second.PreserveDepth = writer.Chance(0.5);
      break;
    default: // over it without erasing
      second.SharesCamera = writer.Chance(0.5);
      second.Erase = false;
      break;
  }
  if (second.SharesProps)
  {
    // VTK draws unlit props with the shaders of the other renderer (docs/limits.md).
    second.Shadows = scene.Renderers[0].Shadows = false;
  }
  scene.Renderers.push_back(second);
  if (!second.SharesProps)
  {
    for (Prop& prop : scene.Props)
    {
      prop.Renderer = writer.Chance(0.4) ? 1 : 0;
    }
  }
  if (!second.SharesCamera)
  {
    const std::size_t views = scene.Views.size();
    for (std::size_t i = 0; i < views; ++i)
    {
      View view = scene.Views[i];
      view.Renderer = 1;
      view.Position[0] += 0.2 * writer.Scale;
      scene.Views.push_back(view);
    }
  }
}
}
