// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// What is drawn of a caster, where and how: decisions of vtkShadowPlan, without OpenGL.
#include "Pixels.h"
#include "ShadowCaster.h"

#include "vtkShadowPlan.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Verdict = vtkShadowVerdict;

using Kind = vtkShadowLightKind;

/// At `height` above the origin, straight down: s = height - z.
vtkShadowLight MakeLightAbove(Kind kind = Kind::Directional, double height = 0.0)
{
  vtkShadowLight light;
  light.Kind = kind;
  light.Position[2] = height;
  light.ConeAngle = 60.0;
  return light;
}

/// One caster, one light, a camera far away, receivers put in by hand.
struct Situation
{
  explicit Situation(const vtkShadowLight& light, const ShadowMesh& mesh = MakeCube())
    : Light(light)
    , Frame(light)
    , Topology(mesh.Points, mesh.Triangles)
  {
    const int viewport[4] = { 10, 20, 300, 200 };
    std::copy_n(viewport, 4, this->View.Viewport);
    // What lies more than 100 below the eye is before the near plane.
    this->SetNearPlane({ 0.0, 0.0, 1.0, 100.0 });
    this->Litmap.Begin(64, { { -4.0, -4.0, -10.0 }, { 4.0, 4.0, 54.0 } });
  }

  /// With receivers that are all seen at pixel (5, 6).
  Situation(const vtkShadowLight& light, const ShadowMesh& mesh,
    const std::vector<Point>& receivers, bool withTiles = false)
    : Situation(light, mesh)
  {
    if (withTiles)
    {
      this->Litmap.GetTiles().Begin(300, 200);
    }
    for (const Point& receiver : receivers)
    {
      this->AddReceiver(receiver);
    }
  }

  /// Six faces around a point light take the place of the litmap.
  void UseFaces()
  {
    for (const vtkShadowLightSpace& frame : MakeFrames(this->Light))
    {
      this->Faces.push_back({ frame, {} });
      this->Faces.back().second.Begin(64, { { -1.0, -1.0, 0.0 }, { 1.0, 1.0, 64.0 } });
    }
  }

  /// A receiver of the face that it lies in.
  void AddFaceReceiver(const Point& x)
  {
    for (auto& [frame, litmap] : this->Faces)
    {
      const Point pqs = frame.ToLight(x);
      if (pqs[2] > 0.0 && std::abs(pqs[0]) < 1.0 && std::abs(pqs[1]) < 1.0)
      {
        EXPECT_TRUE(litmap.Add(pqs, pqs, 0.0, 5, 6));
      }
    }
  }

  /// A receiver at a place in the world, seen at a pixel of the viewport.
  void AddReceiver(const Point& x, int pixelX = 5, int pixelY = 6, float depth = 0.0f)
  {
    const Point pqs = this->Frame.ToLight(x);
    ASSERT_TRUE(this->Litmap.Add(pqs, pqs, 0.0, pixelX, pixelY));
    if (this->Litmap.GetTiles().IsKnown())
    {
      this->Litmap.GetTiles().Add(pqs, pqs, Point(1e-3), pixelX, pixelY, depth);
    }
  }

  /// Sets the row that is positive for vertices relative to the eye beyond the near plane.
  void SetNearPlane(const glm::dvec4& plane)
  {
    this->View.EyeToClip = glm::row(glm::dmat4(0.0), 2, plane);
  }

  const vtkShadowVolume& GetVolume() const { return this->Store.GetVolume(); }

  Verdict Decide(vtkShadowMode mode, int gap = 4, bool useLitmap = true)
  {
    this->Litmap.Build();
    const std::vector<Point>& points = this->Topology.GetPoints();
    this->Silhouette.Compute(this->Topology, points, this->Light, this->Counting);
    this->Footprint = vtkShadowFootprint::Make(this->Silhouette, points, this->Frame);
    std::vector<vtkShadowPlan::Face> litmaps;
    for (auto& [frame, litmap] : this->Faces)
    {
      litmap.Build();
      litmaps.push_back({ &frame, &litmap });
    }
    if (useLitmap && this->Faces.empty())
    {
      litmaps = { { &this->Frame, &this->Litmap } };
    }
    vtkShadowTuning tuning;
    tuning.SlabGap = gap;
    vtkShadowPlan plan(this->Light, this->View, mode, litmaps, tuning);
    this->Store = vtkShadowVolumeStore();
    const vtkShadowPart caster = { this->Footprint, this->Silhouette, &points };
    const auto dismissed = plan.EarlyOut(caster);
    const vtkShadowPlan::Choice choice = plan.Decide(caster);
    plan.Draw(choice, caster, this->Store);
    const Verdict verdict = choice.Verdict;
    this->Draws = plan.GetDraws();
    EXPECT_EQ(choice.IsDrawn(), !this->Draws.empty());
    EXPECT_TRUE(!dismissed || this->Draws.empty());
    EXPECT_TRUE(!dismissed || *dismissed == verdict || !this->Faces.empty());
    this->HasDismissed = dismissed.has_value();
    this->Slabs = static_cast<int>(choice.Slabs.size());
    this->CheckDraws();
    return verdict;
  }

  /// Draws follow each other, but for those that repeat one in other boxes, and take up all
  /// triangles.
  void CheckDraws() const
  {
    int next = 0;
    for (const vtkShadowDraw& draw : this->Draws)
    {
      EXPECT_GT(draw.NumberOfIndices, 0);
      if (!draw.Again)
      {
        EXPECT_EQ(draw.FirstIndex, next);
        next += draw.NumberOfIndices;
      }
      EXPECT_EQ(draw.FirstIndex + draw.NumberOfIndices, next);
    }
    EXPECT_EQ(next, static_cast<int>(this->GetVolume().GetIndices().size()));
  }

  /// The smallest and the largest z of a draw's corners.
  std::pair<double, double> GetHeights(const vtkShadowDraw& draw) const
  {
    std::pair<double, double> result = { HUGE_VAL, -HUGE_VAL };
    for (int i = draw.FirstIndex; i < draw.FirstIndex + draw.NumberOfIndices; ++i)
    {
      const glm::dvec4& vertex = this->GetVolume().GetVertices()[this->GetVolume().GetIndices()[i]];
      result.first = std::min(result.first, vertex.z);
      result.second = std::max(result.second, vertex.z);
    }
    return result;
  }

  vtkShadowLight Light;
  vtkShadowLightSpace Frame;
  vtkShadowTopology Topology;
  vtkShadowSilhouette Silhouette;
  vtkShadowCounting Counting = vtkShadowCounting::Away;
  vtkShadowFootprint Footprint;
  vtkShadowLitmap Litmap;
  std::vector<std::pair<vtkShadowLightSpace, vtkShadowLitmap>> Faces;
  vtkShadowPlan::View View;
  vtkShadowVolumeStore Store;
  std::vector<vtkShadowDraw> Draws;
  int Slabs = 0;
  bool HasDismissed = false; ///< Before the caster was added.
};

void ExpectBox(const vtkShadowDraw& draw, int x, int y, int width, int height)
{
  EXPECT_EQ(draw.Box, (vtkNBufferRectangle{ x, y, x + width, y + height }));
}
}

TEST(ShadowPlanFootprint, HoldsAllPoints)
{
  std::mt19937 random(3);
  for (const bool positional : { false, true })
  {
    for (int n = 0; n < 50; ++n)
    {
      vtkShadowLight light = MakeLightAbove(positional ? Kind::Spot : Kind::Directional, 5.0);
      light.Direction = vtkNBufferGLM::Normalize(light.Direction + 0.5 * MakePoint(random, 0.5));
      const vtkShadowLightSpace frame(light);
      std::vector<Point> points;
      for (int i = 0; i < 20; ++i)
      {
        points.push_back(MakePoint(random, 2.0));
      }
      const vtkShadowBlock block = vtkShadowFootprint::Make(points, frame).Block;
      int touched[6] = {};
      for (const Point& point : points)
      {
        const Point pqs = frame.ToLight(point);
        for (int i = 0; i < 3; ++i)
        {
          EXPECT_LE(block.Low[i], pqs[i]);
          EXPECT_GE(block.High[i], pqs[i]);
          touched[2 * i] += block.Low[i] == pqs[i];
          touched[2 * i + 1] += block.High[i] == pqs[i];
        }
      }
      EXPECT_EQ(std::count(touched, touched + 6, 0), 0) << "no wider than need be, case " << n;
    }
  }
}

TEST(ShadowPlan, WithoutALitmapAllIsDrawnEverywhere)
{
  for (const auto mode :
    { vtkShadowMode::Unclamped, vtkShadowMode::Scissored, vtkShadowMode::Clamped })
  {
    Situation situation(MakeLightAbove());
    EXPECT_EQ(situation.Decide(mode, 4, false), Verdict::Whole);
    ASSERT_EQ(situation.Draws.size(), 1u);
    ExpectBox(situation.Draws[0], 0, 0, 300, 200);
  }
  Situation situation(MakeLightAbove(), MakeCube(), { { 0.0, 0.0, -3.0 } });
  EXPECT_EQ(situation.Decide(vtkShadowMode::Unclamped), Verdict::Whole) << "not asked";
}

TEST(ShadowPlan, VerdictsFollowTheReceivers)
{
  for (const auto mode : { vtkShadowMode::Scissored, vtkShadowMode::Clamped })
  {
    const Verdict drawn = mode == vtkShadowMode::Scissored ? Verdict::Boxed : Verdict::Clamped;
    const struct
    {
      const char* Where;
      Point Receiver;
      Verdict Expected;
      bool Dismissed;
    } cases[] = { { "below", { 0.0, 0.0, -3.0 }, drawn, false },
      { "above", { 0.0, 0.0, 3.0 }, Verdict::BeforeCaster, true },
      { "beside", { 3.5, 3.5, -3.0 }, Verdict::NoReceiver, true },
      { "inside", { 0.0, 0.0, 0.0 }, Verdict::BeforeCaster, true } };
    for (const auto& c : cases)
    {
      SCOPED_TRACE(c.Where);
      Situation situation(MakeLightAbove(), MakeCube(), { c.Receiver });
      EXPECT_EQ(situation.Decide(mode), c.Expected);
      EXPECT_EQ(situation.Draws.empty(), c.Expected != drawn);
      EXPECT_EQ(situation.HasDismissed, c.Dismissed);
    }
    Situation nothing(MakeLightAbove());
    EXPECT_EQ(nothing.Decide(mode), Verdict::NoReceiver);
    Situation empty(MakeLightAbove(), ShadowMesh(), { { 0.0, 0.0, -3.0 } });
    EXPECT_EQ(empty.Decide(mode), Verdict::Empty);
  }
}

// A box contains the pixels of the receivers, in the coordinates of the framebuffer.
TEST(ShadowPlan, BoxesHoldTheReceiversPixels)
{
  Situation situation(MakeLightAbove());
  situation.AddReceiver({ 0.1, 0.1, -3.0 }, 5, 6);
  situation.AddReceiver({ -0.1, 0.1, -3.0 }, 12, 4);
  situation.AddReceiver({ 3.5, 3.5, -3.0 }, 200, 150);
  for (const auto mode : { vtkShadowMode::Scissored, vtkShadowMode::Clamped })
  {
    situation.Decide(mode);
    ASSERT_EQ(situation.Draws.size(), 1u);
    ExpectBox(situation.Draws[0], 5, 4, 8, 3);
  }
}

// If tiles are known, boxes contain only those that the shadow can reach. There are several boxes
// where what is between them costs more than another draw.
TEST(ShadowPlan, BoxesHoldTheTilesInShadow)
{
  for (const auto mode : { vtkShadowMode::Scissored, vtkShadowMode::Clamped })
  {
    Situation situation(MakeLightAbove(), MakeCube(), { { 0.0, 0.0, -3.0 } }, true);
    situation.AddReceiver({ 0.1, 0.0, -3.0 }, 150, 100);
    situation.AddReceiver({ 0.0, 0.0, 3.0 }, 290, 190);  // before the caster
    situation.AddReceiver({ 0.9, 0.0, -3.0 }, 250, 190); // in the lexels around it
    situation.Decide(mode);
    ASSERT_EQ(situation.Draws.size(), 2u);
    // The pixels of the receiver's tile in the box of all.
    constexpr int size = vtkShadowTiles::Size;
    ExpectBox(situation.Draws[0], 5, 6, size - 5 % size, size - 6 % size);
    ExpectBox(situation.Draws[1], 150 / size * size, 100 / size * size, size, size);
    EXPECT_FALSE(situation.Draws[0].Again);
    EXPECT_TRUE(situation.Draws[1].Again);

    Situation near(MakeLightAbove(), MakeCube(), { { 0.0, 0.0, -3.0 } }, true);
    near.AddReceiver({ 0.1, 0.0, -3.0 }, 20, 6);
    near.Decide(mode);
    EXPECT_EQ(near.Draws.size(), 1u);

    // The litmap knows no better: nearer and farther receivers on its rays, all of them elsewhere.
    Situation none(MakeLightAbove(), MakeCube(), { { 0.0, 0.0, 3.0 } }, true);
    none.AddReceiver({ 0.9, 0.0, -3.0 }, 150, 100);
    EXPECT_EQ(none.Decide(mode), Verdict::BeforeCaster);
    EXPECT_TRUE(none.Draws.empty());
  }
}

// A tile shows one receiver before the caster and one behind it, next to its shadow. One block
// around both would reach into the shadow; the two layers of the tile do not.
TEST(ShadowPlan, LayersKeepApartWhatATileSees)
{
  for (const bool hasLayers : { false, true })
  {
    Situation situation(MakeLightAbove());
    vtkShadowTiles& tiles = situation.Litmap.GetTiles();
    tiles.Begin(300, 200);
    if (hasLayers)
    {
      tiles.SetSplit(20 / vtkShadowTiles::Size, 20 / vtkShadowTiles::Size, 0.5f);
    }
    situation.AddReceiver({ 0.0, 0.0, 3.0 }, 20, 20, 0.25f);  // on its rays, before it
    situation.AddReceiver({ 0.6, 0.0, -3.0 }, 20, 20, 0.75f); // beyond, beside its rays
    EXPECT_EQ(situation.Decide(vtkShadowMode::Scissored),
      hasLayers ? Verdict::BeforeCaster : Verdict::Boxed);
    EXPECT_EQ(situation.Draws.empty(), hasLayers);
  }
}

// The cube reaches from -0.5 to 0.5. Spots are below it, in it, and above it.
TEST(ShadowPlan, CastersAtTheLightsPlane)
{
  using Mode = vtkShadowMode;
  const struct
  {
    double Height;
    double X; ///< Of the cube.
    vtkShadowMode Mode;
    bool Widened; ///< Whether rounding may bring any receiver into the cone.
    Verdict Expected;
    int Draws;
  } cases[] = {
    { -5.0, 0.0, Mode::Scissored, false, Verdict::BehindLight, 0 },
    { -5.0, 0.0, Mode::Unclamped, false, Verdict::Whole, 1 }, // Nothing is left out.
    { -5.0, 0.0, Mode::Scissored, true, Verdict::ThroughLightPlane, 1 },
    { 0.1, 0.8, Mode::Scissored, false, Verdict::ThroughLightPlane, 1 },
    { 0.1, 0.8, Mode::Clamped, false, Verdict::ThroughLightPlane, 1 },
    { 0.1, 5.0, Mode::Scissored, false, Verdict::OutsideCone, 0 },
    { 0.1, 5.0, Mode::Clamped, false, Verdict::OutsideCone, 0 },
    { 0.1, 5.0, Mode::Scissored, true, Verdict::ThroughLightPlane, 1 },
    { 0.1, 5.0, Mode::Clamped, true, Verdict::ThroughLightPlane, 1 },
    { 5.0, 0.0, Mode::Scissored, false, Verdict::Boxed, 1 },
  };
  for (const auto& c : cases)
  {
    SCOPED_TRACE(&c - cases);
    Situation situation(MakeLightAbove(Kind::Spot, c.Height), MakeCube().Translate(c.X, 0.0, 0.0),
      { { 0.0, 0.0, -8.0 } });
    situation.Litmap.WidenAngle(c.Widened ? vtkMath::Pi() : 0.0);
    EXPECT_EQ(situation.Decide(c.Mode), c.Expected);
    ASSERT_EQ(static_cast<int>(situation.Draws.size()), c.Draws);
    if (c.X == 0.8)
    {
      ExpectBox(situation.Draws[0], 5, 6, 1, 1);
    }
  }
  // A point light shines on both sides.
  Situation point(MakeLightAbove(Kind::Point, -5.0));
  EXPECT_EQ(point.Decide(vtkShadowMode::Unclamped, 4, false), Verdict::Whole);
}

// Hazard: a caster touches the light's plane, and a rounding error puts it before the plane, so
// that its p and q, which are divided by next to 0, count.
TEST(ShadowPlan, CastersThatTouchTheLightsPlaneAreThroughIt)
{
  std::mt19937 random(29);
  for (int n = 0; n < 1000; ++n)
  {
    vtkShadowLight light = MakeLightAbove(Kind::Spot, 0.0);
    light.Position = MakePoint(random, 8.0);
    light.Direction = vtkNBufferGLM::Normalize(MakePoint(random, 1.0));
    const vtkShadowLightSpace space(light);
    const Point touching = light.Position + MakeUniform(random, 1.0, 100.0) * space.GetU();
    const Point before = light.Position + MakeUniform(random, 1.0, 10.0) * space.GetAxis();
    const vtkShadowLitmapSet set(light, {});
    EXPECT_TRUE(set.IsThroughLightPlane(
      vtkShadowFootprint::Make(std::array{ touching, before }, space).Block));
    const Point nearly = touching + 1e-4 * space.GetAxis();
    EXPECT_FALSE(
      set.IsThroughLightPlane(vtkShadowFootprint::Make(std::array{ nearly, before }, space).Block));
  }
}

// Hazard: a caster with a corner in the cone of a spot is left out because its middle is outside;
// or a caster far away from the cone is not left out.
TEST(ShadowPlan, CastersWithACornerInTheConeAreKept)
{
  std::mt19937 random(23);
  int inCone = 0;
  int leftOut = 0;
  for (int n = 0; n < 4000; ++n)
  {
    vtkShadowLight light = MakeLightAbove(Kind::Spot, 0.0);
    light.Direction = vtkNBufferGLM::Normalize(MakePoint(random, 1.0));
    light.ConeAngle = MakeUniform(random, 5.0, 80.0);
    const Point middle = MakePoint(random, 8.0);
    const Point half = glm::abs(MakePoint(random, 1.0));
    vtkShadowFootprint footprint;
    footprint.Bounds = { middle - half, middle + half };
    const bool isOutside = vtkShadowLitmapSet(light, {}).IsOutsideCone(footprint);
    double angle = vtkMath::Pi(); // of the corner that is next to the axis
    for (int i = 0; i < 8; ++i)
    {
      const Point corner =
        middle + half * Point(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
      const double cosine = glm::dot(vtkNBufferGLM::Normalize(corner), light.Direction);
      angle = std::min(angle, std::acos(std::clamp(cosine, -1.0, 1.0)));
    }
    const bool isCornerInCone = angle < vtkMath::RadiansFromDegrees(light.ConeAngle);
    EXPECT_FALSE(isOutside && isCornerInCone) << n;
    inCone += isCornerInCone;
    leftOut += isOutside;
  }
  EXPECT_GT(inCone, 500);
  EXPECT_GT(leftOut, 1000);
}

// Groups of receivers that are far enough from each other have their own slabs.
TEST(ShadowPlan, SlabsHoldTheReceivers)
{
  Situation situation(MakeLightAbove());
  const double heights[] = { -4.0, -5.0, -20.0, -45.0 };
  for (double z : heights)
  {
    situation.AddReceiver({ 0.0, 0.0, z });
  }
  const std::pair<int, std::size_t> gaps[] = { { 4, 3u }, { 20, 2u }, { 64, 1u } };
  for (const auto& [gap, slabs] : gaps)
  {
    SCOPED_TRACE("gap " + std::to_string(gap));
    EXPECT_EQ(situation.Decide(vtkShadowMode::Clamped, gap), Verdict::Clamped);
    EXPECT_EQ(situation.Draws.size(), slabs);
    EXPECT_EQ(situation.Slabs, static_cast<int>(slabs));
    for (double z : heights)
    {
      EXPECT_EQ(std::count_if(situation.Draws.begin(), situation.Draws.end(),
                  [&](const vtkShadowDraw& draw)
                  {
                    const auto [low, high] = situation.GetHeights(draw);
                    return low <= z && z <= high;
                  }),
        1)
        << z;
    }
  }
}

// With a point light, a volume in one face of the cube is clamped along the axis of that face; a
// volume in two faces is drawn whole.
TEST(ShadowPlan, SlabsOfOneFace)
{
  for (const double x : { 0.0, 10.0 })
  {
    SCOPED_TRACE("x " + std::to_string(x));
    Situation situation(MakeLightAbove(Kind::Point, 10.0), MakeCube().Translate(x, 0.0, 0.0));
    situation.UseFaces();
    // On rays through the cube, in steps of its distance from the light.
    for (double t : { 1.5, 1.6, 4.0 })
    {
      situation.AddFaceReceiver({ 1.01 * t * x, 0.1, 10.0 - 10.0 * t });
    }
    if (x == 0.0)
    {
      EXPECT_EQ(situation.Decide(vtkShadowMode::Clamped), Verdict::Clamped);
      ASSERT_EQ(situation.Slabs, 2);
      EXPECT_GT(situation.GetHeights(situation.Draws[0]).first, -20.0);
      EXPECT_LT(situation.GetHeights(situation.Draws[1]).second, -20.0);
    }
    else
    {
      EXPECT_EQ(situation.Decide(vtkShadowMode::Clamped), Verdict::Boxed);
      EXPECT_EQ(situation.Slabs, 0);
    }
    EXPECT_EQ(situation.Decide(vtkShadowMode::Scissored), Verdict::Boxed);
  }
}

// Receivers nearer to the light than the caster need no slab; those between the caster's depths
// share one slab with it.
TEST(ShadowPlan, SlabsThatReachTheCasterAreOne)
{
  const ShadowMesh tall = MakeCube().Move([](const Point& x) { return x * Point(1.0, 1.0, 20.0); });
  Situation situation(MakeLightAbove(), tall);
  const auto footprint = vtkShadowFootprint::Make(tall.Points, situation.Frame);
  for (double z : { 9.9, 0.0, -footprint.Block.High[2] + 0.5, -40.0 })
  {
    situation.AddReceiver({ 0.0, 0.0, z });
  }
  EXPECT_EQ(situation.Decide(vtkShadowMode::Clamped, 1), Verdict::Clamped);
  EXPECT_EQ(situation.Draws.size(), 2u);
  // Counted once: what is inside of both would be twice as deep in shadow.
  const auto upper = situation.GetHeights(situation.Draws[0]);
  const auto lower = situation.GetHeights(situation.Draws[1]);
  EXPECT_GT(upper.first, lower.second);

  Situation before(MakeLightAbove(), MakeCube(), { { 0.0, 0.0, 8.0 }, { 0.0, 0.0, -8.0 } });
  EXPECT_EQ(before.Decide(vtkShadowMode::Clamped), Verdict::Clamped);
  EXPECT_EQ(before.Draws.size(), 1u);
  EXPECT_LT(before.GetHeights(before.Draws[0]).second, 0.0);
}

// z-pass is used only where the whole piece is beyond the near plane.
TEST(ShadowPlan, ZPassNeedsAllOfThePieceBeyondTheNearPlane)
{
  Situation situation(MakeLightAbove(), MakeCube(), { { 0.0, 0.0, -4.0 }, { 0.0, 0.0, -50.0 } });
  situation.Decide(vtkShadowMode::Clamped);
  ASSERT_EQ(situation.Draws.size(), 2u);
  EXPECT_TRUE(situation.Draws[0].ZPass);
  EXPECT_TRUE(situation.Draws[1].ZPass);
  situation.SetNearPlane({ 0.0, 0.0, 1.0, 20.0 }); // Only what is above -20.
  situation.Decide(vtkShadowMode::Clamped);
  ASSERT_EQ(situation.Draws.size(), 2u);
  EXPECT_TRUE(situation.Draws[0].ZPass);
  EXPECT_FALSE(situation.Draws[1].ZPass);
  // The whole volume goes down for ever.
  situation.Decide(vtkShadowMode::Scissored);
  EXPECT_FALSE(situation.Draws.at(0).ZPass);
  // A near plane that looks down has all of it before itself.
  situation.SetNearPlane({ 0.0, 0.0, -1.0, 20.0 });
  situation.Decide(vtkShadowMode::Scissored);
  EXPECT_TRUE(situation.Draws.at(0).ZPass);
  // One that touches the cap does not.
  situation.SetNearPlane({ 0.0, 0.0, -1.0, -situation.Footprint.Block.High[2] });
  situation.Decide(vtkShadowMode::Scissored);
  EXPECT_FALSE(situation.Draws.at(0).ZPass);
  // Nor does one that is so near to the cap that a device, in single precision, may cut it off.
  situation.SetNearPlane({ 0.0, 0.0, -1.0, -situation.Footprint.Block.High[2] + 1e-7 });
  situation.Decide(vtkShadowMode::Scissored);
  EXPECT_FALSE(situation.Draws.at(0).ZPass);
  situation.SetNearPlane({ 0.0, 0.0, -1.0, -situation.Footprint.Block.High[2] + 1e-5 });
  situation.Decide(vtkShadowMode::Scissored);
  EXPECT_TRUE(situation.Draws.at(0).ZPass);
}

// Lines of sight of a parallel camera end at infinity, so that the volume of a positional light
// must end before.
TEST(ShadowPlan, PositionalVolumesOfParallelCamerasAreFinite)
{
  for (const Kind kind : { Kind::Spot, Kind::Point })
  {
    Situation situation(MakeLightAbove(kind, 3.0));
    situation.View.ParallelView = { { -5.0, -5.0, -5.0 }, { 5.0, 5.0, 5.0 } };
    situation.Decide(vtkShadowMode::Unclamped, 4, false);
    for (const glm::dvec4& vertex : situation.GetVolume().GetVertices())
    {
      EXPECT_EQ(vertex.w, 1.0);
    }
  }
}

// Near caps that lie in the caster's own surface are offset; of open meshes the sides as well.
TEST(ShadowPlan, CapsInTheirOwnSurfaceAreOffset)
{
  Situation closed(MakeLightAbove(), MakeCube(), { { 0.0, 0.0, -3.0 } });
  closed.Decide(vtkShadowMode::Scissored);
  EXPECT_EQ(closed.Draws.at(0).NumberOfOffsetIndices, 3 * 2) << "the bottom";
  EXPECT_EQ(closed.Draws.at(0).MaximumCount, 1);
  closed.Decide(vtkShadowMode::Clamped);
  EXPECT_EQ(closed.Draws.at(0).NumberOfOffsetIndices, 0) << "begins below the caster";
  Situation open(MakeLightAbove(), MakeOpenCube(), { { 0.0, 0.0, -3.0 } });
  open.Decide(vtkShadowMode::Scissored);
  EXPECT_EQ(open.Draws.at(0).NumberOfOffsetIndices, open.Draws.at(0).NumberOfIndices);
  open.Decide(vtkShadowMode::Clamped);
  EXPECT_EQ(open.Draws.at(0).NumberOfOffsetIndices, 0) << "begins below the caster";
  open.Decide(vtkShadowMode::Unclamped);
  EXPECT_EQ(open.Draws.at(0).NumberOfOffsetIndices, open.Draws.at(0).NumberOfIndices);
}
