// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines and points, equal depths, depths that cannot be distinguished, matrices.
#include "HazardBuilder.h"

#include "vtkMapper.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace TestScene
{
namespace
{
using Verdict = vtkNBufferVerdict;

/// Of props with equal depths the one that is drawn last is seen, and a culler draws in another
/// order. Stacks of coplanar quads of different colours appear from behind a sliding door.
NamedScenario QuadsFacingTheCamera(int seed, bool parallel)
{
  HazardBuilder scene("Seed/CullerTies.QuadsFacingTheCamera/" + std::to_string(seed - 1));
  scene.Scene.Culler.RoundSize = 5; // many rounds, many orders
  const int door = scene.AddTies(seed, seed % 2 == 0);
  for (int i = 0; i < 10; ++i)
  {
    scene.Move(door, { 2.5 * std::sin(1.3 * i), 1.5 * std::cos(0.9 * i), 0.0 });
    View& view = scene.LookFrom({ 0.02 * i, 0.0, 15.0 }, { 0.02 * i, 0.0, 0.0 });
    view.Parallel = parallel;
    view.ParallelScale = 4.0;
    scene.ExpectHidden(1);
    scene.NextFrame();
  }
  // Jumps: what is visible changes wholly.
  for (int i = 0; i < 6; ++i)
  {
    scene.LookFrom({ i % 2 ? 3.0 : -3.0, 0.0, 15.0 });
    scene.ExpectHidden(6);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Seen at an angle, coplanar quads have z-fighting that depends on the order of drawing.
NamedScenario QuadsAtAnAngle(int seed)
{
  HazardBuilder scene("Seed/CullerTies.QuadsAtAnAngle/" + std::to_string(seed - 1));
  scene.Scene.Culler.RoundSize = 7;
  const int door = scene.AddTies(100 + seed, true);
  for (int i = 0; i < 12; ++i)
  {
    scene.Move(door, { 2.5 * std::sin(1.3 * i), 0.0, 0.0 });
    scene.LookFrom({ 9.0 * std::sin(0.7 * i), 3.0 * std::cos(0.5 * i), 12.0 });
    scene.ExpectHidden(1).NeedsPixels = true;
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Corners behind the eye have no place on the screen; their box must count as visible.
NamedScenario BoxesThroughTheNearPlaneAndAroundTheEye()
{
  HazardBuilder scene("BoxesThroughTheNearPlaneAndAroundTheEye");
  scene.AddWall();
  const int past = scene.Box({ 3.0, 2.0, 15.0 }, { 1.0, 1.0, 40.0 }).Id;
  const int floor = scene.Box({ 0.0, -5.0, 10.0 }, { 40.0, 1.0, 60.0 }).Id;
  Prop& room = scene.Box({ 0.0, 0.0, 0.0 }, { 90.0, 90.0, 90.0 });
  room.CulledFaces = 1;
  const int around = room.Id;
  const int behind = scene.Box({ 0.0, 0.0, 40.0 }, { 1.0, 1.0, 1.0 }).Id;
  for (int i = 0; i < 6; ++i)
  {
    scene.LookAtWall(0.1 * i);
    // These reach behind the eye, but not through the near plane in view.
    scene.ExpectVerdict({ past, floor }, Verdict::Visible);
    scene.ExpectVerdict({ around }, Verdict::NearPlane);
    // In the first frame the default culler still stood before ours.
    scene.ExpectVerdict({ behind }, i ? Verdict::Outside : Verdict::Unknown);
    // In the first frame the nearest props are drawn untested, in the second as visible before.
    scene.ExpectHidden(i > 1 ? Wall::Hidden : 40);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Bounds without thickness, and bounds that are a line or a point. Lines are drawn, hidden or not.
NamedScenario FlatThinAndSinglePointBounds()
{
  constexpr int each = 12; // before and behind the wall
  HazardBuilder scene("FlatThinAndSinglePointBounds");
  scene.AddWall();
  std::vector<int> lines;
  std::vector<int> others;
  for (double z : { 3.0, -3.0 })
  {
    for (int i = 0; i < 10; ++i)
    {
      const double x = 0.7 * i - 3.3;
      const bool isLine = i % 3 != 0;
      Prop& prop = scene.Mesh({ { x, 0.5, z }, { x + 0.4, i % 3 == 1 ? 0.5 : 0.9, z } },
        { isLine ? std::vector<int>{ 0, 1 } : std::vector<int>{ 0 } });
      if (!isLine)
      {
        prop.Shape.Points.resize(3);
      }
      prop.LineWidth = 1.0 + i;
      prop.PointSize = 1.0 + 2.0 * i;
    }
    scene.Quad(-2.0, -1.0, 2.0, -1.0, z); // an edge
    scene.Quad(2.0, 1.0, 2.0, 1.0, z);    // a point
  }
  for (int i = 0; i < each; ++i)
  {
    (i < 10 && i % 3 != 0 ? lines : others).push_back(Wall::Count + each + i);
  }
  for (int i = 0; i < 6; ++i)
  {
    scene.LookAtWall(1.7 * i);
    scene.ExpectHidden(i < 2 ? 0 : Wall::Hidden + static_cast<int>(others.size()));
    // The edge and the point have no fragments.
    scene.ExpectNotHidden(MakeRange(Wall::Count, Wall::Count + each - 2));
    scene.ExpectVerdict(lines, Verdict::NotASurface);
    scene.ExpectVerdict(others, Verdict::Hidden);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Wide lines and large points reach out of the projection of their bounds, past the edge of the
/// occluder that hides these bounds.
NamedScenario WideLinesStickOutOfTheirBounds()
{
  HazardBuilder scene("WideLinesStickOutOfTheirBounds");
  scene.AddWall();
  for (int i = 0; i < 24; ++i)
  {
    // Just behind the upper edge of the wall.
    const double x = 0.4 * i - 5.0;
    const double y = 3.0 - 0.01 * i;
    Prop& prop = scene.Mesh({ { x, y, -0.4 }, { x + 0.3, y, -0.4 } },
      i % 2 ? std::vector<std::vector<int>>{ { 0, 1 } }
            : std::vector<std::vector<int>>{ { 0 }, { 1 } });
    prop.LineWidth = 8.0;
    prop.PointSize = 9.0;
  }
  for (int i = 0; i < 6; ++i)
  {
    scene.LookAtWall(0.3 * i);
    scene.ExpectHidden(Wall::Hidden);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// The depth of a line is extrapolated beyond its ends by half a pixel: if it is seen end-on,
/// through the wall before it.
NamedScenario LinesSeenEndOn()
{
  HazardBuilder scene("LinesSeenEndOn");
  scene.AddWall();
  std::minstd_rand random(1);
  const auto between = [&random](double a, double b)
  { return a + (b - a) * static_cast<double>(random() % 100000) / 100000.0; };
  for (int i = 0; i < 100; ++i)
  {
    std::vector<glm::dvec3> points;
    std::vector<std::vector<int>> lines;
    for (int k = 0; k < 40; ++k)
    {
      const double x = between(-4.0, 4.0);
      const double y = between(-2.0, 2.0);
      // The eye is at z = 20: towards it, but for a pixel or so.
      const double near = 1.0 - (-0.4) / 20.0;
      const double far = 1.0 - (-2.0) / 20.0;
      const double asideX = between(-0.03, 0.03);
      points.emplace_back(x * near, y * near, -0.4);
      points.emplace_back(x * far + asideX, y * far + between(-0.03, 0.03), -2.0);
      lines.push_back({ 2 * k, 2 * k + 1 });
    }
    scene.Mesh(points, lines);
  }
  scene.LookAtWall();
  for (int i = 0; i < 4; ++i)
  {
    scene.ExpectHidden(Wall::Hidden);
    scene.NextFrame();
  }
  scene.ExpectVerdict({ Wall::Count }, Verdict::NotASurface);
  return scene.Finish();
}

/// With the near plane at a millimetre and the far plane at 10,000 km, almost all depths are
/// close to 1. From some distance on they cannot be distinguished, and verdicts would be random.
NamedScenario NearOfAMillimetreAndFarOfTenThousandKilometres(bool parallel)
{
  constexpr int columns = 9;
  constexpr int behind = 4;
  HazardBuilder scene("NearOfAMillimetreAndFarOfTenThousandKilometres", 321, 151);
  scene.BeExact();
  // Column by column ten times as far; the same size on the screen everywhere.
  for (int i = 0; i < columns; ++i)
  {
    const double distance = std::pow(10.0, i - 2);
    const auto add = [&](double factor, double size)
    {
      const double d = factor * distance;
      const double s = parallel ? 1.0 : d;
      scene.Box({ s * (0.2 * i - 0.8), 0.0, -d }, { s * size, 3.0 * s * size, 0.02 * d });
    };
    add(1.0, 0.17);
    for (int k = 0; k < behind; ++k)
    {
      add(1.6 + k, 0.08);
    }
  }
  const auto look = [&](double shift)
  {
    View& view = scene.LookFrom({ shift, 0.0, 0.0 }, { shift, 0.0, -1.0 });
    view.ViewAngle = 60.0;
    view.Parallel = parallel;
    view.ParallelScale = 0.58;
    view.Near = 1e-3;
    view.Far = 1e7;
  };
  look(0.0);
  scene.Settle(4);
  for (int frame = 1; frame < 3; ++frame)
  {
    scene.NextFrame();
    look(1e-4 * frame);
  }
  for (int i = 0; i < columns; ++i)
  {
    const int first = i * (behind + 1);
    scene.ExpectNotHidden({ first });
    // Window depth is 1 - near / distance in perspective, and distance / far in parallel.
    const double distance = std::pow(10.0, i - 2);
    const double step = parallel ? 0.6 * distance * 1e-7 : 1e-3 / distance * (1.0 - 1.0 / 1.6);
    const std::vector<int> others = MakeRange(first + 1, first + 1 + behind);
    if (step <= std::ldexp(1.0, -25))
    {
      scene.ExpectNotHidden(others);
    }
    else if (step >= std::ldexp(1.0, -13))
    {
      scene.ExpectVerdict(others, Verdict::Hidden);
    }
  }
  return scene.Finish();
}

/// Matrices mirror, shear, flatten and rotate actors: the winding of faces is reversed, and bounds
/// are those of eight transformed corners.
NamedScenario UserMatricesWithMirrorAndShear()
{
  constexpr int each = 48;
  HazardBuilder scene("UserMatricesWithMirrorAndShear", 401, 233);
  scene.BeExact();
  scene.AddWall();
  for (int i = 0; i < 3 * each; ++i)
  {
    const int kind = i % each;
    // Behind the wall, before it, and across its upper edge.
    const double place[3][2] = { { 0.3, -3.0 }, { 1.1 * (kind % 4) - 1.6, 3.0 }, { 3.2, -2.0 } };
    Prop& prop = scene.Box({ 0.0, 0.0, 0.0 }, { 0.4, 0.3, 0.2 });
    const double flattened = kind % 7 == 6 ? 0.0 : 1.0;
    prop.UserMatrix = { kind & 1 ? -1.0 : 1.0, kind & 8 ? 0.8 : 0.0, 0.0, 0.15 * kind - 3.5, //
      0.0, kind & 2 ? -1.3 : 0.7, kind & 16 ? -0.6 : 0.0, place[i / each][0],                //
      kind & 32 ? 0.5 : 0.0, 0.0, kind & 4 ? -flattened : flattened, place[i / each][1],     //
      0.0, 0.0, 0.0, 1.0 };
    prop.Orientation = { 0.0, 0.0, kind % 5 == 4 ? 20.0 : 0.0 };
    prop.CulledFaces = kind % 3 == 2 ? 2 : 0;
  }
  scene.LookAtWall();
  for (int i = 1; i < 6; ++i)
  {
    scene.NextFrame();
    scene.LookAtWall(0.05 * i);
  }
  const std::vector<int> behind = MakeRange(Wall::Count, Wall::Count + each);
  scene.ExpectVerdict(behind, Verdict::Hidden);
  scene.ExpectVerdict(MakeRange(Wall::Count + each, Wall::Count + 2 * each), Verdict::Visible);
  // A matrix changed behind an unmodified actor: sheared out past the edge of the wall.
  scene.NextFrame();
  for (const int prop : behind)
  {
    std::vector<double> matrix = scene.Scene.Props[prop].UserMatrix;
    matrix[1] = 80.0;
    scene.Change(ChangeKind::UserMatrix, prop, matrix);
  }
  scene.ExpectNotHidden(behind);
  return scene.Finish();
}

/// In a row of parts whose fronts overlap, one part is drawn late, and all others are drawn again.
NamedScenario PartsThatTouchAreDrawnAgainWhereTheyTouch()
{
  HazardBuilder scene("PartsThatTouchAreDrawnAgainWhereTheyTouch");
  // From the far end to the near one, and a door before the first.
  for (int i = 0; i < 50; ++i)
  {
    scene.Box({ 0.2 * i - 5.0, 0.0, 0.0 }, { 0.3, 0.6, 0.2 });
  }
  const int door = scene.Box({ -5.0, 0.0, 1.0 }, { 0.4, 1.2, 0.05 }).Id;
  scene.LookFrom({ -5.0, 0.0, 25.0 });
  scene.Settle(2);
  scene.ExpectHidden(1, 1);
  scene.NextFrame();
  scene.Move(door, { 0.0, 2.0, 0.0 });
  // The second part is drawn again, where it overlaps the first; not the 48 that follow.
  scene.ExpectHidden(0, 0).Statistics = [](const vtkNBufferStatistics& statistics)
  { return statistics.DrawnInRound[1] == 1 && statistics.Redrawn == 1; };
  return scene.Finish();
}

/// The nearest depth of a box that is flush with its own surface is the depth that the prop itself
/// has drawn. By rounding, the prop would hide itself and flicker from then on. It is seen from the
/// front in perspective and in parallel projection, with a clipping range in which 0.1 is less than
/// a step of depth, and at an angle.
NamedScenario BoxesFlushWithTheirOwnSurface(int variant)
{
  constexpr int columns = 12;
  constexpr int count = columns * 8;
  HazardBuilder scene("BoxesFlushWithTheirOwnSurface", 401, 301);
  scene.BeExact();
  // With gaps, so that at an angle none hides its neighbour.
  const auto getX = [](int i) { return 1.4 * (i % columns) - 8.0; };
  const auto getY = [](int i) { return 1.4 * (i / columns) - 5.0; };
  for (int i = 0; i < count; ++i)
  {
    const double x = getX(i);
    const double y = getY(i);
    const int kind = i % columns + i / columns;
    kind % 2 ? scene.Box({ x, y, -0.05 }, { 1.0, 1.0, 0.1 })
             : scene.Quad(x - 0.5, y - 0.5, x + 0.5, y + 0.5, 0.0, 1 + kind % 4);
  }
  // And boxes flush with the backs of the others' faces: hidden wholly.
  for (int i = 0; i < count; ++i)
  {
    scene.Box({ getX(i), getY(i), -0.35 }, glm::dvec3(0.5));
  }
  for (int i = 0; i < 6; ++i)
  {
    const double y = 0.01 * i;
    const bool oblique = variant == 3;
    View& view =
      scene.LookFrom({ oblique ? 12.0 : 0.0, y, oblique ? 22.0 : 25.0 }, { 0.0, y, 0.0 });
    view.Parallel = variant == 1;
    view.ParallelScale = 7.0;
    view.Near = variant == 2 ? 1e-2 : 0.0;
    view.Far = variant == 2 ? 1e5 : 0.0;
    if (i > 2)
    {
      scene.ExpectVerdict(MakeRange(0, count), Verdict::Visible);
      // No prop was found hidden by its own depth and then drawn late.
      scene.ExpectHidden(variant < 2 ? count : 0).Statistics = [](const vtkNBufferStatistics& s)
      { return s.HeldBack <= std::max(s.GetCount(Verdict::Hidden), 1); };
      if (variant < 2)
      {
        scene.ExpectVerdict(MakeRange(count, 2 * count), Verdict::Hidden);
      }
    }
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Offsets for coincident surfaces draw a prop in front of an occluder that its bounds are behind;
/// visible edges switch offsets on without any setting. `mode` is a value of
/// ChangeKind::PolygonOffset.
NamedScenario OffsetsBehindTheWall(const std::string& name, int mode)
{
  constexpr int each = 16;
  HazardBuilder scene("Mode/CullerOffsets.BehindTheWall/" + name);
  scene.BeExact(4);
  scene.AddWall();
  scene.Change(ChangeKind::PolygonOffset, 0, { static_cast<double>(mode) });
  std::vector<int>
    ofKind[5]; // plain, with edges, pulled forward, pushed back, edges pulled forward
  for (int i = 0; i < 5 * each; ++i)
  {
    // Just behind the wall's back, all of them pulled forward as far as it may be.
    const int kind = i % 5;
    Prop& box = scene.Box(
      { 0.6 * (i / 5) - 4.6, 1.5 - 0.75 * kind, -0.5 }, { 0.4, 0.4, kind % 2 ? 0.4 : 0.1 });
    box.Edges = kind == 1 || kind == 4;
    box.LineWidth = box.Edges ? 3.0 : 1.0;
    const bool isPulled = kind == 2 || kind == 4;
    box.OffsetFactor = isPulled ? -40.0 : kind == 3 ? 2.0 : 0.0;
    box.OffsetUnits = isPulled ? -4000.0 : kind == 3 ? 4000.0 : 0.0;
    ofKind[kind].push_back(box.Id);
  }
  scene.LookAtWall();
  for (int i = 1; i < 5; ++i)
  {
    scene.NextFrame();
    scene.LookAtWall(0.1 * i);
  }
  const bool shifted = mode == VTK_RESOLVE_SHIFT_ZBUFFER;
  const Verdict unlessShifted = shifted ? Verdict::DepthOffset : Verdict::Hidden;
  scene.ExpectVerdict(ofKind[0], unlessShifted);
  const auto ifEdgesAreInside = [](Verdict verdict)
  { return VTKNBUFFER_EDGES_KEEP_TRIANGLES ? verdict : Verdict::NotASurface; };
  scene.ExpectVerdict(ofKind[1], ifEdgesAreInside(unlessShifted));
  scene.ExpectVerdict(ofKind[2], mode == VTK_RESOLVE_OFF ? Verdict::Hidden : Verdict::DepthOffset);
  scene.ExpectVerdict(ofKind[3], unlessShifted);
  scene.ExpectVerdict(ofKind[4], ifEdgesAreInside(Verdict::DepthOffset));
  scene.ExpectHidden(shifted ? 0 : Wall::Hidden);
  return scene.Finish();
}
}

std::vector<NamedScenario> GetShapeHazards()
{
  std::vector<NamedScenario> hazards = { BoxesThroughTheNearPlaneAndAroundTheEye(),
    FlatThinAndSinglePointBounds(), WideLinesStickOutOfTheirBounds(), LinesSeenEndOn(),
    NearOfAMillimetreAndFarOfTenThousandKilometres(false),
    NearOfAMillimetreAndFarOfTenThousandKilometres(true), UserMatricesWithMirrorAndShear(),
    PartsThatTouchAreDrawnAgainWhereTheyTouch(), OffsetsBehindTheWall("Off", VTK_RESOLVE_OFF),
    OffsetsBehindTheWall("PolygonOffset", VTK_RESOLVE_POLYGON_OFFSET),
    OffsetsBehindTheWall("ShiftZBuffer", VTK_RESOLVE_SHIFT_ZBUFFER) };
  for (int variant = 0; variant < 4; ++variant)
  {
    hazards.push_back(BoxesFlushWithTheirOwnSurface(variant));
  }
  for (int seed = 1; seed < 7; ++seed)
  {
    hazards.push_back(QuadsFacingTheCamera(seed, true));
    hazards.push_back(QuadsFacingTheCamera(seed, false));
    hazards.push_back(QuadsAtAnAngle(seed));
  }
  return hazards;
}
}
