// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Depth: its formats and steps, near and far planes, surfaces that touch, offsets.
#include "CullerTest.h"
#include "Scenes.h"
#include "Tune.h"

#include "vtkNBufferDepthSource.h"

#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <functional>
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
    options.Configure = [backend, exact = options.Configure](vtkNBufferCuller* culler)
    {
      exact(culler);
      culler->SetBackend(backend);
      // By the levels alone, which the device then makes of each format.
      Tune(culler, &vtkNBufferTuning::TestPixels, backend == vtkNBufferCuller::CPU);
    };
    options.MultiSamples = this->GetParam().Samples;
    // VTK cannot read multisampled depth whose format is not that of its other framebuffers.
    options.CompareDepth = this->GetParam().Samples == 0;
    options.ReadRendered = this->GetParam().Texture >= 0;
    return options;
  }

  /// VTK's render windows have depth of 32 bits, or of 24 with stencil, and no switch for others:
  /// another texture takes the place of the one in the render framebuffer.
  void SetFormat(Stage& stage) const
  {
    const Format& format = this->GetParam();
    stage.Window->SetStencilCapable(format.Stencil);
    stage.Window->Render(); // makes the framebuffers
    if (format.Texture < 0)
    {
      return;
    }
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
    vtkNew<vtkTextureObject> depth;
    depth->SetContext(window);
    depth->SetSamples(window->GetMultiSamples());
    depth->SetMinificationFilter(vtkTextureObject::Nearest);
    depth->SetMagnificationFilter(vtkTextureObject::Nearest);
    ASSERT_TRUE(depth->AllocateDepth(Width, Height, format.Texture));
    window->GetState()->PushFramebufferBindings();
    window->GetRenderFramebuffer()->Bind();
    window->GetRenderFramebuffer()->AddDepthAttachment(depth);
    window->GetState()->PopFramebufferBindings();
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
// one behind may be drawn in front; rungs of a ladder lie in front of and behind quads of their
// own, from far less than a step to far more.
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
          AddQuad(stage, x + 2.0, y + 2.0, x + 11.0, y + 25.0, z);            // flat
          Scenes::AddBox(stage, x + 18.5, y + 13.5, z - 1.0, 9.0, 23.0, 2.0); // 1/100 deep
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

// Hazard: depth of one format is taken for another's; a walk in perspective with decals.
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

//------------------------------------------------------------------------------------------------
// Hazard: the nearest depth of a box that is flush with its own surface is the depth that the prop
// itself has drawn; by rounding it would hide itself, and flicker from then on.
TEST(CullerHazards, BoxesFlushWithTheirOwnSurface)
{
  for (int view = 0; view < 4; ++view)
  {
    SCOPED_TRACE(view);
    const int count = 12 * 8;
    Comparison comparison(
      [](Stage& stage)
      {
        for (int i = 0; i < 12; ++i)
        {
          for (int j = 0; j < 8; ++j)
          {
            // With gaps, so that at an angle none hides its neighbour.
            const double x = 1.4 * i - 8.0;
            const double y = 1.4 * j - 5.0;
            if ((i + j) % 2)
            {
              Scenes::AddBox(stage, x, y, -0.05, 1.0, 1.0, 0.1);
            }
            else
            {
              AddQuad(stage, x - 0.5, y - 0.5, x + 0.5, y + 0.5, 0.0, 1 + (i + j) % 4);
            }
          }
        }
        // And boxes flush with the backs of the others' faces: hidden wholly.
        for (int i = 0; i < 12; ++i)
        {
          for (int j = 0; j < 8; ++j)
          {
            Scenes::AddBox(stage, 1.4 * i - 8.0, 1.4 * j - 5.0, -0.35, 0.5, 0.5, 0.5);
          }
        }
      },
      Scenes::MakeExactOptions(401, 301));
    for (int i = 0; i < 6; ++i)
    {
      comparison.Both(
        [view, i](Stage& stage)
        {
          vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
          camera->SetPosition(view == 3 ? 12.0 : 0.0, 0.01 * i, view == 3 ? 22.0 : 25.0);
          camera->SetFocalPoint(0.0, 0.01 * i, 0.0);
          camera->SetParallelProjection(view == 1);
          camera->SetParallelScale(7.0);
          stage.GetRenderer()->ResetCameraClippingRange();
          if (view == 2)
          {
            camera->SetClippingRange(1e-2, 1e5);
          }
        });
      comparison.Frame();
      if (i < 3)
      {
        continue;
      }
      for (int prop = 0; prop < count; ++prop)
      {
        EXPECT_EQ(comparison.GetVerdict(prop), Verdict::Visible) << prop;
        // Behind a face that looks at the camera, but for the range of the third view, in which
        // 0.1 is less than a step of depth, and the oblique view.
        if (view < 2)
        {
          EXPECT_EQ(comparison.GetVerdict(count + prop), Verdict::Hidden) << prop;
        }
      }
      // No prop was judged hidden by its own depth and then drawn late.
      const vtkNBufferStatistics& statistics = comparison.GetStatistics();
      EXPECT_LE(statistics.HeldBack, std::max(comparison.GetHidden(), 1));
    }
  }
}

//------------------------------------------------------------------------------------------------
namespace
{
class CullerOffsets : public testing::TestWithParam<int>
{
protected:
  void TearDown() override
  {
    vtkMapper::SetResolveCoincidentTopologyToDefault();
    vtkMapper::SetResolveCoincidentTopologyZShift(0.01);
  }
};
}

// Hazard: offsets against coincident surfaces pull what is drawn in front of what its bounds lie
// behind; visible edges are pulled without any setting.
TEST_P(CullerOffsets, BehindTheWall)
{
  constexpr int Kinds = 4;
  constexpr int Each = 16;
  vtkMapper::SetResolveCoincidentTopology(this->GetParam());
  vtkMapper::SetResolveCoincidentTopologyZShift(0.05);
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (int i = 0; i < Each; ++i)
      {
        const double x = 0.6 * i - 4.6;
        // Just behind the wall's back, all of them pulled forward as far as it may be.
        for (int kind = 0; kind < Kinds; ++kind)
        {
          const int prop =
            Scenes::AddBox(stage, x, 1.5 - kind, -0.5, 0.4, 0.4, kind % 2 ? 0.4 : 0.1);
          vtkActor* actor = stage.GetActor(prop);
          vtkMapper* mapper = actor->GetMapper();
          switch (kind)
          {
            case 1:
              actor->GetProperty()->EdgeVisibilityOn();
              actor->GetProperty()->SetLineWidth(3.0);
              break;
            case 2:
              mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-40.0, -4000.0);
              break;
            case 3:
              mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 4000.0);
              break;
            default:
              break;
          }
        }
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    Scenes::MakeExactOptions(301, 173, 4));
  for (int i = 0; i < 5; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.1 * i);
  }
  const bool off = this->GetParam() == VTK_RESOLVE_OFF;
  const bool shifted = this->GetParam() == VTK_RESOLVE_SHIFT_ZBUFFER;
  for (int i = 0; i < Each; ++i)
  {
    const int first = Wall::Count + Kinds * i;
    EXPECT_EQ(comparison.GetVerdict(first), shifted ? Verdict::DepthOffset : Verdict::Hidden);
    EXPECT_EQ(comparison.GetVerdict(first + 1), Verdict::NotASurface);
    EXPECT_EQ(comparison.GetVerdict(first + 2), off ? Verdict::Hidden : Verdict::DepthOffset);
    EXPECT_EQ(comparison.GetVerdict(first + 3), shifted ? Verdict::DepthOffset : Verdict::Hidden);
  }
  EXPECT_TRUE(shifted || comparison.GetHidden() >= Wall::Hidden);
}

INSTANTIATE_TEST_SUITE_P(Mode, CullerOffsets,
  testing::Values(VTK_RESOLVE_OFF, VTK_RESOLVE_POLYGON_OFFSET, VTK_RESOLVE_SHIFT_ZBUFFER),
  [](const testing::TestParamInfo<int>& info)
  {
    return std::string(info.param == VTK_RESOLVE_OFF ? "Off"
        : info.param == VTK_RESOLVE_POLYGON_OFFSET   ? "PolygonOffset"
                                                     : "ShiftZBuffer");
  });
