// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PassTestTools.h
 * @brief What tests of vtkShadowVolumeClampPass share: reading masks and images, and checking them.
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

#include <vector>

/// The modes that differ in how they draw volumes.
constexpr int ShadowModes[] = { vtkShadowVolumeClampPass::Unclamped,
  vtkShadowVolumeClampPass::Scissored, vtkShadowVolumeClampPass::Clamped };

/// Makes a pass with the mode Scissored, and sets it as the pass of the stage's renderer. (The mode
/// Automatic would use no litmaps in scenes as small as those of the tests.)
vtkSmartPointer<vtkShadowVolumeClampPass> AddPass(const Stage& stage);

///@{
/// Return the mask of the last frame, as the mean of each pixel's samples or, for `sample` >= 0, of
/// one sample. If nothing was in shadow, the mask has `pixels` values, all 0.
ShadowMask GetMask(
  vtkShadowVolumeClampPass* pass, vtkLight* light, std::size_t pixels, int sample = -1);
ShadowMask GetMask(
  const Stage& stage, vtkShadowVolumeClampPass* pass, std::size_t light = 0, int sample = -1);
///@}
/// Returns the masks of all lights of the stage.
std::vector<ShadowMask> GetMasks(const Stage& stage, vtkShadowVolumeClampPass* pass);
/// Returns the number of pixels that are wholly in shadow (255).
int CountShadowed(const ShadowMask& mask);

/// Returns the number of pixels of a renderer's viewport.
std::size_t CountPixels(vtkRenderer* renderer);

/// Renders a frame, and returns the OpenGL state after the renderer's draw.
GLStateSnapshot CaptureFrame(const Stage& stage);

/// Returns the numbers of OpenGL objects in the window's context.
GLObjects::Counts CountObjects(const Stage& stage);
/// Returns these numbers without programs and shaders, which stay in the window's cache.
GLObjects::Counts CountObjectsWithoutPrograms(const Stage& stage);

/// Renders a frame, and returns its image.
Picture RenderPicture(const Stage& stage);

/// Renders, and expects that the masks of all lights of the stage match the rays, sample by sample.
void ExpectMatchesOracle(const Stage& stage, vtkShadowVolumeClampPass* pass);

/// Expects the same in each of ShadowModes, and that the masks of Scissored equal those of
/// Unclamped in all samples that rays find lit or shadowed.
void ExpectAllModesMatchOracle(const Stage& stage, vtkShadowVolumeClampPass* pass);

/**
 * Renders, and compares the image with images without the pass, one for each set of lights, in
 * which the lights of the set are dimmed to 1 - ShadowAttenuation. A pixel must equal that of the
 * image in which those lights are dimmed whose masks are 255 there. Without multisampling masks
 * must have no other values than 0 and 255; with multisampling, pixels with other values are not
 * compared.
 *
 * The stage has one renderer and at most six lights that cast. Colours are exact for attenuations
 * of 0, 0.5 and 1. Returns the number of shadowed pixels of all lights. The renderer has the pass
 * again afterwards.
 */
int ExpectComposedOfDimmed(const Stage& stage, vtkShadowVolumeClampPass* pass);

/// Returns the window's image without the renderer's pass, which is restored.
Picture GetPlainImage(vtkRenderWindow* window, vtkRenderer* renderer);

#endif
