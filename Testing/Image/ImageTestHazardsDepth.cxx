// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Depth: its formats and their steps.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkNBufferDepthSource.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <vector>

using Scenes::AddQuad;
using Scenes::Wall;

//------------------------------------------------------------------------------------------------
namespace
{
struct Format : NamedCase
{
  int Texture;        ///< A format of vtkTextureObject; -1: as the window comes.
  bool Stencil;       ///< vtkRenderWindow::SetStencilCapable
  int Samples;        ///< Of the window.
  int Bits;           ///< That the driver has to give at least; 0: whatever it gives.
  bool Float = false; ///< Floating-point depth.
};
class CullerDepthFormats : public testing::TestWithParam<Format>
{
public:
  static constexpr int Width = 301;
  static constexpr int Height = 173;

  ComparisonOptions GetOptions(int backend) const
  {
    ComparisonOptions options = Scenes::MakeExactOptions(Width, Height);
    options.Backend = backend;
    // On the device by the levels alone, which it then makes of each format.
    options.Tuning.TestPixels = backend == vtkNBufferCuller::CPU;
    options.MultiSamples = this->GetParam().Samples;
    // VTK cannot read multisampled depth whose format is not that of its other framebuffers.
    options.CompareDepth = this->GetParam().Samples == 0;
    options.ReadRendered = this->GetParam().Texture >= 0;
    return options;
  }

  void SetFormat(Stage& stage) const
  {
    const Format& format = this->GetParam();
    stage.Window->SetStencilCapable(format.Stencil);
    stage.Window->Render(); // makes the framebuffers
    if (format.Texture >= 0)
    {
      Scenes::SetDepthFormat(stage, format.Texture);
    }
  }

  /// What the culler finds there.
  vtkNBufferDepthSource Inspect(Stage& stage) const
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
    vtkNBufferDepthSource source;
    std::string why;
    window->MakeCurrent();
    window->GetState()->PushFramebufferBindings();
    window->GetRenderFramebuffer()->Bind();
    EXPECT_TRUE(source.Inspect(window, why)) << why;
    window->GetState()->PopFramebufferBindings();
    return source;
  }

  void CheckFormat(Comparison& comparison) const
  {
    const Format& format = this->GetParam();
    for (Stage* stage : { &comparison.Reference, &comparison.Culled })
    {
      const vtkNBufferDepthSource source = this->Inspect(*stage);
      EXPECT_EQ(source.FloatDepth, format.Float);
      EXPECT_GE(source.DepthBits, std::max(format.Bits, 16));
      EXPECT_TRUE(format.Bits != 16 || source.DepthBits == 16);
      EXPECT_EQ(source.Samples > 1, format.Samples > 1);
    }
  }
};
}

// Hazard: a step of the depth format is larger than the distance between two surfaces, so that the
// farther one may be drawn in front. Each rung of a ladder is in front of a quad or behind it, at a
// distance from far less than a step to far more.
TEST_P(CullerDepthFormats, LadderOfDistances)
{
  constexpr double Range = 200.0; // of the pixel camera
  constexpr double Top = 60.0;
  std::vector<double> gaps; // in window depth
  for (int power = -27; power <= -6; ++power)
  {
    gaps.push_back(std::ldexp(1.0, power));
    gaps.push_back(-std::ldexp(1.0, power));
  }
  gaps.push_back(0.0);
  for (int backend : { vtkNBufferCuller::CPU, vtkNBufferCuller::OpenGL })
  {
    SCOPED_TRACE(backend == vtkNBufferCuller::CPU ? "CPU" : "OpenGL");
    Comparison comparison(
      [this, &gaps](Stage& stage)
      {
        this->SetFormat(stage);
        for (std::size_t i = 0; i < gaps.size(); ++i)
        {
          const double x = 30.0 * static_cast<double>(i % 10) + 2.0;
          const double y = 32.0 * static_cast<double>(i / 10) + 2.0;
          const double z = Top - gaps[i] * Range;
          AddQuad(stage, x, y, x + 25.0, y + 28.0, Top);
          // Of squares the levels look at little more than their rectangle.
          AddQuad(stage, x + 2.0, y + 10.0, x + 11.0, y + 19.0, z);          // flat
          Scenes::AddBox(stage, x + 18.5, y + 14.5, z - 1.0, 9.0, 9.0, 2.0); // 1/100 deep
        }
        Scenes::SetPixelCamera(stage.GetRenderer(), Width, Height);
      },
      this->GetOptions(backend));
    Scenes::Settle(comparison);
    this->CheckFormat(comparison);
    const bool coarse = this->GetParam().Bits == 16;
    for (std::size_t i = 0; i < gaps.size(); ++i)
    {
      SCOPED_TRACE(gaps[i]);
      const Verdict flat = comparison.GetVerdict(static_cast<int>(3 * i + 1));
      const Verdict deep = comparison.GetVerdict(static_cast<int>(3 * i + 2));
      if (gaps[i] <= 0.0)
      {
        EXPECT_EQ(flat, Verdict::Visible);
        EXPECT_EQ(deep, Verdict::Visible);
      }
      // The slack is two steps of the format and what rounding to float costs, for a flat prop less
      // than 2^-20 with 24 bits and more, and a twentieth of the depth range for others.
      if (gaps[i] >= std::ldexp(1.0, coarse ? -14 : -19))
      {
        EXPECT_EQ(flat, Verdict::Hidden);
      }
      if (gaps[i] >= std::ldexp(1.0, -10))
      {
        EXPECT_EQ(deep, Verdict::Hidden);
      }
    }
  }
}

// Hazard: depth of one format is read as if it had another one. The scene is a walk in perspective
// along a wall with decals.
TEST_P(CullerDepthFormats, WallAndDecals)
{
  for (int backend : { vtkNBufferCuller::CPU, vtkNBufferCuller::OpenGL })
  {
    SCOPED_TRACE(backend == vtkNBufferCuller::CPU ? "CPU" : "OpenGL");
    Comparison comparison(
      [this](Stage& stage)
      {
        this->SetFormat(stage);
        Scenes::BuildWall(stage);
        for (int i = 0; i < 12; ++i)
        {
          // On the wall's face, on its back, and on neither.
          AddQuad(stage, i - 6.0, -1.0, i - 5.2, 1.0, 0.25);
          AddQuad(stage, i - 5.8, 1.2, i - 5.2, 2.0, -0.25);
          AddQuad(stage, i - 5.8, -2.0, i - 5.2, -1.2, 0.2501);
        }
      },
      this->GetOptions(backend));
    for (int i = 0; i < 6; ++i)
    {
      Scenes::FrameOfWall(comparison, 0.4 * i);
      EXPECT_TRUE(i < 2 || comparison.GetHidden() >= Wall::Hidden) << comparison.GetHidden();
    }
    this->CheckFormat(comparison);
    for (int i = 0; i < 12; ++i)
    {
      EXPECT_NE(comparison.GetVerdict(Wall::Count + 3 * i), Verdict::Hidden);
      EXPECT_NE(comparison.GetVerdict(Wall::Count + 3 * i + 2), Verdict::Hidden);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, CullerDepthFormats,
  testing::Values(Format{ "Default", -1, false, 0, 0 }, Format{ "Stencil24", -1, true, 0, 24 },
    Format{ "Fixed16", vtkTextureObject::Fixed16, false, 0, 16 },
    Format{ "Fixed24", vtkTextureObject::Fixed24, false, 0, 24 },
    Format{ "Fixed32", vtkTextureObject::Fixed32, false, 0, 24 },
    Format{ "Float32", vtkTextureObject::Float32, false, 0, 32, true },
    Format{ "Stencil24Samples4", -1, true, 4, 24 },
    Format{ "Fixed16Samples4", vtkTextureObject::Fixed16, false, 4, 16 },
    Format{ "Float32Samples4", vtkTextureObject::Float32, false, 4, 32, true }),
  GetCaseName);
