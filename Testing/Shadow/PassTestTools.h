// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PassTestTools.h
 * @brief What tests of vtkShadowVolumeClampPass share: images, and what they have to be.
 */
#ifndef PassTestTools_h
#define PassTestTools_h

#include "../Leaks/GLObjects.h"
#include "GLStateSnapshot.h"
#include "ShadowTest.h"
#include "StatisticsCheck.h"

#include "vtkShadowVolumeClampPass.h"

#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

/// The modes that draw volumes, each in its own way.
constexpr int ShadowModes[] = { vtkShadowVolumeClampPass::Unclamped,
  vtkShadowVolumeClampPass::Scissored, vtkShadowVolumeClampPass::Clamped };

/// The pass as the pass of the stage's renderer, with Scissored: small scenes are not worth a
/// litmap.
vtkSmartPointer<vtkShadowVolumeClampPass> AddPass(const Stage& stage);

/// The places of the samples in a pixel of a window that has rendered, in [0, 1] from the lower
/// left corner; one, the centre, without multisampling.
std::vector<std::array<double, 2>> GetSamplePlaces(vtkRenderWindow* window);

/// The mask of the last frame, or one sample of it; all 0, of `pixels` values, if nothing was in
/// shadow.
ShadowMask GetMask(
  vtkShadowVolumeClampPass* pass, vtkLight* light, std::size_t pixels, int sample = -1);
/// Of a light of the stage.
ShadowMask GetMask(
  const Stage& stage, vtkShadowVolumeClampPass* pass, std::size_t light = 0, int sample = -1);
/// Of all lights.
std::vector<ShadowMask> GetMasks(const Stage& stage, vtkShadowVolumeClampPass* pass);
int CountShadowed(const ShadowMask& mask); ///< Wholly: 255.

/// Number of pixels of a renderer.
std::size_t CountPixels(vtkRenderer* renderer);

/// What OpenGL is left as when the renderer has drawn the next frame.
GLStateSnapshot CaptureFrame(const Stage& stage);

/// The OpenGL objects of the window's context.
GLObjects::Counts CountObjects(const Stage& stage);
/// Programs stay in the window's cache.
GLObjects::Counts CountObjectsWithoutPrograms(const Stage& stage);

/// The image of the next frame.
Picture RenderPicture(const Stage& stage);

/// Renders and compares the masks of all lights of the scene with rays, sample by sample.
void ExpectMatchesOracle(const Stage& stage, vtkShadowVolumeClampPass* pass);

/// The same in all modes, and that Scissored has the masks of Unclamped wherever the light reaches.
void ExpectAllModesMatchOracle(const Stage& stage, vtkShadowVolumeClampPass* pass);

/**
 * Render, and compare each pixel of the image with one of the images without the pass in which
 * lights are dimmed to 1 - ShadowAttenuation: that in which the lights are dim whose masks are 255
 * there. Masks are of nothing but 0 and 255; with multisampling, pixels in which a light has
 * another mean are left out. The stage has one renderer and at most six lights that
 * cast; colours are exact for attenuations of 0, 0.5 and 1. Returns the number of shadowed pixels
 * of all lights. The renderer has the pass again afterwards.
 */
int ExpectComposedOfDimmed(const Stage& stage, vtkShadowVolumeClampPass* pass);

/// The image of the renderer with vtkRenderStepsPass; its pass is as before afterwards.
Picture GetPlainImage(vtkRenderWindow* window, vtkRenderer* renderer);

#endif
