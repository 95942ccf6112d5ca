// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PassTestTools.h
 * @brief What tests of vtkShadowVolumeClampPass share: images, and what they have to be.
 */
#ifndef PassTestTools_h
#define PassTestTools_h

#include "ShadowTest.h"
#include "StatisticsCheck.h"

#include "vtkShadowVolumeClampPass.h"

#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

/// What differs in the stage's renderer alone. What lies outside of it, in a tile of a larger
/// image, is not drawn at all.
std::string FindDifferenceInView(
  const Stage& stage, const Picture& expected, const Picture& actual);

/// The pass as the pass of the stage's renderer, with Exact: small scenes are not worth a litmap.
vtkSmartPointer<vtkShadowVolumeClampPass> AddPass(const Stage& stage);

/// The places of the samples in a pixel of a window that has rendered, in [0, 1] from the lower
/// left corner; one, the centre, without multisampling.
std::vector<std::array<double, 2>> GetSamplePlaces(vtkRenderWindow* window);

/// The mask of the last frame, or one sample of it; all 0, of `pixels` values, if nothing was in
/// shadow.
ShadowMask GetMask(
  vtkShadowVolumeClampPass* pass, vtkLight* light, std::size_t pixels, int sample = -1);

/// Number of pixels of a renderer.
std::size_t CountPixels(vtkRenderer* renderer);

/// Renders and compares the masks of all lights of the scene with rays, sample by sample.
void ExpectMatchesOracle(const Stage& stage, vtkShadowVolumeClampPass* pass);

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
