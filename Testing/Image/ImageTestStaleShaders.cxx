// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// A mapper makes its shaders anew only for reasons that VTK knows: after some changes it goes on
// with shaders that do not fit, with and without the culler.
#include "CullerTest.h"
#include "LargeProps.h"

#include "vtkCamera.h"
#include "vtkDataSetMapper.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <functional>
#include <tuple>

namespace
{
struct MapperKind : NamedCase
{
  vtkSmartPointer<vtkMapper> (*Make)(vtkPolyData* data);
};

template <typename MapperType>
vtkSmartPointer<vtkMapper> MakeMapper(vtkPolyData* data)
{
  vtkNew<MapperType> mapper;
  mapper->SetInputData(data);
  return mapper.Get();
}

const MapperKind MapperKinds[] = { { "PolyData", MakeMapper<vtkPolyDataMapper> },
  { "DataSet", MakeMapper<vtkDataSetMapper> } };

constexpr int Small = 0;
constexpr int Large = 1;

/// A small sphere and a large one, whose property is newer and flat.
void BuildSpheres(Stage& stage, const MapperKind& kind)
{
  for (const int place : { Small, Large })
  {
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(place == Large ? 40 : 6);
    source->SetPhiResolution(place == Large ? 30 : 5);
    source->Update();
    vtkNew<vtkActor> actor;
    actor->SetMapper(kind.Make(source->GetOutput()));
    actor->SetPosition(place == Large ? 0.6 : -0.6, 0.0, 0.0);
    actor->GetProperty()->SetColor(0.9, 0.7, place == Large ? 0.4 : 0.8);
    stage.Add(actor);
  }
  stage.GetActor(Large)->GetProperty()->SetInterpolationToFlat();
  stage.GetRenderer()->ResetCamera();
}

/// The large sphere gets the older property of the small one, which is no reason for VTK to make
/// shaders anew.
void UseOlderProperty(Stage& stage)
{
  stage.GetActor(Large)->SetProperty(stage.GetActor(Small)->GetProperty());
}

void SwapMappers(Stage& stage)
{
  const vtkSmartPointer<vtkMapper> mapper = stage.GetActor(Large)->GetMapper();
  stage.GetActor(Large)->SetMapper(stage.GetActor(Small)->GetMapper());
  stage.GetActor(Small)->SetMapper(mapper);
}

void CompareFrames(Comparison& comparison)
{
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame([](Stage& stage) { stage.GetRenderer()->GetActiveCamera()->Azimuth(3.0); });
  }
}

struct StaleCase : NamedCase
{
  /// Changes the stage and compares frames. The culler is added before, if `IsLater` is not set.
  std::function<void(Comparison&)> Play;
  bool IsLater = false;
};

const StaleCase StaleCases[] = {
  { "WireframeBecomesDividable",
    [](Comparison& comparison)
    {
      comparison.Both(
        [](Stage& stage) { stage.GetActor(Large)->GetProperty()->SetRepresentationToWireframe(); });
      CompareFrames(comparison);
      comparison.Both(UseOlderProperty);
      CompareFrames(comparison);
    } },
  { "CullerIsAddedLater",
    [](Comparison& comparison)
    {
      CompareFrames(comparison);
      comparison.Both(UseOlderProperty);
      CompareFrames(comparison);
      comparison.AddCuller();
      CompareFrames(comparison);
    },
    true },
  { "DivisionIsSwitched",
    [](Comparison& comparison)
    {
      CompareFrames(comparison);
      comparison.Both(UseOlderProperty);
      for (const bool divides : { true, false, true })
      {
        comparison.GetCuller()->SetDivideProps(divides);
        CompareFrames(comparison);
      }
    } },
  { "LeavesTheListAndComesBack",
    [](Comparison& comparison)
    {
      CompareFrames(comparison);
      comparison.Both(UseOlderProperty);
      for (const bool isVisible : { true, false, true })
      {
        comparison.Both(
          [isVisible](Stage& stage) { stage.GetActor(Large)->SetVisibility(isVisible); });
        CompareFrames(comparison);
      }
    } },
  { "MappersAreSwapped",
    [](Comparison& comparison)
    {
      for (int i = 0; i < 3; ++i)
      {
        CompareFrames(comparison);
        comparison.Both(SwapMappers);
      }
      CompareFrames(comparison);
    } },
  { "SharesTheSmallMapper",
    [](Comparison& comparison)
    {
      CompareFrames(comparison);
      comparison.Both(
        [](Stage& stage) { stage.GetActor(Large)->SetMapper(stage.GetActor(Small)->GetMapper()); });
      CompareFrames(comparison);
      comparison.Both([](Stage& stage) { stage.GetActor(Large)->GetProperty()->LightingOff(); });
      CompareFrames(comparison);
    } },
};

class CullerStaleShaders : public testing::TestWithParam<std::tuple<StaleCase, MapperKind>>
{
};
}

// Hazard: the pass of large props comes or goes, which is a reason for VTK to make shaders anew.
TEST_P(CullerStaleShaders, StayStale)
{
  const auto& [scene, kind] = this->GetParam();
  ComparisonOptions options = LargeProps::MakeOptionsWithoutDraws();
  options.AddCuller = !scene.IsLater;
  Comparison comparison([&kind = kind](Stage& stage) { BuildSpheres(stage, kind); }, options);
  scene.Play(comparison);
}

INSTANTIATE_TEST_SUITE_P(Each, CullerStaleShaders,
  testing::Combine(testing::ValuesIn(StaleCases), testing::ValuesIn(MapperKinds)),
  [](const testing::TestParamInfo<CullerStaleShaders::ParamType>& info)
  { return std::string(std::get<0>(info.param).Name) + std::get<1>(info.param).Name; });
