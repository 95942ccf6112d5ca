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
  Framebuffer,             ///< One that the culler does not know.
  Sobel,                   ///< One that the culler does not know.
  ShadowVolumes,           ///< vtkShadowVolumeClampPass as the pass of the renderer.
  ShadowVolumesInSequence, ///< In the place of the opaque pass of OpaqueTranslucent.
  SSAA
};
NBUFFER_SCENE_NAMES(PassKind, "None", "RenderSteps", "OpaqueTranslucent", "OpaqueTwice",
  "TranslucentFirst", "Default", "DepthPeeling", "DualDepthPeeling", "SSAO", "FXAA", "Framebuffer",
  "Sobel", "ShadowVolumes", "ShadowVolumesInSequence", "SSAA");

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

  NBUFFER_SCENE_MEMBERS(Viewport, Layer, Erase, PreserveDepth, SharesCamera, SharesProps, Pass,
    SSAO, FXAA, DepthPeeling, OIT, HiddenLines, Shadows);
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

  NBUFFER_SCENE_MEMBERS(
    Width, Height, MultiSamples, StencilCapable, LineSmoothing, Stereo, TileScale);
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
  int HierarchySize = 10000;
  int ObserveAfter = 60;
  bool TestTriangles = true;
  bool TestPixels = true;
  bool TestSlivers = false;
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
