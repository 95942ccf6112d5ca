// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Geometry with which culling by depth is most likely to be wrong.
#include "HazardBuilder.h"

#include <algorithm>
#include <cmath>

namespace TestScene
{
namespace
{
using Verdict = vtkNBufferVerdict;

//------------------------------------------------------------------------------------------------
/// Fifty props with exactly the same geometry: only the last one in the list is seen.
NamedScenario TheSameQuadFiftyTimes()
{
  HazardBuilder scene("TheSameQuadFiftyTimes");
  for (int i = 0; i < 50; ++i)
  {
    scene.Quad(-2.0, -2.0, 2.0, 2.0, 0.0);
  }
  const int door = scene.Box({ 0.0, 0.0, 2.0 }, { 4.0, 4.0, 0.1 }).Id;
  scene.LookFrom({ 0.0, 0.0, 12.0 });
  for (int i = 0; i < 8; ++i)
  {
    scene.Move(door, { i % 4 == 3 ? 9.0 : i % 4, 0.0, 0.0 });
    // None is hidden by another one's equal depth.
    scene.ExpectHidden(0, i % 4 == 0 ? 50 : 0);
    scene.NextFrame();
  }
  for (int i = 0; i < 4; ++i)
  {
    scene.Move(door, { 0.0, 0.0, 0.0 });
    scene.LookFrom({ 0.01 * i, 0.0, 12.0 });
    if (i == 3)
    {
      scene.ExpectVerdict(MakeRange(0, 50), Verdict::Hidden);
    }
    else
    {
      scene.NextFrame();
    }
  }
  return scene.Finish();
}

/// A decal is on the face of a box: its nearest depth is the farthest depth of its pixels.
NamedScenario DecalsOnFaces()
{
  HazardBuilder scene("DecalsOnFaces");
  for (int i = 0; i < 8; ++i)
  {
    for (int j = 0; j < 5; ++j)
    {
      const double x = 1.5 * i - 5.0;
      const double y = 1.3 * j - 2.5;
      scene.Box({ x, y, -0.5 }, { 1.0, 1.0, 1.0 });
      scene.Quad(x - 0.3, y - 0.3, x + 0.3, y + 0.3, 0.0);
      scene.Quad(x - 0.2, y - 0.2, x + 0.2, y + 0.2, 0.0, 3);
    }
  }
  scene.Box({ 0.0, 0.0, 3.0 }, { 4.0, 3.0, 0.2 });
  for (int i = 0; i < 10; ++i)
  {
    scene.LookFrom({ 6.0 * std::sin(0.8 * i), 0.3 * i, 14.0 });
    scene.ExpectHidden(6);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Tiles that abut share edges and faces; boxes are flush with their neighbours' faces.
NamedScenario AbuttingTilesAndBoxes()
{
  HazardBuilder scene("AbuttingTilesAndBoxes");
  for (int i = 0; i < 12; ++i)
  {
    for (int j = 0; j < 8; ++j)
    {
      scene.Quad(i - 6.0, j - 4.0, i - 5.0, j - 3.0, 0.0);
      scene.Box({ i - 5.5, j - 3.5, -0.5 - (i + j) % 2 }, { 1.0, 1.0, 1.0 });
    }
  }
  for (int i = 0; i < 8; ++i)
  {
    scene.LookFrom({ 0.8 * i - 3.0, 0.2 * i, 13.0 });
    scene.ExpectHidden(11);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// The eye flies through the props, into their boxes and out of them.
NamedScenario FlyingThroughBoxes()
{
  HazardBuilder scene("FlyingThroughBoxes");
  scene.AddWall();
  for (int i = 0; i < 24; ++i)
  {
    scene.LookFrom({ 0.2, 0.1, 4.0 - 0.5 * i }, { 0.1, 0.0, -20.0 });
    scene.ExpectHidden(i > 7 ? 0 : 16);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// A near plane set by hand cuts the wall open and shows what is behind it. The wall ends at 20.25.
NamedScenario NearPlaneCutsTheOccluder()
{
  HazardBuilder scene("NearPlaneCutsTheOccluder");
  scene.AddWall();
  for (const double near : { 19.0, 19.9, 20.0, 20.2, 20.3, 22.0, 25.0, 1.0 })
  {
    View& view = scene.LookAtWall();
    view.Near = near;
    view.Far = 40.0;
    // Behind an open wall they hide each other at most.
    scene.ExpectHidden(near >= 2.0 && near <= 20.25 ? 41 : 0, near < 20.25 ? 1000 : 9);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Coordinates of millions with details of centimetres: vertices are rounded to float. VTK moves
/// the points near to zero before that, so that as many props are hidden as near the origin.
NamedScenario FarFromTheOrigin(double offset)
{
  HazardBuilder scene("FarFromTheOrigin");
  const glm::dvec3 origin(offset, offset, 0.0);
  scene.Box(origin, { 12.0, 6.0, 0.5 });
  for (int i = 0; i < 60; ++i)
  {
    scene.Box(origin + glm::dvec3(0.13 * i - 4.0, 0.05 * (i % 50) - 1.0, -3.0), glm::dvec3(0.6));
    scene.Box(origin + glm::dvec3(0.13 * i - 4.0, 3.0, 0.26), glm::dvec3(0.01));
  }
  for (int i = 0; i < 4; ++i)
  {
    scene.LookFrom(origin + glm::dvec3(0.7 * i, 0.0, 20.0), origin);
    // The first frame draws the specks before the wall, and the second one finds out.
    scene.ExpectHidden(i < 2 ? 0 : 51);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Long props recede behind a wall that recedes as well: the nearest depth of a box is that of one
/// end, so that only the test of each pixel finds the props hidden.
NamedScenario LongPropsAreHiddenPixelByPixel(bool testPixels, int multiSamples)
{
  HazardBuilder scene("LongPropsAreHiddenPixelByPixel");
  scene.Scene.Window.MultiSamples = multiSamples;
  scene.Scene.Culler.TestPixels = testPixels;
  scene.Box({ -1.0, 0.0, -20.0 }, { 0.1, 6.0, 50.0 }); // the wall of a corridor
  for (int i = 0; i < 60; ++i)
  {
    scene.Box({ -1.6 - 0.02 * i, 0.05 * i - 1.5, -22.0 }, { 0.02, 0.02, 44.0 }); // a rail
  }
  scene.LookFrom({ 1.0, 0.0, 4.0 }, { -0.5, 0.0, -20.0 }).ViewAngle = 60.0;
  for (int i = 1; i < 4; ++i)
  {
    scene.NextFrame();
    scene.LookFrom({ 1.0 + 0.1 * i, 0.0, 4.0 }, { -0.5, 0.0, -20.0 });
  }
  scene.ExpectHidden(testPixels ? 21 : 0, testPixels ? 60 : 19).NeedsPixels = testPixels;
  return scene.Finish();
}

/// A large model matrix with small coordinates, and the other way round.
NamedScenario LargeMatricesAndScales()
{
  HazardBuilder scene("LargeMatricesAndScales");
  scene.AddWall();
  for (int i = 0; i < 30; ++i)
  {
    const double scale = std::pow(10.0, i % 7 - 3);
    Prop& box = scene.Box({ 1e3 / scale, 0.0, 0.0 }, glm::dvec3(0.5 / scale));
    box.Scale = glm::dvec3(scale);
    box.Position = { 0.25 * i - 4.0 - 1e3, 0.3, i % 2 ? -3.0 : 2.0 };
  }
  for (int i = 0; i < 4; ++i)
  {
    scene.LookAtWall(0.5 * i);
    scene.ExpectHidden(Wall::Hidden - 10);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Depth is squeezed towards 1 with a near plane of a millimetre.
NamedScenario ExtremeClippingRanges()
{
  HazardBuilder scene("ExtremeClippingRanges");
  scene.AddWall();
  const double ranges[][2] = { { 1e-3, 1e4 }, { 1e-3, 1e7 }, { 0.1, 1e7 }, { 10.0, 30.0 } };
  for (const auto& range : ranges)
  {
    for (int i = 0; i < 3; ++i)
    {
      View& view = scene.LookAtWall(0.2 * i);
      view.Near = range[0];
      view.Far = range[1];
      scene.ExpectHidden(Wall::Hidden);
      scene.NextFrame();
    }
  }
  return scene.Finish();
}

/// The near plane cuts a box. The part in front of the plane is not drawn, and its depth has no
/// meaning; the rest begins at depth 0, whatever the depths of the corners are.
NamedScenario NearPlaneThroughABox()
{
  constexpr int count = 24;
  constexpr double step = 0.25;
  HazardBuilder scene("NearPlaneThroughABox");
  scene.BeExact();
  scene.AddWall();
  for (int i = 0; i < count; ++i)
  {
    // From z = 0.5 on, each 0.5 long, beside each other before the wall and some small enough to
    // lie behind it wholly if their depth were taken for that of the far side.
    scene.Box({ 0.24 * i - 2.8, 0.0, 0.75 + step * i }, { 0.2, 1.0, 0.5 });
  }
  scene.LookAtWall();
  scene.Settle();
  scene.ExpectHidden(Wall::Hidden);
  // At faces, just beside faces, and between them; the wall stays in view.
  for (double z : { 2.0, 2.0 + 1e-9, 2.0 - 1e-9, 2.0 + 1e-5, 2.0 - 1e-5, 2.1, 3.25, 5.9, 0.6 })
  {
    scene.NextFrame();
    View& view = scene.LookAtWall();
    view.Near = 20.0 - z;
    view.Far = 40.0;
    scene.NextFrame();
    for (int i = 0; i < count; ++i)
    {
      const double begin = 0.5 + step * i;
      const bool beyond = begin > z + 1e-4;
      const bool cut = begin < z - 1e-4 && begin + 0.5 > z + 1e-4;
      const std::vector<int> box = { Wall::Count + i };
      if (beyond || cut)
      {
        scene.ExpectVerdict(box, beyond ? Verdict::Outside : Verdict::NearPlane);
      }
      else
      {
        scene.ExpectNotHidden(box);
      }
    }
    scene.ExpectHidden(Wall::Hidden);
  }
  return scene.Finish();
}

/// The eye is inside a box, and sees its inner faces in all directions, wherever its corners are.
NamedScenario EyeInsideABox(bool parallel)
{
  constexpr int rooms = 3;
  constexpr int each = 120;
  HazardBuilder scene("EyeInsideABox");
  scene.BeExact();
  // Rooms in each other; the walls of the smallest hide all that is outside of it.
  for (double side : { 10.0, 11.0, 30.0 })
  {
    scene.Box({ 0.0, 0.0, 0.0 }, glm::dvec3(side));
  }
  for (int i = 0; i < each; ++i)
  {
    const double r = 7.0 + 0.03 * i;
    const glm::dvec3 outside(r * std::sin(0.7 * i), 0.02 * i - 1.0, r * std::cos(0.7 * i));
    scene.Box(outside, { 0.4, 0.4, 0.4 });
    scene.Box(outside * glm::dvec3(0.4, 1.0, 0.4), { 0.1, 0.1, 0.1 });
  }
  for (int i = 0; i < 8; ++i)
  {
    const double angle = i < 3 ? 0.0 : 0.8 * i;
    View& view =
      scene.LookFrom({ 0.1, 0.0, 0.2 }, { 0.1 + std::sin(angle), 0.1, 0.2 + std::cos(angle) });
    view.ViewAngle = 60.0;
    view.Near = 0.05;
    view.Far = 60.0;
    view.Parallel = parallel;
    view.ParallelScale = 2.0;
    scene.NextFrame();
    scene.ExpectVerdict(MakeRange(0, rooms), Verdict::NearPlane);
    scene.ExpectVerdicts(
      MakeRange(rooms, rooms + 2 * each, 2), { Verdict::Hidden, Verdict::Outside }, each / 20 + 1);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Points behind the eye have w < 0: divided by w, they would be upside down on the screen. A part
/// of a box that reaches from before the eye to behind it is in view.
NamedScenario BoxesBehindTheEyeAndBesideIt()
{
  constexpr int each = 40;
  HazardBuilder scene("BoxesBehindTheEyeAndBesideIt");
  scene.BeExact();
  // A wall on the left that begins beside the eye.
  scene.Box({ -1.0, 0.0, -20.0 }, { 0.1, 60.0, 60.0 });
  for (int i = 0; i < each; ++i)
  {
    const double y = 0.05 * i - 1.0;
    scene.Box({ 0.1 * i - 2.0, y, 3.0 + 0.1 * i }, { 0.3, 0.3, 0.3 });     // behind the eye
    scene.Box({ -3.0 - 0.02 * i, y, -10.0 }, { 0.02, 0.02, 40.0 });        // behind the wall
    scene.Box({ 0.5 + 0.02 * i, 0.2 * y, -10.0 }, { 0.005, 0.005, 40.0 }); // in view
  }
  for (int i = 0; i < 6; ++i)
  {
    View& view = scene.LookFrom({ 0.02 * i, 0.0, 0.0 }, { 0.02 * i, 0.0, -1.0 });
    view.ViewAngle = 50.0;
    view.Near = 0.1;
    view.Far = 100.0;
    scene.ExpectVerdict(MakeRange(1, 3 * each, 3), Verdict::Outside);
    scene.ExpectNotHidden(MakeRange(3, 3 * each + 1, 3));
    if (i > 2)
    {
      scene.ExpectVerdict(MakeRange(2, 3 * each, 3), Verdict::Hidden);
    }
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Boxes are smaller than a pixel, between the centres of pixels or on one, and are seen past an
/// edge or through a hole of one pixel.
NamedScenario BoxesSmallerThanAPixel()
{
  constexpr int width = 211;
  constexpr int height = 157;
  constexpr double left = 40.5;
  constexpr double right = 170.25;
  constexpr double hole = 100.0; // lower left corner of a pixel, in x and y
  constexpr double inHole = hole + 0.5;
  HazardBuilder scene("BoxesSmallerThanAPixel", width, height);
  scene.BeExact();
  // A wall in four parts around the hole.
  scene.Quad(left, 20.0, hole, 140.0, 50.0);
  scene.Quad(hole + 1.0, 20.0, right, 140.0, 50.0);
  scene.Quad(hole, 20.0, hole + 1.0, hole, 50.0);
  scene.Quad(hole, hole + 1.0, hole + 1.0, 140.0, 50.0);
  std::vector<int> visible;
  std::vector<int> hidden;
  const auto add = [&](double x, double y, bool before)
  {
    const int prop = scene.Box({ x, y, before ? 80.0 : 20.0 }, { 0.1, 0.1, 0.1 }).Id;
    const auto isInMiddle = [](double value)
    { return std::abs(value - std::floor(value) - 0.5) <= 0.05; };
    if (before || x < left - 0.6 || x > right + 0.6 || (x == inHole && y == inHole))
    {
      // Never dropped for being small, unless no middle of a pixel is in it.
      if (isInMiddle(x) && isInMiddle(y))
      {
        visible.push_back(prop);
      }
    }
    else if (x > left + 1.25 && x < right - 1.25 &&
      std::max(std::abs(x - inHole), std::abs(y - inHole)) > 2.0)
    {
      hidden.push_back(prop);
    }
  };
  for (int i = 0; i < 130; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      add(20.0 + 1.37 * i, 60.0 + 7.23 * j + 0.11 * i, (i + j) % 3 == 0);
    }
  }
  add(inHole, inHole, false);
  scene.LookAtPixels();
  scene.Settle();
  scene.ExpectVerdict(visible, Verdict::Visible);
  scene.ExpectVerdict(hidden, Verdict::Hidden);
  scene.ExpectHidden(201);
  return scene.Finish();
}

/// The camera jumps back and forth between views that have nothing in common; what is known from
/// one view must not be used in the other.
NamedScenario TheCameraJumpsBackAndForth()
{
  HazardBuilder scene("TheCameraJumpsBackAndForth");
  scene.BeExact();
  scene.AddWall();
  const glm::dvec3 eyes[] = { { 0.0, 0.0, 20.0 }, { 3.0, 0.5, -20.0 }, { 0.0, 40.0, 0.1 },
    { 0.0, 0.0, 60.0 }, { 25.0, 0.0, -3.0 } };
  int last = -1;
  for (int view : { 0, 0, 1, 0, 0, 1, 0, 2, 0, 0, 2, 3, 0, 0, 4, 0, 4, 1, 4, 0, 0 })
  {
    scene.LookFrom(eyes[view]);
    // The first frame after a jump also draws what the other view saw.
    scene.ExpectHidden(view == 0 && last == 0 ? Wall::Hidden - 12 : 0);
    scene.ExpectDecision(vtkNBufferDecision::Culled);
    scene.NextFrame();
    last = view;
  }
  return scene.Finish();
}
}

std::vector<NamedScenario> GetCullingHazards()
{
  std::vector<NamedScenario> hazards = { TheSameQuadFiftyTimes(), DecalsOnFaces(),
    AbuttingTilesAndBoxes(), FlyingThroughBoxes(), NearPlaneCutsTheOccluder(),
    LargeMatricesAndScales(), ExtremeClippingRanges(), NearPlaneThroughABox(), EyeInsideABox(false),
    EyeInsideABox(true), BoxesBehindTheEyeAndBesideIt(), BoxesSmallerThanAPixel(),
    TheCameraJumpsBackAndForth() };
  for (const int samples : { 0, 4 })
  {
    hazards.push_back(LongPropsAreHiddenPixelByPixel(false, samples));
    hazards.push_back(LongPropsAreHiddenPixelByPixel(true, samples));
  }
  for (const double offset : { 1e4, 1e6, 5e6 })
  {
    hazards.push_back(FarFromTheOrigin(offset));
  }
  for (const auto& part :
    { GetScreenHazards(), GetShapeHazards(), GetSharedHazards(), GetBoundsHazards() })
  {
    hazards.insert(hazards.end(), part.begin(), part.end());
  }
  return hazards;
}
}
