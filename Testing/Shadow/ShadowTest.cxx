// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowTest.h"

#include "Fill.h"
#include "SceneProps.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <stdexcept>

std::vector<NamedScenario> GetScenarios()
{
  std::vector<NamedScenario> result = TestScene::GetLightScenarios();
  for (const auto& part : { TestScene::GetViewScenarios(), TestScene::GetMeshScenarios(),
         TestScene::GetLargeScenarios() })
  {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

NamedScenario GetScenario(const std::string& name)
{
  for (const NamedScenario& scene : GetScenarios())
  {
    if (scene.Name == name)
    {
      return scene;
    }
  }
  throw std::out_of_range("There is no scene " + name + ".");
}

void FillStage(const Stage& stage, const NamedScenario& scene)
{
  TestScene::Fill(stage.GetRenderer(), scene.Scenario);
  if (scene.Finish)
  {
    scene.Finish(stage.GetRenderer());
  }
}

bool ChangeStage(const Stage& stage, const NamedScenario& scene)
{
  // Props have the places in the renderer that they have in the scenario: there are no assemblies
  // in scenes that change.
  for (const TestScene::Change& change : scene.Scenario.Changes)
  {
    if (change.Frame == 1)
    {
      vtkObject* prop = stage.GetRenderer()->GetViewProps()->GetItemAsObject(change.Target);
      TestScene::ChangeProp(
        vtkProp::SafeDownCast(prop), scene.Scenario.Props.at(change.Target), change);
    }
  }
  return scene.Scenario.Frames > 1;
}

Stage SetStage(const NamedScenario& scene)
{
  const TestScene::Window& window = scene.Scenario.Window;
  Stage stage(window.Width, window.Height, window.MultiSamples);
  stage.GetRenderer()->SetAutomaticLightCreation(0);
  FillStage(stage, scene);
  vtkCollectionSimpleIterator cookie;
  stage.GetRenderer()->GetLights()->InitTraversal(cookie);
  while (vtkLight* light = stage.GetRenderer()->GetLights()->GetNextLight(cookie))
  {
    stage.Lights.push_back(light);
  }
  return stage;
}

Stage SetStage(
  const std::function<void(SceneBuilder&)>& build, int width, int height, int multiSamples)
{
  return SetStage(TestScene::MakeShadowScenario("", build, width, height, multiSamples));
}

Stage SetNamedStage(const std::string& name)
{
  return SetStage(GetScenario(name));
}

vtkSmartPointer<vtkPolyData> MakeGlobe(const Point& centre, double radius, int resolution)
{
  SceneBuilder scene;
  scene.UsesDoubles = true;
  return TestScene::MakeShape(scene.Sphere(centre, radius, resolution).Shape);
}

vtkActor* AddMesh(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const int number = renderer->GetActors()->GetNumberOfItems();
  actor->GetProperty()->SetColor(
    0.4 + 0.1 * (number % 7), 0.4 + 0.1 * (number % 5), 0.4 + 0.2 * (number % 3));
  renderer->AddActor(actor);
  return actor;
}

void Fill(vtkRenderer* renderer, const std::function<void(SceneBuilder&)>& build)
{
  TestScene::Scenario scenario = TestScene::MakeShadowScenario("", build).Scenario;
  std::copy_n(renderer->GetViewport(), 4, scenario.Renderers[0].Viewport.begin());
  TestScene::Fill(renderer, scenario);
}

vtkNBufferRectangle GetPixels(vtkRenderer* renderer)
{
  int width;
  int height;
  vtkNBufferRectangle pixels;
  renderer->GetTiledSizeAndOrigin(&width, &height, &pixels.X0, &pixels.Y0);
  pixels.X1 = pixels.X0 + width;
  pixels.Y1 = pixels.Y0 + height;
  return pixels;
}

std::vector<vtkActor*> GetActors(vtkRenderer* renderer)
{
  // Every call of vtkRenderer::GetActors() fills the collection anew.
  std::vector<vtkActor*> result;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator cookie;
  actors->InitTraversal(cookie);
  while (vtkActor* actor = actors->GetNextActor(cookie))
  {
    result.push_back(actor);
  }
  return result;
}

std::ostream& operator<<(std::ostream& stream, const MaskComparison& comparison)
{
  stream << comparison.Samples << " samples, " << comparison.Shadowed << " in shadow, "
         << comparison.Wrong << " wrong, " << comparison.AmbiguousDiffering
         << " differ and are ambiguous";
  if (comparison.Wrong > 0)
  {
    stream << "; the first wrong one is pixel (" << comparison.FirstWrong[0] << ", "
           << comparison.FirstWrong[1] << ")";
  }
  return stream;
}

MaskComparison CompareMask(const ShadowMask& mask, const OracleImage& oracle)
{
  MaskComparison result;
  for (std::size_t i = 0; i < oracle.Samples.size(); ++i)
  {
    if (!IsLitOrShadowed(oracle, i))
    {
      continue;
    }
    const bool shadowed = oracle.Samples[i] == OracleSample::Shadowed;
    ++result.Samples;
    result.Shadowed += shadowed;
    if ((mask.at(i) != 0) == shadowed)
    {
      continue;
    }
    if (oracle.Ambiguous[i])
    {
      ++result.AmbiguousDiffering;
      continue;
    }
    if (result.Wrong++ == 0)
    {
      result.FirstWrong[0] = static_cast<int>(i % oracle.Width);
      result.FirstWrong[1] = static_cast<int>(i / oracle.Width);
    }
  }
  return result;
}

ShadowMask MakeMask(const OracleImage& oracle)
{
  ShadowMask mask(oracle.Samples.size());
  std::transform(oracle.Samples.begin(), oracle.Samples.end(), mask.begin(),
    [](OracleSample sample) { return sample == OracleSample::Shadowed; });
  return mask;
}

bool IsLitOrShadowed(const OracleImage& oracle, std::size_t pixel)
{
  return oracle.Samples[pixel] == OracleSample::Lit ||
    oracle.Samples[pixel] == OracleSample::Shadowed;
}

::testing::AssertionResult MatchesOracle(const ShadowMask& mask, const OracleImage& oracle)
{
  if (mask.size() != oracle.Samples.size())
  {
    return ::testing::AssertionFailure()
      << "The mask has " << mask.size() << " pixels, the oracle " << oracle.Samples.size();
  }
  const MaskComparison comparison = CompareMask(mask, oracle);
  return (comparison.Wrong == 0 ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
    << comparison;
}
