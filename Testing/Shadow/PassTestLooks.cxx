// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// What frames of vtkShadowVolumeClampPass look like, against pictures that somebody looked at
// (Testing/Baselines). Exact colours and edges are tested elsewhere as numbers.
#include "ImageComparison.h"
#include "PassTestTools.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>

namespace
{
/// A floor, a wall behind it, and on it a box and a ball, the last prop; the camera sees all of
/// them.
void AddProps(SceneBuilder& scene)
{
  scene.Floor(5.0).Color = { 0.75, 0.75, 0.7 };
  scene.Box({ 0.0, 3.1, 1.5 }, { 10.0, 0.2, 3.2 }).Color = { 0.8, 0.7, 0.6 };
  scene.Box({ -1.2, 0.6, 0.7 }, { 0.9, 0.9, 1.4 }).Color = { 0.4, 0.6, 0.8 };
  scene.Sphere({ 0.9, -0.2, 0.8 }, 0.7, 64).Color = { 0.85, 0.4, 0.3 };
  scene.Look({ 1.5, -8.0, 4.5 }, { 0.0, 0.5, 0.8 }, 30.0);
}

void AddFill(SceneBuilder& scene)
{
  TestScene::Light& fill = scene.Directional({ 0.0, 0.0, -1.0 });
  fill.Kind = TestScene::LightKind::Headlight;
  fill.Intensity = 0.25;
}

/// The cone's edge crosses floor, wall and both casters; the light falls off from the axis.
void SpotCone(SceneBuilder& scene)
{
  scene.Spot({ -3.5, -3.5, 5.0 }, { 0.0, 0.5, 0.0 }, 20.0).Exponent = 8.0;
  AddFill(scene);
}

/// Shadows of each are filled by the colour of the other; dark only where both end.
void TwoLights(SceneBuilder& scene)
{
  scene.Directional({ 0.7, 0.5, -0.8 }).Color = { 0.9, 0.5, 0.1 };
  scene.PointLight({ 2.8, -1.5, 2.6 }).Color = { 0.1, 0.4, 0.8 };
}

void PhysicallyBased(SceneBuilder& scene)
{
  scene.Directional({ -0.6, 0.6, -0.7 }).Intensity = 2.0;
  AddFill(scene);
}

/// A pane in front of shadows, which are seen through it; the pane itself casts none.
void TranslucentPane(SceneBuilder& scene)
{
  TestScene::Prop& pane = scene.Box({ 0.2, -1.6, 1.0 }, { 2.4, 0.05, 2.0 });
  pane.Color = { 0.3, 0.9, 0.5 };
  pane.Opacity = 0.4;
  scene.Directional({ 0.7, 0.4, -0.6 });
  AddFill(scene);
}

/// A ball cut in half along the light: its shadow is half as well.
void ClippingPlane(SceneBuilder& scene)
{
  scene.Scene.Props.back().ClippingPlane = { 0.9, -0.2, 0.8, 0.8, 1.0, 0.0 };
  scene.Directional({ -0.5, 0.4, -0.8 });
  AddFill(scene);
}

struct LookCase
{
  const char* Name;
  void (*Build)(SceneBuilder&);
};

void PrintTo(const LookCase& picture, std::ostream* stream)
{
  *stream << picture.Name;
}

vtkSmartPointer<vtkImageData> Grab(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}
}

using PassLooks = OffscreenFixtureWithParam<LookCase>;

// Images without shadows must not be like the baselines, which shows that the baselines have
// shadows.
TEST_P(PassLooks, LikeTheBaseline)
{
  const std::string name = this->GetParam().Name;
  const Stage stage = SetStage(
    [this](SceneBuilder& scene)
    {
      AddProps(scene);
      this->GetParam().Build(scene);
    },
    320, 240);
  stage.GetRenderer()->SetBackground(0.3, 0.35, 0.4);
  const std::vector<vtkActor*> actors = GetActors(stage.GetRenderer());
  actors[3]->GetProperty()->SetInterpolationToPhong();
  for (std::size_t i = 0; i < actors.size() && this->GetParam().Build == PhysicallyBased; ++i)
  {
    actors[i]->GetProperty()->SetInterpolationToPBR();
    actors[i]->GetProperty()->SetRoughness(0.4);
    actors[i]->GetProperty()->SetMetallic(0.2);
  }
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const vtkSmartPointer<vtkImageData> actual = Grab(stage.Window);
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);

  // What a new baseline is made from.
  const std::string written = "shadow-" + name + "-" + stage.Window->GetClassName() + ".png";
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(written.c_str());
  writer->SetInputData(actual);
  writer->Write();

  const vtkSmartPointer<vtkImageData> baseline =
    ReadPicture(VTKNBUFFER_BASELINES "/shadow-" + name + ".png");
  const double error = GetImageError(baseline, actual);
  EXPECT_LE(error, LargestImageError) << "The picture is " << written;

  stage.GetRenderer()->SetPass(nullptr);
  const double errorWithout = GetImageError(baseline, Grab(stage.Window));
  EXPECT_GT(errorWithout, LargestImageError);
  this->RecordProperty("error", std::to_string(error));
  this->RecordProperty("errorWithoutShadows", std::to_string(errorWithout));
  std::cout << name << ": error " << error << ", without shadows " << errorWithout << "\n";
}

namespace
{
/// An image in which all pixels except one have the same grey level.
vtkSmartPointer<vtkImageData> MakePicture(int width, int x, int y, int other)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, 8, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* values = static_cast<unsigned char*>(picture->GetScalarPointer());
  std::fill_n(values, 3 * width * 8, static_cast<unsigned char>(100));
  std::fill_n(values + 3 * (y * width + x), 3, static_cast<unsigned char>(other));
  return picture;
}
}

// Differences up to the tolerance count as 0, larger ones as what exceeds it.
TEST(ImageComparison, CountsWhatIsBeyondTheTolerance)
{
  const vtkSmartPointer<vtkImageData> plain = MakePicture(10, 4, 4, 100);
  EXPECT_EQ(GetImageError(plain, plain), 0.0);
  for (const int sign : { -1, 1 })
  {
    const auto error = [&](int x, int difference)
    { return GetImageError(plain, MakePicture(10, x, 4, 100 + sign * difference)); };
    EXPECT_EQ(error(4, PixelTolerance), 0.0);
    EXPECT_DOUBLE_EQ(error(4, PixelTolerance + 51), 51.0 / 255.0);
    EXPECT_DOUBLE_EQ(error(2, PixelTolerance + 51), 51.0 / 255.0);
    EXPECT_EQ(error(1, PixelTolerance + 51), 0.0) << "the filter compares all but the border";
  }
  EXPECT_GT(GetImageError(plain, MakePicture(11, 4, 4, 100)), 1e300);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PassLooks,
  ::testing::Values(LookCase{ "SpotCone", SpotCone }, LookCase{ "TwoLights", TwoLights },
    LookCase{ "PhysicallyBased", PhysicallyBased }, LookCase{ "TranslucentPane", TranslucentPane },
    LookCase{ "ClippingPlane", ClippingPlane }),
  [](const auto& info) { return info.param.Name; });
