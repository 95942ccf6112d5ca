// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowTest.h
 * @brief What shadow tests share: stages for their scenes, and comparing a mask with the ray oracle
 * (RayOracle.h).
 */
#ifndef ShadowTest_h
#define ShadowTest_h

#include "Judge.h"
#include "NamedScenarios.h"
#include "OffscreenFixture.h"
#include "Pixels.h"
#include "RayOracle.h"
#include "SceneBuilder.h"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

using Point = glm::dvec3;
using Polygon = std::vector<int>;
using TestScene::FindDifference;
using TestScene::GetSamplePlaces;
using TestScene::MakeBox;
using TestScene::MakeMesh;
using TestScene::NamedScenario;
using TestScene::Picture;
using TestScene::SceneBuilder;
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

/// Returns the named scenarios of shadow hazards (NamedScenarios.h).
std::vector<NamedScenario> GetScenarios();
/// Returns one of them. Throws std::out_of_range if there is none of this name.
NamedScenario GetScenario(const std::string& name);

/// Returns a stage with the first frame of a scene and its lights, in a window of the scene's size
/// that has not rendered yet.
Stage SetStage(const NamedScenario& scene);
/// Returns a stage with the scene that `build` describes. Points are stored as doubles.
Stage SetStage(const std::function<void(SceneBuilder&)>& build, int width = 200, int height = 150,
  int multiSamples = 0);
/// Returns a stage with a scene of GetScenarios().
Stage SetNamedStage(const std::string& name);
/// Adds what the first frame of a scene describes to the stage.
void FillStage(const Stage& stage, const NamedScenario& scene);
/// Applies the changes of props before the scene's second frame. Returns false if there is none.
bool ChangeStage(const Stage& stage, const NamedScenario& scene);

/// Makes a sphere by vtkSphereSource. It has one point at each pole and one seam.
vtkSmartPointer<vtkPolyData> MakeGlobe(const Point& centre, double radius, int resolution);

/// Adds an actor. Its colour follows from its number in the renderer, as in scenarios.
vtkActor* AddMesh(vtkRenderer* renderer, vtkPolyData* mesh);

/// Adds what `build` describes to a renderer, whose viewport does not change.
void Fill(vtkRenderer* renderer, const std::function<void(SceneBuilder&)>& build);

/// Returns the pixels of the window that the renderer fills.
vtkNBufferRectangle GetPixels(vtkRenderer* renderer);

/// Returns the actors of a renderer and of its assemblies, in the order in which they were added.
std::vector<vtkActor*> GetActors(vtkRenderer* renderer);

/// A mask: one value for each pixel of the viewport, row by row, the lowest first. 0 means lit, any
/// other value shadowed.
using ShadowMask = std::vector<unsigned char>;

struct MaskComparison
{
  int Samples = 0;            ///< Samples that the oracle finds lit or shadowed: those compared.
  int Shadowed = 0;           ///< Compared samples that the oracle finds shadowed.
  int Wrong = 0;              ///< Compared samples that differ and are not ambiguous.
  int AmbiguousDiffering = 0; ///< Compared samples that differ and are ambiguous.
  int FirstWrong[2] = { -1, -1 }; ///< The pixel of the first wrong sample.
};

std::ostream& operator<<(std::ostream& stream, const MaskComparison& comparison);

/// Compares a mask with an oracle image of the same size.
MaskComparison CompareMask(const ShadowMask& mask, const OracleImage& oracle);

/// Returns the oracle image as a mask: 1 where a sample is shadowed, else 0.
ShadowMask MakeMask(const OracleImage& oracle);

/// Succeeds if no sample is wrong. The message has the counts and the first wrong sample.
::testing::AssertionResult MatchesOracle(const ShadowMask& mask, const OracleImage& oracle);

/// Returns whether the oracle finds a sample lit or shadowed: only these are compared.
bool IsLitOrShadowed(const OracleImage& oracle, std::size_t pixel);

#endif
