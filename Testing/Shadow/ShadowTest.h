// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowTest.h
 * @brief What shadow tests share: the window of a scene, and comparing a mask with the oracle.
 */
#ifndef ShadowTest_h
#define ShadowTest_h

#include "Judge.h"
#include "NamedScenarios.h"
#include "OffscreenFixture.h"
#include "Pixels.h"
#include "RayOracle.h"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

using TestScene::FindDifference;
using TestScene::NamedScenario;
using TestScene::Picture;
using TestScene::Stage;
using TestScene::TakePicture;

namespace TestScene
{
/// GoogleTest prints the name.
inline void PrintTo(const NamedScenario& scene, std::ostream* stream)
{
  *stream << scene.Name;
}
}

/// All scenes in which shadows have gone wrong somewhere, and larger ones.
std::vector<NamedScenario> GetScenarios();
/// One of them by name; throws std::out_of_range.
NamedScenario GetScenario(const std::string& name);

/// The first frame of a scene, in a window of its size that has not rendered yet, with the scene's
/// lights.
Stage SetStage(const NamedScenario& scene);
/// A scene as scenarios describe it; points are stored in double precision.
Stage SetStage(const std::function<void(TestScene::SceneBuilder&)>& build, int width = 200,
  int height = 150, int multiSamples = 0);
/// A scene of GetScenarios().
Stage SetNamedStage(const std::string& name);
/// Adds what a scene describes to the stage.
void FillStage(const Stage& stage, const NamedScenario& scene);
/// What happens in the scene's second frame. Returns false if it has only one.
bool ChangeStage(const Stage& stage, const NamedScenario& scene);

/// The pixels of the window that the renderer fills.
vtkNBufferRectangle GetPixels(vtkRenderer* renderer);

/// The actors of a renderer and those of its assemblies, in the order in which they were added.
std::vector<vtkActor*> GetActors(vtkRenderer* renderer);

/// A mask: one value for each pixel of the viewport, row by row, the lowest first; not 0: shadowed.
using ShadowMask = std::vector<unsigned char>;

struct MaskComparison
{
  int Samples = 0;            ///< Compared: lit or shadowed by the oracle.
  int Shadowed = 0;           ///< Of these, shadowed by the oracle.
  int Wrong = 0;              ///< They differ and are not ambiguous.
  int AmbiguousDiffering = 0; ///< They differ and are ambiguous.
  int FirstWrong[2] = { -1, -1 };
};

std::ostream& operator<<(std::ostream& stream, const MaskComparison& comparison);

/// The mask's size has to be the oracle's.
MaskComparison CompareMask(const ShadowMask& mask, const OracleImage& oracle);

/// The oracle's own answer as a mask; what is not compared is 0.
ShadowMask MakeMask(const OracleImage& oracle);

/// For EXPECT_TRUE: no sample is wrong. Says how many are and where, else the counts.
::testing::AssertionResult MatchesOracle(const ShadowMask& mask, const OracleImage& oracle);

/// Lit or in shadow: what masks are compared for.
bool IsLitOrShadowed(const OracleImage& oracle, std::size_t pixel);

#endif
