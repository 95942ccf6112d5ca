// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces of hidden props, and which of them are seen so nearly edge-on that they may be slivers.
#include "ProjectedBox.h"
#include "vtkNBufferFaceTest.h"
#include "vtkNBufferFaces.h"
#include "vtkNBufferSliverTest.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

namespace
{
constexpr int FacesWidth = 320;
constexpr int FacesHeight = 240;
const std::array<double, 16> FacesToWorld = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };

using FaceTriangle = std::array<glm::dvec3, 3>;

vtkNBufferMeshes::Placed MakeFacesMesh(const std::vector<FaceTriangle>& triangles)
{
  auto mesh = std::make_shared<vtkNBufferMesh>();
  for (const FaceTriangle& triangle : triangles)
  {
    const auto first = static_cast<unsigned int>(mesh->Points.size());
    mesh->Points.insert(mesh->Points.end(), triangle.begin(), triangle.end());
    mesh->Triangles.push_back({ first, first + 1, first + 2 });
  }
  return { mesh, FacesToWorld };
}

vtkNBufferBox BoundFaces(const std::vector<FaceTriangle>& triangles)
{
  glm::dvec3 low = triangles.front().front();
  glm::dvec3 high = low;
  for (const FaceTriangle& triangle : triangles)
  {
    for (const glm::dvec3& corner : triangle)
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  const double bounds[6] = { low.x, high.x, low.y, high.y, low.z, high.z };
  return vtkNBufferBox::FromBounds(bounds);
}

/// The faces of one prop.
struct PropOfFaces
{
  explicit PropOfFaces(const std::vector<FaceTriangle>& triangles)
    : Mesh(MakeFacesMesh(triangles))
    , Box(BoundFaces(triangles))
  {
    this->Faces.Set(this->OfProps[0], { this->Mesh }, this->Box);
  }

  bool MayBeInFront(const vtkNBufferProjection& projection, double clearance) const
  {
    const vtkNBufferFaceTest test(projection, {});
    return std::any_of(this->Faces.GetPieces().begin(), this->Faces.GetPieces().end(),
      [&](const vtkNBufferFaces::Piece& piece)
      { return test.MayBeInFront(this->Faces, piece, clearance); });
  }

  vtkNBufferMeshes::Placed Mesh;
  vtkNBufferBox Box;
  vtkNBufferFaces Faces;
  std::vector<vtkNBufferFaces::OfProp> OfProps = std::vector<vtkNBufferFaces::OfProp>(1);
};

/// Both triangles of a parallelogram.
void AddFacesOfQuad(const glm::dvec3& corner, const glm::dvec3& one, const glm::dvec3& other,
  std::vector<FaceTriangle>& triangles)
{
  triangles.push_back({ { corner, corner + one, corner + one + other } });
  triangles.push_back({ { corner, corner + one + other, corner + other } });
}

std::vector<FaceTriangle> MakeFacesOfCuboid(const glm::dvec3& corner, const glm::dvec3& size)
{
  std::vector<FaceTriangle> triangles;
  for (int j = 0; j < 3; ++j)
  {
    glm::dvec3 across(0.0);
    glm::dvec3 one(0.0);
    glm::dvec3 other(0.0);
    across[j] = size[j];
    one[(j + 1) % 3] = size[(j + 1) % 3];
    other[(j + 2) % 3] = size[(j + 2) % 3];
    AddFacesOfQuad(corner, one, other, triangles);
    AddFacesOfQuad(corner + across, one, other, triangles);
  }
  return triangles;
}

/// An eye in the origin that looks along -z, 60 degrees high.
vtkNBufferProjection MakeViewOfFaces()
{
  const glm::dmat4 toClip = glm::perspective(
    glm::radians(60.0), static_cast<double>(FacesWidth) / FacesHeight, 0.5, 10000.0);
  vtkNBufferProjection projection;
  projection.Set(vtkNBufferGLM::ToRows(toClip).data(), FacesWidth, FacesHeight,
    vtkNBufferDepthFormat::FromQuantum(0x1p-24), {}, 8);
  return projection;
}

/// The height of the view at a distance of 1, in pixels.
const double PixelsPerSlope = 0.5 * FacesHeight / std::tan(glm::radians(30.0));
}

TEST(NBufferFaces, TrianglesInOnePlaneAreAFace)
{
  const PropOfFaces cuboid(MakeFacesOfCuboid({ 1.0, 2.0, 3.0 }, { 3.0, 4.0, 12.0 }));
  ASSERT_EQ(cuboid.Faces.GetPieces().size(), 1u);
  const vtkNBufferFaces::Piece& piece = cuboid.Faces.GetPieces().front();
  EXPECT_EQ(piece.Center, glm::dvec3(2.5, 4.0, 9.0));
  ASSERT_EQ(piece.End - piece.Begin, 6u);
  // The first two are 4 x 12, and 1.5 from the center along x.
  const double height = 4.0 * 12.0 / std::hypot(4.0, 12.0);
  for (int i = 0; i < 2; ++i)
  {
    const glm::vec4 face = cuboid.Faces.GetFaces()[i];
    EXPECT_NEAR(std::abs(face.x), height, 1e-6);
    EXPECT_NEAR(std::abs(face.w), 1.5 * height, 1e-6);
    EXPECT_EQ(glm::vec2(face.y, face.z), glm::vec2(0.0f));
  }
}

// The lowest triangle of a face counts. One that no device draws does not.
TEST(NBufferFaces, TheLowestTriangleOfAFace)
{
  const auto getHeight = [](const FaceTriangle& other)
  {
    const PropOfFaces prop({ { { { 0, 0, 0 }, { 10, 0, 0 }, { 5, 5, 0 } } }, other });
    EXPECT_EQ(prop.Faces.GetFaces().size(), 1u);
    return std::abs(prop.Faces.GetFaces().front().z);
  };
  EXPECT_NEAR(getHeight({ { { 0, 0, 0 }, { 0, 10, 0 }, { 7, 5, 0 } } }), 5.0, 1e-6);
  EXPECT_NEAR(getHeight({ { { 0, 0, 0 }, { 0, 10, 0 }, { -0.01, 5, 0 } } }), 0.01, 1e-6);
  EXPECT_NEAR(getHeight({ { { 0, 0, 0 }, { 0, 0, 0 }, { -0.01, 5, 0 } } }), 5.0, 1e-6);
}

TEST(NBufferFaces, LargeMeshesAreCutIntoPieces)
{
  std::vector<FaceTriangle> triangles;
  for (int i = 0; i < 50; ++i)
  {
    AddFacesOfQuad({ i, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, triangles);
  }
  const PropOfFaces prop(triangles);
  ASSERT_EQ(prop.Faces.GetPieces().size(), 4u);
  EXPECT_EQ(prop.Faces.GetFaces().size(), 4u);
  for (unsigned int i = 0; i < 4; ++i)
  {
    const vtkNBufferFaces::Piece& piece = prop.Faces.GetPieces()[i];
    EXPECT_EQ(piece.Triangle, 32u * i);
    EXPECT_EQ(piece.Mesh, 0u);
    EXPECT_NEAR(piece.HalfSize.x, i < 3 ? 8.0 : 1.0, 1e-5);
  }
}

// Hazard: memory grows while props change. What no prop refers to is removed, and what a prop
// refers to stays what it was.
TEST(NBufferFaces, ChangedPropsLeaveNothingBehind)
{
  vtkNBufferFaces faces;
  std::vector<vtkNBufferFaces::OfProp> ofProps(2);
  const auto cuboid = MakeFacesOfCuboid({ 0, 0, 0 }, { 1, 2, 3 });
  faces.Set(ofProps[1], { MakeFacesMesh(cuboid) }, BoundFaces(cuboid));
  const auto moved = MakeFacesOfCuboid({ 5, 5, 5 }, { 1, 1, 1 });
  for (int i = 0; i < 10000; ++i)
  {
    faces.Set(ofProps[0], { MakeFacesMesh(moved) }, BoundFaces(moved));
    faces.ReleaseUnused(ofProps, 1.0);
  }
  EXPECT_LE(faces.GetPieces().size(), 4u);
  faces.ReleaseUnused(ofProps, 0.0);
  EXPECT_EQ(faces.GetPieces().size(), 2u);
  EXPECT_EQ(faces.GetFaces().size(), 12u);
  ASSERT_EQ(ofProps[1].End - ofProps[1].Begin, 1u);
  const vtkNBufferFaces::Piece& piece = faces.GetPieces()[ofProps[1].Begin];
  EXPECT_EQ(piece.Center, glm::dvec3(0.5, 1.0, 1.5));
  EXPECT_EQ(piece.End - piece.Begin, 6u);
  EXPECT_NEAR(std::abs(faces.GetFaces()[piece.Begin].x), 6.0 / std::hypot(2.0, 3.0), 1e-6);
}

// A face is a sliver only if the eye is near its plane, the nearer the farther away the face is.
// Here it lies between two rows of pixels' middles or on one of them.
TEST(NBufferFaceTest, EdgeOnFacesMayBeInFront)
{
  const vtkNBufferProjection view = MakeViewOfFaces();
  const auto isInFront = [&](double row, double slope)
  {
    const double y = -1000.0 * (row + 0.5 - 0.5 * FacesHeight) / PixelsPerSlope;
    std::vector<FaceTriangle> triangles;
    // Over the way from 1000 to 1010, the plane rises towards the eye or away from it.
    AddFacesOfQuad({ -5.0, -y, -1000.0 }, { 10.0, 0.0, 0.0 },
      { 0.0, (-y / 1000.0 + slope) * 10.0, -10.0 }, triangles);
    return PropOfFaces(triangles).MayBeInFront(view, 0.1);
  };
  EXPECT_TRUE(isInFront(150.0, 1e-7));
  EXPECT_TRUE(isInFront(80.0, -1e-7));
  EXPECT_FALSE(isInFront(150.0, 0.1)) << "not edge-on";
  EXPECT_FALSE(isInFront(150.0, -0.1)) << "not edge-on";
  EXPECT_FALSE(isInFront(150.01, 1e-7)) << "between the middles of pixels";
  EXPECT_FALSE(isInFront(150.5, 1e-7)) << "between the middles of pixels";
}

// A part of a prop beyond a side of the view changes nothing, but one behind the eye does.
TEST(NBufferFaceTest, PropsAreTestedAcrossTheSidesOfTheView)
{
  const vtkNBufferProjection view = MakeViewOfFaces();
  const auto isInFront = [&](const glm::dvec3& corner, const glm::dvec3& size)
  { return PropOfFaces(MakeFacesOfCuboid(corner, size)).MayBeInFront(view, 0.1); };
  EXPECT_FALSE(isInFront({ 2.0, -2.0, -8.0 }, { 9.0, 1.0, 3.0 })) << "across the right side";
  EXPECT_TRUE(isInFront({ 2.0, -2.0, -8.0 }, { 9.0, 1.0, 7.8 })) << "across the near plane";
  EXPECT_TRUE(isInFront({ 2.0, -2.0, -8.0 }, { 9.0, 1.0, 9.0 })) << "behind the eye";
}

// The clearance says how steep a triangle may be.
TEST(NBufferFaceTest, ClearanceAllowsForSlopes)
{
  const vtkNBufferProjection view = MakeViewOfFaces();
  std::vector<FaceTriangle> triangles;
  // A ground 2 below the eye. It is 1.4 pixels high on the screen.
  AddFacesOfQuad({ -5.0, -2.0, -60.0 }, { 10.0, 0.0, 0.0 }, { 0.0, 0.0, -12.0 }, triangles);
  const PropOfFaces near(triangles);
  EXPECT_FALSE(near.MayBeInFront(view, 0.0));
  // 0.01 pixels high, across a row of middles.
  const double distance = 1000.0;
  const double y = -31.5 * distance / PixelsPerSlope;
  AddFacesOfQuad({ -5.0, y, -distance }, { 10.0, 0.0, 0.0 },
    { 0.0, (y / distance) * 10.0 + 0.02, -10.0 }, triangles);
  const PropOfFaces far({ triangles[2], triangles[3] });
  EXPECT_TRUE(far.MayBeInFront(view, 0.0));
  EXPECT_FALSE(far.MayBeInFront(view, 0.01));
}

// Hazard: a face that the test rules out has a triangle that may be seen. Where the pixels decide,
// vtkNBufferSliverTest is never stricter. Nor does the test keep what is not nearly edge-on.
TEST(NBufferFaceTest, NeverRulesOutWhatTheSliverTestKeeps)
{
  const vtkNBufferProjection view = MakeViewOfFaces();
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  int seen = 0;
  int ruledOut = 0;
  int kept = 0;
  for (int n = 0; n < 40000; ++n)
  {
    // In a plane that passes the eye at a small distance, or holds it.
    const double distance = std::exp(uniform(std::log(2.0), std::log(5000.0)));
    // Seen in the middle of a pixel, or hardly beside it.
    // A part of the triangles cross a side of the view.
    const glm::dvec2 pixel(std::floor(uniform(0.0, FacesWidth)) + uniform(-0.003, 0.003),
      std::floor(uniform(0.0, FacesHeight)) + uniform(-0.003, 0.003));
    const glm::dvec2 place =
      (pixel + 0.5 - 0.5 * glm::dvec2(FacesWidth, FacesHeight)) / PixelsPerSlope;
    const glm::dvec3 center = distance * glm::dvec3(place, -1.0);
    const double turn = n % 3 == 0 ? 0.0 : n % 3 == 1 ? 0.5 * glm::pi<double>() : uniform(0.0, 3.2);
    const glm::dvec3 across =
      glm::normalize(glm::cross(center, glm::dvec3(std::cos(turn), std::sin(turn), 0.0)));
    const glm::dvec3 along = glm::normalize(
      center + across * std::pow(10.0, uniform(-9.0, 0.0)) * (n % 2 == 0 ? 1.0 : -1.0) * distance);
    const glm::dvec3 side = glm::normalize(glm::cross(along, across));
    const double size = distance * std::pow(10.0, uniform(-3.0, -1.0));
    const double thin = std::pow(10.0, uniform(-4.0, 0.0));
    FaceTriangle triangle;
    for (glm::dvec3& corner : triangle)
    {
      corner = center + size * (uniform(-1.0, 1.0) * along + thin * uniform(-1.0, 1.0) * side);
      // A device gets floats.
      corner = glm::vec3(corner);
    }
    const PropOfFaces prop({ triangle });
    vtkNBufferScreenBox screen;
    if (view.Project(prop.Box, screen) != vtkNBufferPlacement::Inside || screen.Middles.IsEmpty())
    {
      continue;
    }
    // The sliver test adds up the errors of the depths of three corners, which are less than this.
    const double ofCorners = 2.0 * screen.Slack.z;
    const double clearance = std::pow(10.0, uniform(-7.0, -1.0));
    const std::vector<float> depth(static_cast<std::size_t>(FacesWidth) * FacesHeight,
      static_cast<float>(screen.Nearest - clearance - ofCorners));
    vtkNBufferLevels levels;
    levels.BuildBase(depth.data(), FacesWidth, FacesHeight, 4, vtkNBufferExtremum::Maximum);
    const bool isSeen = vtkNBufferSliverTest(view, levels, depth.data(), {})
                          .MayBeSeen(*prop.Mesh.Mesh, 0, 1, FacesToWorld.data(), prop.Box, screen);
    const bool isKept = prop.MayBeInFront(view, clearance);
    seen += isSeen ? 1 : 0;
    kept += isKept ? 1 : 0;
    ruledOut += isKept ? 0 : 1;
    ASSERT_TRUE(isKept || !isSeen) << n;
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(ruledOut, 3000);
}
