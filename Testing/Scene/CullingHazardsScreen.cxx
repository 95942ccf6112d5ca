// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Rectangles of pixels: rounding, tiny and huge boxes, windows and viewports of every shape. Most
// scenes are given in pixels, so that it is known which props are covered.
#include "HazardBuilder.h"

#include <array>

namespace TestScene
{
namespace
{
using Verdict = vtkNBufferVerdict;
using Decision = vtkNBufferDecision;

/// A rectangle whose sides are at different places between pixels, and one behind it.
struct RoundingCase
{
  double Phase; ///< Of the covering rectangle's corners, in pixels.
  int Side;     ///< Left, right, lower, upper.
  double Out;   ///< By how many pixels the one behind sticks out there.
};

std::vector<RoundingCase> MakeRoundingCases()
{
  std::vector<RoundingCase> cases;
  for (double phase :
    { 0.0, 0.25, 0.4375, 0.5, 0.5 - 1e-5, 0.5 + 1e-5, 0.5 - 1.0 / 512, 0.5 + 1.0 / 512, 0.75 })
  {
    for (int side = 0; side < 4; ++side)
    {
      for (double out : { -1.25, -0.5, 0.0, 0.25, 0.5, 1.0 })
      {
        cases.push_back({ phase, side, out });
      }
    }
  }
  return cases;
}

/// A side at x.5 pixels may cover a pixel centre or not; a rectangle that is rounded inward loses
/// the row of pixels in which its box is seen.
NamedScenario RectanglesAtHalfPixels(int factor)
{
  HazardBuilder scene("RectanglesAtHalfPixels", 403, 299);
  scene.BeExact(factor);
  std::vector<int> sticksOut;
  std::vector<int> covered;
  for (const RoundingCase& c : MakeRoundingCases())
  {
    const int i = scene.GetNumberOfProps() / 2;
    const double x = 24.0 * (i % 16) + 6.0 + c.Phase;
    const double y = 20.0 * (i / 16) + 5.0 + c.Phase;
    scene.Quad(x, y, x + 14.0, y + 10.0, 50.0);
    double out[4] = { -3.0, -3.0, -3.0, -3.0 };
    out[c.Side] = c.Out;
    const int behind =
      scene.Quad(x - out[0], y - out[2], x + 14.0 + out[1], y + 10.0 + out[3], 20.0).Id;
    // In a strip of one pixel there is a centre; what lies 1.25 pixels inside needs none of the
    // pixels that the side cuts.
    if (c.Out >= 1.0)
    {
      sticksOut.push_back(behind);
    }
    else if (factor == 1 && c.Out <= -1.25)
    {
      covered.push_back(behind);
    }
  }
  scene.LookAtPixels();
  scene.Settle();
  for (double shift : { 0.0, 0.125, 0.25, 0.5, 0.5 - 1e-6, 0.5 + 1e-6, 0.75 })
  {
    scene.NextFrame();
    scene.LookAtPixels(shift, -shift);
    scene.ExpectNotHidden(sticksOut);
    scene.ExpectVerdict(covered, Verdict::Hidden);
  }
  return scene.Finish();
}

/// A box reaches far beyond the window on all sides. Its rectangle is cut after rounding, and a
/// single row or column of pixels at the border decides whether it is hidden.
NamedScenario BoxesLargerThanTheWindow(int factor)
{
  constexpr int width = 253;
  constexpr int height = 131;
  constexpr int count = 40;
  HazardBuilder scene("BoxesLargerThanTheWindow", width, height);
  scene.BeExact(factor);
  scene.Box({ 0.5 * width, 0.5 * height, 60.0 }, { 9e3, 9e3, 1.0 });
  for (int i = 0; i < count; ++i)
  {
    scene.Box({ 40.0 * i - 500.0, 90.0 - 7.0 * i, 40.0 - 3.0 * i }, { 3e3, 2e3, 0.5 });
  }
  scene.LookAtPixels();
  scene.Settle();
  scene.ExpectHidden(count, count);
  // Moved so that it leaves a column or a row of pixels to the next, behind which the others are.
  const glm::dvec3 column(4500.0 - 0.5 * width + 1.0, 0.0, 0.0);
  const glm::dvec3 row(0.0, 4500.0 - 0.5 * height + 1.0, 0.0);
  for (const glm::dvec3& gap : { column, -column, row, -row })
  {
    scene.NextFrame();
    scene.Move(0, gap);
    scene.Settle();
    scene.ExpectVerdict({ 1 }, Verdict::Visible);
    scene.ExpectHidden(count - 1, count - 1);
  }
  return scene.Finish();
}

/// The boxes are seen in perspective, from so near that they reach around the eye.
NamedScenario BoxesLargerThanTheWindowInPerspective()
{
  HazardBuilder scene("BoxesLargerThanTheWindow");
  scene.AddWall();
  for (double distance : { 6.0, 1.0, 0.3, 0.26 })
  {
    View& view = scene.LookFrom({ 0.0, 0.0, distance });
    view.Near = 0.005;
    view.Far = 40.0;
    scene.NextFrame();
    scene.ExpectCulled(Wall::Hidden);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Windows of a single texel, row or column, and windows with cut texels at the borders.
NamedScenario WallInWindow(int width, int height, int factor)
{
  HazardBuilder scene(
    "Each/CullerHazardWindows.Wall/" + std::to_string(width) + "x" + std::to_string(height), width,
    height);
  scene.BeExact(factor);
  scene.AddWall();
  scene.LookAtWall();
  for (int i = 1; i < 4; ++i)
  {
    scene.NextFrame();
    scene.LookAtWall(0.02 * i);
  }
  scene.ExpectDecision(Decision::Culled);
  scene.ExpectCulled(factor > 1 ? 0 : Wall::Hidden);
  return scene.Finish();
}

/// Walls in `count` renderers.
void AddWalls(HazardBuilder& scene, int count)
{
  scene.BeExact();
  scene.Scene.Renderers.resize(count);
  for (int renderer = 0; renderer < count; ++renderer)
  {
    scene.AddWall(renderer);
    scene.LookAtWall().Renderer = renderer;
  }
}

void SetViewport(HazardBuilder& scene, int renderer, const std::array<double, 4>& v)
{
  scene.Change(ChangeKind::Viewport, renderer, { v[0], v[1], v[2], v[3] });
}

/// A viewport begins and ends at fractions that are rounded up on one side and down on the other;
/// depth may be read one pixel away from where it was drawn.
NamedScenario ViewportsThatStartAnywhere()
{
  constexpr int w = 203;
  constexpr int h = 151;
  HazardBuilder scene("ViewportsThatStartAnywhere", w, h);
  AddWalls(scene, 4);
  const double splits[][2] = { { 0.5, 0.5 }, { 100.5 / w, 70.5 / h },
    { 100.5 / w + 1e-9, 70.5 / h - 1e-9 }, { 33.5 / w - 1e-9, 90.5 / h + 1e-9 },
    { 1.0 / 3.0, 0.618 }, { 0.25, 0.75 }, { 61.25 / w, 61.75 / h } };
  for (const auto& [x, y] : splits)
  {
    SetViewport(scene, 0, { 0.0, 0.0, x, y });
    SetViewport(scene, 1, { x, 0.0, 1.0, y });
    SetViewport(scene, 2, { 0.0, y, x, 1.0 });
    SetViewport(scene, 3, { x, y, 1.0, 1.0 });
    scene.Settle(2);
    for (int i = 0; i < 4; ++i)
    {
      scene.ExpectDecision(Decision::Culled, i);
      scene.ExpectCulled(Wall::Hidden, i);
      scene.ExpectHidden(Wall::Behind / 4, Wall::Count, i);
    }
    scene.NextFrame();
  }
  return scene.Finish();
}

/// Viewports of a pixel and less, and viewports that reach beyond the border of the window.
NamedScenario ViewportsOfAPixel()
{
  constexpr double w = 41.0;
  constexpr double h = 31.0;
  HazardBuilder scene("ViewportsOfAPixel", static_cast<int>(w), static_cast<int>(h));
  AddWalls(scene, 2);
  scene.Scene.Renderers[1].Viewport = { 0.0, 0.0, 0.5, 0.5 };
  const double viewports[][4] = { { 20.0, 15.0, 21.0, 16.0 }, { 20.5, 15.5, 21.5, 16.5 },
    { 40.0, 30.0, 41.0, 31.0 }, { 0.0, 0.0, 1.0, 31.0 }, { 0.5, 0.5, 40.5, 1.5 },
    { 39.5, 0.0, 41.0, 31.0 } };
  for (const auto& v : viewports)
  {
    SetViewport(scene, 0, { v[0] / w, v[1] / h, v[2] / w, v[3] / h });
    scene.Settle(2);
    scene.ExpectCulled(Wall::Hidden);
    scene.ExpectHidden(Wall::Behind / 2, Wall::Count, 1);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// A view that is mirrored in x, y or both reverses the winding of faces and the order of a box's
/// corners.
NamedScenario MirroredViews(const std::array<double, 2>& mirror, bool parallel)
{
  HazardBuilder scene("MirroredViews");
  scene.AddWall();
  for (int i = 0; i < 4; ++i)
  {
    View& view = scene.LookAtWall(0.1 * i);
    view.Stretch = mirror;
    view.Parallel = parallel;
    view.ParallelScale = 5.0;
    scene.ExpectHidden(i < 3 ? 0 : Wall::Hidden);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// A chain-link fence has gaps one pixel wide. A depth that is not reduced to the farthest one, or
/// is drawn at a lower resolution, closes the gaps and hides what is seen through them.
NamedScenario ChainLinkFence(int factor)
{
  constexpr int width = 301;
  constexpr int height = 201;
  constexpr double pitch = 5.0; // of the wires, in pixels along x
  constexpr double wide = 3.6;  // of a wire there: the gaps are a pixel from edge to edge
  constexpr int columns = 18;
  constexpr int rows = 8;
  const glm::dvec3 red(1.0, 0.0, 0.0);
  HazardBuilder scene("ChainLinkFence", width, height);
  scene.BeExact(factor);
  // A post of the fence, solid, and wires both ways: strips at 45 degrees.
  scene.Quad(120.0, 0.0, 180.0, height, 50.5);
  for (double x = -height; x < width + height; x += pitch)
  {
    for (const bool rising : { true, false })
    {
      const double dx = rising ? height : -height;
      const double z = rising ? 50.0 : 49.5;
      Prop& wire = scene.Sheet({ x, 0.0, z }, { wide, 0.0, 0.0 }, { dx, height, 0.0 });
      wire.Lighting = false;
      wire.Color = glm::dvec3(0.5);
    }
  }
  std::vector<int> behindPost;
  std::vector<int> behindWires;
  for (int i = 0; i < columns * rows; ++i)
  {
    // A box of nine pixels is larger than a mesh of the fence.
    const double left = 16.0 * (i % columns) + 10.0;
    Prop& box = scene.Box({ left + 4.5, 24.0 * (i / columns) + 15.0, 10.0 }, glm::dvec3(9.0));
    box.Lighting = false;
    box.Color = red;
    if (left > 129.0 && left + 9.0 < 171.0)
    {
      behindPost.push_back(box.Id);
    }
    else if (left + 9.0 <= 119.0 || left >= 181.0)
    {
      behindWires.push_back(box.Id);
    }
  }
  scene.LookAtPixels();
  scene.Settle();
  for (double shift : { 0.0, 0.3, 0.5 })
  {
    scene.NextFrame();
    scene.LookAtPixels(shift, shift);
    scene.ExpectPixels(red, 101); // There are gaps to see through.
    scene.ExpectVerdict(behindPost, Verdict::Hidden);
    scene.ExpectVerdict(behindWires, Verdict::Visible);
  }
  // At an angle, where the gaps narrow towards the far end and close.
  for (int i = 0; i < 3; ++i)
  {
    scene.NextFrame();
    View& view = scene.LookFrom({ -150.0 - 10.0 * i, 100.0, 350.0 }, { 150.0, 100.0 + i, 30.0 });
    view.Parallel = false;
    view.ViewAngle = 40.0;
    view.Near = 10.0;
    view.Far = 1500.0;
    scene.ExpectHidden(1);
  }
  return scene.Finish();
}

/// An occluder moves and uncovers what it hid, which has to be seen in the same frame.
NamedScenario AMovingOccluderUncoversWhatItHid()
{
  constexpr int height = 199;
  constexpr int columns = 20;
  constexpr int rows = 12;
  constexpr double width = 110.0; // of the occluder
  HazardBuilder scene("AMovingOccluderUncoversWhatItHid", 301, height);
  scene.BeExact();
  scene.Quad(0.0, 0.0, width, height, 60.0);
  for (int i = 0; i < columns * rows; ++i)
  {
    scene.Box({ 14.0 * (i % columns) + 10.0, 16.0 * (i / columns) + 10.0, 20.0 }, glm::dvec3(9.0));
  }
  scene.LookAtPixels();
  const struct
  {
    double Place;
    int MinimumHidden; // Some are drawn as a guess, or because they were visible before.
  } steps[] = { { 0.0, 72 }, { 0.0, 72 }, { 0.0, 84 }, { 17.3, 60 }, { 40.0, 60 }, { 40.5, 72 },
    { 90.0, 24 }, { 190.0, 0 }, { 190.0, 60 }, { 3.0, 0 }, { 3.0, 84 }, { 150.0, 0 }, { 20.25, 0 },
    { 150.0, 0 }, { 20.25, 0 }, { 400.0, 0 }, { 20.25, 0 }, { 20.25, 0 }, { 20.25, 84 } };
  std::vector<int> framesCovered(columns * rows, 0);
  for (const auto& [place, minimumHidden] : steps)
  {
    scene.Move(0, { place, 0.0, 0.0 });
    std::vector<int> stillCovered;
    std::vector<int> hidden;
    std::vector<int> uncovered;
    for (int i = 0; i < columns * rows; ++i)
    {
      const double left = 14.0 * (i % columns) + 5.5;
      const bool covered = left > place + 1.25 && left + 9.0 < place + width - 1.25;
      framesCovered[i] = covered ? framesCovered[i] + 1 : 0;
      if (framesCovered[i] > 1)
      {
        stillCovered.push_back(i + 1);
      }
      if (framesCovered[i] > 2)
      {
        hidden.push_back(i + 1);
      }
      else if (left < place - 1.0 || left + 9.0 > place + width + 1.0)
      {
        uncovered.push_back(i + 1);
      }
    }
    scene.ExpectVerdict(uncovered, Verdict::Visible);
    // What was visible in the last frame is drawn before the test.
    scene.ExpectStayHidden(stillCovered);
    scene.ExpectVerdict(hidden, Verdict::Hidden);
    scene.ExpectHidden(minimumHidden);
    scene.NextFrame();
  }
  return scene.Finish();
}

/// With multisampling a prop that covers no middle of a pixel may own samples.
NamedScenario SamplesThatAreNoMiddles(int samples)
{
  constexpr int count = 40;
  HazardBuilder scene("SamplesThatAreNoMiddles", 64, 48);
  scene.BeExact();
  scene.Scene.Window.MultiSamples = samples;
  for (int i = 0; i < count; ++i)
  {
    // Over the corner that four pixels share.
    const double x = 4.0 + 5.0 * (i % 10);
    const double y = 4.0 + 5.0 * (i / 10);
    scene.Quad(x - 0.4, y - 0.4, x + 0.4, y + 0.4, 50.0);
  }
  scene.LookAtPixels();
  scene.Settle(4);
  scene.ExpectHidden(samples > 0 ? 0 : count, samples > 0 ? 0 : count).NeedsSamples = samples > 0;
  return scene.Finish();
}
}

std::vector<NamedScenario> GetScreenHazards()
{
  std::vector<NamedScenario> hazards = { BoxesLargerThanTheWindowInPerspective(),
    ViewportsThatStartAnywhere(), ViewportsOfAPixel(), AMovingOccluderUncoversWhatItHid(),
    SamplesThatAreNoMiddles(0), SamplesThatAreNoMiddles(4) };
  for (const int factor : { 1, 4, 8 })
  {
    for (const auto& make : { RectanglesAtHalfPixels, BoxesLargerThanTheWindow, ChainLinkFence })
    {
      hazards.push_back(make(factor));
    }
  }
  hazards.push_back(ChainLinkFence(2));
  for (const auto& [width, height] :
    std::initializer_list<std::array<int, 2>>{ { 1, 1 }, { 2, 2 }, { 3, 1 }, { 1, 97 }, { 97, 1 },
      { 8, 8 }, { 9, 7 }, { 1, 1000 }, { 1500, 1 }, { 1021, 17 }, { 19, 1023 } })
  {
    hazards.push_back(WallInWindow(width, height, 1));
    hazards.push_back(WallInWindow(width, height, 8));
  }
  for (const bool parallel : { false, true })
  {
    hazards.push_back(MirroredViews({ -1.0, 1.0 }, parallel));
    hazards.push_back(MirroredViews({ 1.0, -1.0 }, parallel));
    hazards.push_back(MirroredViews({ -1.0, -1.0 }, parallel));
  }
  return hazards;
}
}
