// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The depth that a rasteriser gives to clipped triangles against the bound that the oracle grants.
#include "DrawnPolygon.h"
#include "Fill.h"
#include "ShadowTest.h"
#include "ThinSides.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <vector>

namespace
{
constexpr int Width = 200;
constexpr int Height = 150;
/// Window depth: storing it in 24 bits and reading it.
constexpr double Storage = 4.0 / (1 << 24);

/// What one triangle, or many, were given.
struct Errors
{
  int Samples = 0;
  int TooLarge = 0;     ///< Samples beyond the bound.
  double Largest = 0.0; ///< Window depth.
  double Ratio = 0.0;   ///< The largest (error - storage) / bound.
  double Bound = 0.0;   ///< The largest.
};

std::ostream& operator<<(std::ostream& stream, const Errors& errors)
{
  constexpr double units = 1 << 24;
  return stream << errors.Samples << " samples, largest error " << errors.Largest * units
                << " units of 24 bits, largest bound " << errors.Bound * units
                << ", largest error / bound " << errors.Ratio;
}

class DrawnPolygonTest : public OffscreenFixture
{
protected:
  void SetUp() override
  {
    OffscreenFixture::SetUp();
    if (!IsSkipped())
    {
      this->Stage = std::make_unique<TestScene::Stage>(Width, Height);
      this->Stage->GetRenderer()->SetAutomaticLightCreation(0);
      this->Actor = AddMesh(this->Stage->GetRenderer(),
        MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }));
    }
  }

  void Look(const Point& eye, const Point& focalPoint, double near, double far)
  {
    SceneBuilder scene;
    TestScene::View& view = scene.Look(eye, focalPoint);
    view.Near = near;
    view.Far = far;
    TestScene::SetView(this->Stage->GetRenderer(), view);
  }

  /// Corners have to be floats, so that nothing is rounded before the device has them.
  void Draw(const std::array<Point, 3>& corners, Errors& errors)
  {
    vtkPolyDataMapper::SafeDownCast(this->Actor->GetMapper())
      ->SetInputData(MakeMesh({ corners[0], corners[1], corners[2] }, { { 0, 1, 2 } }));
    this->Stage->Window->Render();
    vtkNew<vtkFloatArray> depths;
    this->Stage->Window->GetZbufferData(0, 0, Width - 1, Height - 1, depths);
    vtkMatrix4x4* matrix =
      this->Stage->GetRenderer()->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
        this->Stage->GetRenderer()->GetTiledAspectRatio(), -1.0, 1.0);
    std::vector<DrawnPolygon::Corner> clip;
    for (const Point& corner : corners)
    {
      clip.push_back(DrawnPolygon::Transform(matrix->Element, glm::value_ptr(corner)));
    }
    const DrawnPolygon polygon(clip, DrawnPolygon::Planes::NearAndFar, Width, Height);
    for (int i = 0; polygon.IsVisible() && i < Width * Height; ++i)
    {
      const double drawn = depths->GetValue(i);
      if (drawn == 1.0)
      {
        continue;
      }
      const double x = i % Width + 0.5;
      const double y = i / Width + 0.5;
      const double error = std::abs(drawn - polygon.GetDepth(x, y));
      const double bound = polygon.GetBound(x, y);
      ++errors.Samples;
      errors.TooLarge += error > bound + Storage;
      errors.Largest = std::max(errors.Largest, error);
      errors.Bound = std::max(errors.Bound, bound);
      errors.Ratio = std::max(errors.Ratio, (error - Storage) / bound);
    }
  }

  std::unique_ptr<TestScene::Stage> Stage;
  vtkActor* Actor = nullptr;
};
}

// A ground of one triangle, seen from eye height, reaches up to kilometres beyond the view.
TEST_F(DrawnPolygonTest, LargeGround)
{
  for (const double size : { 1e2, 1e3, 1e4, 1e5 })
  {
    Errors errors;
    for (int k = 0; k < 8; ++k)
    {
      const double turn = 0.7 * k;
      this->Look({ 10.0, 20.0, 1.7 },
        { 10.0 + 10.0 * std::cos(turn), 20.0 + 10.0 * std::sin(turn), 1.0 }, 0.3, 30000.0);
      this->Draw(
        { { { -size, -size, 0.0 }, { 2.0 * size, -size, 0.0 }, { -size, 2.0 * size, 0.0 } } },
        errors);
    }
    std::cout << "  " << size << " units: " << errors << "\n";
    EXPECT_GT(errors.Samples, 10000);
    EXPECT_EQ(errors.TooLarge, 0) << size << ": " << errors;
    if (size >= 1e4)
    {
      EXPECT_GT(errors.Ratio, 1.0 / 32.0) << size << ": " << errors;
    }
  }
}

// Triangles like the sides of volumes: 1/50 to 1 pixel wide, with a large range of depths, from the
// middle of the view to beyond its border.
TEST_F(DrawnPolygonTest, Slivers)
{
  std::mt19937 random(3);
  const auto between = [&random](double low, double high)
  { return low + (high - low) * static_cast<double>(random()) / std::mt19937::max(); };
  Errors errors;
  // A unit in the distance of 10 is 75 pixels / (10 tan 15 degrees).
  this->Look({ 0.0, 0.0, 10.0 }, { 0.0, 0.0, 0.0 }, 5.0, 50.0);
  for (int i = 0; i < 200; ++i)
  {
    const double width = std::exp(between(std::log(0.02), 0.0)) / 28.0;
    const double turn = between(0.0, 6.28);
    const double along[2] = { std::cos(turn), std::sin(turn) };
    const double x = between(-1.0, 1.0);
    const double y = between(-1.0, 1.0);
    const double depth = between(-2.0, 2.0);
    std::array<Point, 3> corners = { { { x, y, depth },
      { x - width * along[1], y + width * along[0], depth + between(-0.1, 0.1) },
      { x + 20.0 * along[0], y + 20.0 * along[1], between(-20.0, -3.0) } } };
    for (Point& corner : corners)
    {
      corner = glm::dvec3(glm::vec3(corner));
    }
    this->Draw(corners, errors);
  }
  std::cout << "  " << errors << "\n";
  EXPECT_GT(errors.Samples, 1000);
  EXPECT_EQ(errors.TooLarge, 0) << errors;
  EXPECT_GT(errors.Ratio, 1.0 / 128.0) << errors;
}

namespace
{
/// From the origin along -z with 90 degrees, near 1, far 100.
ThinSides::View LookAlongZ(int size)
{
  return { { 0.0, 0.0, 0.0 },
    { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 }, { 0.0, 0.0, -101.0 / 99.0, -200.0 / 99.0 },
      { 0.0, 0.0, -1.0, 0.0 } },
    size, size };
}
}

// The shadow of a triangle 1/20 pixel wide, and that of a wide triangle, reach to the right and
// away from the eye.
TEST(ThinSidesTest, ThinSidesAloneAreFound)
{
  constexpr int size = 200;
  const ThinSides::View view = LookAlongZ(size);
  vtkNew<vtkLight> light;
  light->SetPosition(0.0, 0.0, 0.0);
  light->SetFocalPoint(1.0, 0.0, -1.0);
  // Where x / -z is that of pixel 150: x = t, z = -10 - t. And y the middle of row 100.
  const double t = 5.05 / (1.0 - 0.505);
  const double y = 0.005 * (10.0 + t);
  const auto make = [&](double halfWidth, double length)
  {
    RenderedTriangles triangles;
    triangles.Corners = { 0.0, y - halfWidth, -10.0, 0.0, y + halfWidth, -10.0, 0.0, y,
      -10.0 - length };
    triangles.Owners = { 0 };
    return ThinSides(triangles, { 1 }, OracleLight(light), view);
  };
  const ThinSides thin = make(5e-3, 1e-2);
  const ThinSides wide = make(2.0, 4.0);
  const double depth = 0.5 + 0.5 * (101.0 / 99.0 - 200.0 / 99.0 / (10.0 + t));
  EXPECT_TRUE(thin.AreNear(150, 100, depth, 0.0));
  EXPECT_FALSE(thin.AreNear(150, 100, depth + 0.05, 0.0));
  EXPECT_TRUE(thin.AreNear(150, 100, depth + 0.05, 0.05));
  EXPECT_FALSE(thin.AreNear(150, 90, depth, 1.0));
  for (int i = 0; i < size * size; ++i)
  {
    EXPECT_FALSE(wide.AreNear(i % size, i / size, 0.5, 1.0)) << i;
  }
  // Less than two steps of the subpixel grid: any depth.
  const ThinSides thinnest = make(1e-5, 1e-5);
  EXPECT_TRUE(thinnest.AreNear(150, 100, 0.001, 0.0));
  EXPECT_FALSE(thinnest.AreNear(150, 98, 0.001, 0.0));
}

// The light, an edge of the caster and the eye are in one plane, so that the side at this edge is
// seen as a line. A rasteriser may draw its samples at any depth.
TEST(ThinSidesTest, SidesSeenEdgeOnHaveAnyDepth)
{
  constexpr int size = 201;
  const ThinSides::View view = LookAlongZ(size);
  vtkNew<vtkLight> light;
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetPosition(0.0, 0.0, -10.0);
  RenderedTriangles triangles;
  triangles.Corners = { 2.0, 0.0, -9.0, 2.0, 0.0, -11.0, 2.0, -2.0, -10.0 };
  triangles.Owners = { 0 };
  const ThinSides sides(triangles, { 1 }, OracleLight(light), view);
  // The side reaches from the right of the middle to the border, in the middle row.
  for (const double depth : { 0.0, 0.5, 1.0 })
  {
    EXPECT_TRUE(sides.AreNear(150, 100, depth, 0.0)) << depth;
    EXPECT_FALSE(sides.AreNear(50, 100, depth, 0.0)) << depth;
    EXPECT_FALSE(sides.AreNear(150, 101, depth, 0.0)) << depth;
    EXPECT_FALSE(sides.AreNear(150, 99, depth, 0.0)) << depth;
  }
}
