// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioWindow.h
 * @brief What a scenario says of its window, renderers and culler.
 */
#ifndef ScenarioWindow_h
#define ScenarioWindow_h

#include "ScenarioNames.h"

#include <array>

namespace TestScene
{
enum class PassKind
{
  None,
  RenderSteps,
  OpaqueTranslucent, ///< Lights, opaque, translucent, volumetric, overlay.
  OpaqueTwice,
  TranslucentFirst,
  Default, ///< Lights, vtkDefaultPass.
  DepthPeeling,
  DualDepthPeeling,
  SSAO,
  FXAA,
  Framebuffer,            ///< One that the culler does not know.
  Sobel,                  ///< One that the culler does not know.
  ShadowVolumes,          ///< vtkShadowVolumeClampPass as the pass of the renderer.
  ShadowVolumesInSequence ///< In the place of the opaque pass of OpaqueTranslucent.
};
NBUFFER_SCENE_NAMES(PassKind, "None", "RenderSteps", "OpaqueTranslucent", "OpaqueTwice",
  "TranslucentFirst", "Default", "DepthPeeling", "DualDepthPeeling", "SSAO", "FXAA", "Framebuffer",
  "Sobel", "ShadowVolumes", "ShadowVolumesInSequence");

struct Renderer
{
  std::array<double, 4> Viewport = { 0.0, 0.0, 1.0, 1.0 };
  int Layer = 0;
  bool Erase = true;
  bool PreserveDepth = false;
  bool SharesCamera = false; ///< With renderer 0.
  bool SharesProps = false;  ///< All props of renderer 0 are in it as well.
  PassKind Pass = PassKind::None;
  bool SSAO = false;
  bool FXAA = false;
  bool DepthPeeling = false;
  bool OIT = true;
  bool HiddenLines = false;
  bool Shadows = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("viewport", self.Viewport);
    visit("layer", self.Layer);
    visit("erase", self.Erase);
    visit("preserve_depth", self.PreserveDepth);
    visit("shares_camera", self.SharesCamera);
    visit("shares_props", self.SharesProps);
    visit("pass", self.Pass);
    visit("ssao", self.SSAO);
    visit("fxaa", self.FXAA);
    visit("depth_peeling", self.DepthPeeling);
    visit("oit", self.OIT);
    visit("hidden_lines", self.HiddenLines);
    visit("shadows", self.Shadows);
  }
};

struct Window
{
  int Width = 96;
  int Height = 80;
  int MultiSamples = 0;
  bool StencilCapable = false;
  bool LineSmoothing = false;
  int Stereo = -1; ///< A stereo type of VTK.
  int TileScale = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("width", self.Width);
    visit("height", self.Height);
    visit("multi_samples", self.MultiSamples);
    visit("stencil_capable", self.StencilCapable);
    visit("line_smoothing", self.LineSmoothing);
    visit("stereo", self.Stereo);
    visit("tile_scale", self.TileScale);
  }
};

//------------------------------------------------------------------------------------------------
enum class DefaultCuller
{
  Removed,
  Before, ///< vtkFrustumCoverageCuller where VTK puts it.
  Behind,
  NoTakeOver ///< Before, with TakeOverFrustumCulling off.
};
NBUFFER_SCENE_NAMES(DefaultCuller, "Removed", "Before", "Behind", "NoTakeOver");

/// Properties of vtkNBufferCuller of the same names, and how it is added.
struct Culler
{
  TestScene::DefaultCuller DefaultCuller = TestScene::DefaultCuller::Removed;
  bool OnePerRenderer = false;
  int AddedInFrame = 0;
  int Backend = 0;
  int BaseFactor = 4;
  int MinimumNumberOfCandidates = 1;
  int MaximumNumberOfRounds = 6;
  int RoundSize = 8;
  int MaximumNumberOfPieces = 8;
  int HierarchySize = 10000;
  bool TestPixels = true;
  int TestSlivers = 0;
  bool ReuseWhenStill = true;
  bool BackOff = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("default_culler", self.DefaultCuller);
    visit("one_per_renderer", self.OnePerRenderer);
    visit("added_in_frame", self.AddedInFrame);
    visit("backend", self.Backend);
    visit("base_factor", self.BaseFactor);
    visit("minimum_number_of_candidates", self.MinimumNumberOfCandidates);
    visit("maximum_number_of_rounds", self.MaximumNumberOfRounds);
    visit("round_size", self.RoundSize);
    visit("maximum_number_of_pieces", self.MaximumNumberOfPieces);
    visit("hierarchy_size", self.HierarchySize);
    visit("test_pixels", self.TestPixels);
    visit("test_slivers", self.TestSlivers);
    visit("reuse_when_still", self.ReuseWhenStill);
    visit("back_off", self.BackOff);
  }
};
}

#endif
