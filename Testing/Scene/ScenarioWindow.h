// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioWindow.h
 * @brief The window, the renderers and the culler of a scenario.
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
  OpaqueTranslucent, ///< The passes for lights, opaque, translucent, volumetric and overlay props.
  OpaqueTwice,
  TranslucentFirst,
  Default, ///< vtkLightsPass and vtkDefaultPass.
  DepthPeeling,
  DualDepthPeeling,
  SSAO,
  FXAA,
  Framebuffer,             ///< vtkFramebufferPass, which the culler does not know.
  Sobel,                   ///< vtkSobelGradientMagnitudePass, which the culler does not know.
  ShadowVolumes,           ///< vtkShadowVolumeClampPass as the pass of the renderer.
  ShadowVolumesInSequence, ///< In the place of the opaque pass of OpaqueTranslucent.
  SSAA,
  Reversed ///< OpaqueTranslucent with reversed depth, to which the camera projects.
};
NBUFFER_SCENE_NAMES(PassKind, "None", "RenderSteps", "OpaqueTranslucent", "OpaqueTwice",
  "TranslucentFirst", "Default", "DepthPeeling", "DualDepthPeeling", "SSAO", "FXAA", "Framebuffer",
  "Sobel", "ShadowVolumes", "ShadowVolumesInSequence", "SSAA", "Reversed");

struct Renderer
{
  std::array<double, 4> Viewport = { 0.0, 0.0, 1.0, 1.0 };
  int Layer = 0;
  bool Erase = true;
  bool PreserveDepth = false;
  bool SharesCamera = false; ///< Whether it has the camera of renderer 0.
  bool SharesProps = false;  ///< Whether all props of renderer 0 are in this one as well.
  PassKind Pass = PassKind::None;
  bool InfiniteFar = false; ///< Whether a reversed pass has its far plane in the infinite.
  bool SSAO = false;
  bool FXAA = false;
  bool DepthPeeling = false;
  bool OIT = true;
  bool HiddenLines = false;
  bool Shadows = false;

  NBUFFER_SCENE_MEMBERS(Viewport, Layer, Erase, PreserveDepth, SharesCamera, SharesProps, Pass,
    InfiniteFar, SSAO, FXAA, DepthPeeling, OIT, HiddenLines, Shadows);
};

struct Window
{
  int Width = 96;
  int Height = 80;
  int MultiSamples = 0;
  bool StencilCapable = false;
  bool LineSmoothing = false;
  int Stereo = -1; ///< A stereo type of VTK; -1: no stereo.
  int TileScale = 1;

  NBUFFER_SCENE_MEMBERS(
    Width, Height, MultiSamples, StencilCapable, LineSmoothing, Stereo, TileScale);
};

//------------------------------------------------------------------------------------------------
/// Where vtkFrustumCoverageCuller, VTK's default culler, is in the list of cullers.
enum class DefaultCuller
{
  Removed,
  Before,    ///< Before vtkNBufferCuller, where VTK puts it.
  Behind,    ///< After vtkNBufferCuller.
  NoTakeOver ///< As Before, with TakeOverFrustumCulling off.
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
  int HierarchySize = 10000;
  int ObserveAfter = 60;
  bool TestTriangles = true;
  bool TestPixels = true;
  bool TestSlivers = true;
  bool DivideProps = true;
  int MinimumNumberOfPrimitives = 20000;
  int UnitSize = 64;
  bool ReuseWhenStill = true;
  bool BackOff = false;

  NBUFFER_SCENE_MEMBERS(DefaultCuller, OnePerRenderer, AddedInFrame, Backend, BaseFactor,
    MinimumNumberOfCandidates, MaximumNumberOfRounds, RoundSize, HierarchySize, ObserveAfter,
    TestTriangles, TestPixels, TestSlivers, DivideProps, MinimumNumberOfPrimitives, UnitSize,
    ReuseWhenStill, BackOff);
};
}

#endif
