// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rasterised depth against depth in double precision, for random triangles: the slack that
// vtkNBufferProjection grants is larger than every error, and not many times larger.
//
// VTKNBUFFER_TEST_VERBOSE=1 prints the table of docs/precision.md.
#include "GpuTestNBufferPrecisionTriangles.h"

#include "DepthTarget.h"
#include "GpuTestNBufferPrecisionFS.h"
#include "GpuTestNBufferPrecisionVS.h"
#include "WindowFixture.h"
#include "vtkNBufferCandidate.h"
#include "vtkNBufferFaceTest.h"
#include "vtkNBufferFaces.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferSliverTest.h"
#include "vtkNBufferSurface.h"
#include "vtkNBufferTexture.h"
#include VTKNBUFFER_GL_HEADER

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <tuple>
#include <vector>

namespace
{
constexpr double LargestMultiple = 16.0; // slack over largest error, of one format and kind

const CameraCase Cameras[] = {
  { "far/near 1e1", 0.1, 1.0, false, 0.0, false },
  { "far/near 1e3", 0.1, 100.0, false, 0.0, false },
  { "far/near 1e5", 0.01, 1e3, false, 0.0, false },
  { "far/near 1e7", 0.01, 1e5, false, 0.0, false },
  { "parallel", 1.0, 1e3, true, 0.0, false },
  { "at 5e6", 100.0, 1e5, false, 5e6, false },
  { "at 5e6, shifted", 0.1, 100.0, false, 5e6, true },
  { "parallel at 5e6", 1.0, 1e4, true, 5e6, false },
};

const Kind Kinds[] = { Kind::Facing, Kind::Slanted, Kind::SubPixel, Kind::Steep, Kind::Behind };
const char* const KindNames[] = { "facing", "slanted", "sub-pixel", "steep", "sliver", "behind" };

/// Small triangles seldom cover a sample.
int GetCount(Kind kind)
{
  return kind == Kind::Steep || kind == Kind::SubPixel ? 300 : 50;
}

void Print(const std::string& name, Kind kind, const Finding& finding)
{
  if (std::getenv("VTKNBUFFER_TEST_VERBOSE"))
  {
    std::printf("| %s | %s | %lld | %lld | %.2e | %.2e | %.3f | %.3f |\n", name.c_str(),
      KindNames[static_cast<int>(kind)], finding.Fragments, finding.Nearer, finding.Outside,
      finding.Slack, finding.Largest, finding.OfPlane);
  }
}

/// Vertices and matrix in floats, as VTK uploads them; one triangle is drawn at a time.
class TriangleProgram
{
public:
  explicit TriangleProgram(vtkNBufferStoredDepth stored = vtkNBufferStoredDepth::Ordinary)
    : IsReversed(stored == vtkNBufferStoredDepth::Reversed)
  {
    glUseProgram(this->Name);
    glGenVertexArrays(1, &this->Array);
    glBindVertexArray(this->Array);
    glGenBuffers(1, &this->Buffer);
    glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
    const auto vertex = static_cast<GLuint>(glGetAttribLocation(this->Name, "vertexMC"));
    glEnableVertexAttribArray(vertex);
    glVertexAttribPointer(vertex, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(this->IsReversed ? GL_GEQUAL : GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glClearDepth(this->IsReversed ? 0.0 : 1.0);
    if (this->IsReversed)
    {
      glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    for (GLenum capability : { GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST })
    {
      glDisable(capability);
    }
  }
  ~TriangleProgram()
  {
    if (this->IsReversed)
    {
      glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
    glDepthFunc(GL_LEQUAL);
    glClearDepth(1.0);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDeleteProgram(this->Name);
    glDeleteVertexArrays(1, &this->Array);
    glDeleteBuffers(1, &this->Buffer);
  }
  TriangleProgram(const TriangleProgram&) = delete;
  void operator=(const TriangleProgram&) = delete;

  void SetMatrix(const Sampler& sampler)
  {
    glm::dmat4 shift(1.0);
    shift[3] = glm::dvec4(sampler.GetShift(), 1.0);
    this->Matrix = sampler.GetWorldToClip() * shift;
    glUniformMatrix4fv(
      glGetUniformLocation(this->Name, "MCDCMatrix"), 1, GL_FALSE, glm::value_ptr(this->Matrix));
  }

  /// False if the triangle, as the device may place its vertices, is too low to be covered.
  bool Draw(const Triangle& triangle, const Sampler& sampler, const vtkNBufferScreenBox& screen,
    bool isBehind)
  {
    glm::vec3 vertices[3];
    Triangle drawn;
    for (std::size_t i = 0; i < 3; ++i)
    {
      vertices[i] = triangle[i] - sampler.GetShift();
      drawn[i] = ToScreen(glm::dmat4(this->Matrix), vertices[i]);
    }
    // The slack on the screen is the border for snapping and what vertices may err.
    const double error =
      std::max(0.5 * Width * screen.Slack[0], 0.5 * Height * screen.Slack[1]) - screen.Border;
    if (!isBehind && !(GetHeight(drawn) >= LowestHeight + 2.0 * error))
    {
      return false;
    }
    glBufferData(GL_ARRAY_BUFFER, sizeof(vertices), vertices, GL_STREAM_DRAW);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return true;
  }

private:
  bool IsReversed;
  GLuint Name = LinkProgram(GpuTestNBufferPrecisionVS, GpuTestNBufferPrecisionFS);
  GLuint Array = 0;
  GLuint Buffer = 0;
  glm::mat4 Matrix;
};
}

class GpuTestNBufferPrecision : public WindowFixture
{
protected:
  /// `count` triangles of one kind.
  void Check(const vtkNBufferDepthSource& source, TriangleProgram& program, Sampler& sampler,
    const vtkNBufferProjection& projection, Kind kind, int count, Finding& finding)
  {
    const bool isBehind = kind == Kind::Behind;
    for (int n = 0; n < count; ++n)
    {
      const Triangle triangle = sampler.Make(kind);
      vtkNBufferScreenBox screen;
      if (projection.Project(BoundTriangle(triangle, sampler), screen) !=
          vtkNBufferPlacement::Inside ||
        !program.Draw(triangle, sampler, screen, isBehind))
      {
        continue;
      }
      // Two pixels more on all sides, where nothing may be drawn.
      const vtkNBufferRectangle& r = screen.Pixels;
      const vtkNBufferRectangle around = vtkNBufferRectangle{ 0, 0, Width, Height }.GetIntersection(
        { r.X0 - 2, r.Y0 - 2, r.X1 + 2, r.Y1 + 2 });
      SCOPED_TRACE("triangle " + std::to_string(n));
      std::vector<float> depth =
        this->Read(source, around, vtkNBufferDepthConvention::GetFarthest(source.Stored));
      vtkNBufferDepthConvention::ToOrders(source.Stored, depth.data(), depth.size());
      ASSERT_NO_FATAL_FAILURE(
        Judge(sampler, triangle, isBehind).Compare(screen, around, depth, finding));
    }
  }

  /// One triangle as an actor.
  void CheckActor(vtkRenderer* renderer, Sampler& sampler, const vtkNBufferProjection& projection,
    Kind kind, Finding& finding)
  {
    Triangle triangle;
    do
    {
      triangle = sampler.Make(kind);
    } while (GetHeight(ToScreen(sampler.GetWorldToClip(), triangle)) < 2.0 * LowestHeight);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0, 1, 2 });
    for (const glm::dvec3& point : triangle)
    {
      points->InsertNextPoint(glm::value_ptr(point));
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    vtkNBufferCandidate candidate(actor);
    candidate.Refresh(true);
    ASSERT_TRUE(candidate.IsCandidate());
    vtkNBufferScreenBox screen;
    if (projection.Project(candidate.GetBox(), screen) != vtkNBufferPlacement::Inside)
    {
      return;
    }
    renderer->AddActor(actor);
    std::vector<float> depth;
    WhileDrawing(this->Window, renderer,
      [&]() {
        depth = this->Read(this->Inspect(), { 0, 0, Width, Height });
      });
    renderer->RemoveActor(actor);
    Judge(sampler, triangle, false).Compare(screen, { 0, 0, Width, Height }, depth, finding);
  }
};

using GpuTestNBufferPrecisionFormats =
  OffscreenFixtureWithParam<std::tuple<std::size_t, vtkNBufferStoredDepth>,
    GpuTestNBufferPrecision>;

// Hazard: a fragment is drawn nearer than the nearest depth that the projection gives for its box.
TEST_P(GpuTestNBufferPrecisionFormats, ErrorsStayUnderTheSlack)
{
  const auto [index, stored] = GetParam();
  const TargetFormat& format = GetTargetFormats()[index];
  const DepthTarget target(format, Width, Height, true);
  if (!target.IsComplete())
  {
    GTEST_SKIP() << "The driver refuses " << format.Name << ".";
  }
  if (stored == vtkNBufferStoredDepth::Reversed &&
    !vtkNBufferGL::HasFeature(4, 5, "GL_ARB_clip_control"))
  {
    GTEST_SKIP() << "This renderer has no glClipControl().";
  }
  if (index == 0 && !vtkNBufferGL::KeepsColorsWhenRead())
  {
    GTEST_SKIP()
      << "softpipe's depths of 16 bits are off by up to 1.09 times the slack; the culler "
         "does not cull with it.";
  }
  target.Bind(0, 0, Width, Height);
  TriangleProgram program(stored);
  const vtkNBufferDepthSource source = this->Inspect();
  EXPECT_EQ(source.Stored, stored);
  const double quantum = source.GetStep();

  const std::string name =
    std::string(format.Name) + (stored == vtkNBufferStoredDepth::Reversed ? ", reversed" : "");
  Finding all[std::size(KindNames)];
  for (const CameraCase& camera : Cameras)
  {
    Sampler sampler(camera, 40, stored);
    program.SetMatrix(sampler);
    const vtkNBufferProjection projection = sampler.GetProjection(quantum);
    for (const Kind kind : Kinds)
    {
      if (kind == Kind::Behind && camera.Parallel)
      {
        continue;
      }
      SCOPED_TRACE(std::string(camera.Name) + ", " + KindNames[static_cast<int>(kind)]);
      Finding finding;
      ASSERT_NO_FATAL_FAILURE(
        this->Check(source, program, sampler, projection, kind, GetCount(kind), finding));
      Print(name + " | " + camera.Name, kind, finding);
      Finding& sum = all[static_cast<int>(kind)];
      sum.Fragments += finding.Fragments;
      sum.Nearer += finding.Nearer;
      sum.AddOutside(finding.Outside, finding.Slack);
      sum.OfPlane = std::max(sum.OfPlane, finding.OfPlane);
    }
  }
  for (const Kind kind : Kinds)
  {
    const Finding& sum = all[static_cast<int>(kind)];
    Print(name + " | all", kind, sum);
    EXPECT_GT(sum.Fragments, 0);
    // The slack covers all devices, so that one of them has to come near it. Others, such as an
    // NVIDIA H100 with steep triangles, are more exact.
    const char* software = vtkNBufferGL::GetSoftwareRenderer();
    if (!software || std::strcmp(software, "llvmpipe") != 0)
    {
      continue;
    }
    if (kind == Kind::Facing || kind == Kind::Slanted || kind == Kind::Steep)
    {
      EXPECT_GT(sum.Nearer, 0) << "without slack these would be culled although they are drawn";
      EXPECT_GE(sum.Largest, 1.0 / LargestMultiple) << KindNames[static_cast<int>(kind)];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, GpuTestNBufferPrecisionFormats,
  ::testing::Combine(::testing::Values(0, 1, 2, 3, 4, 5),
    ::testing::Values(vtkNBufferStoredDepth::Ordinary, vtkNBufferStoredDepth::Reversed)),
  [](const auto& info)
  {
    const bool isReversed = std::get<1>(info.param) == vtkNBufferStoredDepth::Reversed;
    return std::string(GetTargetFormats()[std::get<0>(info.param)].Name) +
      (isReversed ? "Reversed" : "");
  });

namespace
{
/// Whether the triangle is said to show where a fragment of this depth is all that can be seen.
bool IsForetold(const vtkNBufferProjection& projection, const Triangle& triangle,
  const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, const vtkNBufferSamples& samples,
  int x, int y, float z)
{
  std::vector<float> depth(static_cast<std::size_t>(Width) * Height, 0.0f);
  depth[static_cast<std::size_t>(y) * Width + x] = z;
  vtkNBufferLevels levels;
  levels.BuildBase(depth.data(), Width, Height, 1, vtkNBufferExtremum::Maximum);
  vtkNBufferMesh mesh;
  mesh.Points.assign(triangle.begin(), triangle.end());
  mesh.Triangles = { { 0, 1, 2 } };
  const vtkNBufferMeshes::Placed placed = { std::make_shared<vtkNBufferMesh>(mesh),
    { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
  vtkNBufferFaces::OfProp ofProp;
  vtkNBufferFaces faces;
  faces.Set(ofProp, { placed }, box);
  return vtkNBufferFaceTest(projection, samples)
           .MayBeInFront(faces, faces.GetPieces().front(), screen.Nearest - z) &&
    vtkNBufferSliverTest(projection, levels, depth.data(), samples)
      .MayBeSeen(mesh, 0, 1, placed.ToWorld.data(), box, screen);
}
}

/// The parameter is the number of samples of a pixel; 0 without multisampling.
class GpuTestNBufferPrecisionSamples
  : public OffscreenFixtureWithParam<int, GpuTestNBufferPrecision>
{
protected:
  /// The nearest depth of all samples of each pixel.
  std::vector<float> ReadNearest(
    const vtkNBufferDepthSource& source, const vtkNBufferRectangle& pixels)
  {
    if (source.Samples <= 1)
    {
      return this->Read(source, pixels);
    }
    std::vector<float> depth(static_cast<std::size_t>(pixels.GetWidth()) * pixels.GetHeight());
    EXPECT_TRUE(this->Texture->Build(this->Window, source, pixels.X0, pixels.Y0, pixels.GetWidth(),
                  pixels.GetHeight(), 1, 1, vtkNBufferExtremum::Minimum) &&
      this->Texture->Download(
        this->Window, { { 0, 0, pixels.GetWidth(), pixels.GetHeight() } }, depth.data()))
      << this->Texture->GetError();
    return depth;
  }

  vtkNew<vtkNBufferTexture> Texture;
};

// Hazard: a fragment of a sliver is drawn nearer than its box, and the sliver test does not expect
// it, or is not made.
TEST_P(GpuTestNBufferPrecisionSamples, SliversAreForetold)
{
  constexpr int count = 400;
  const DepthTarget target(GetTargetFormats()[1], Width, Height, true, GetParam());
  // OpenGL 3.2 requires multisampled depth textures; softpipe has none that can be read.
  if (GetParam() > 1 && !vtkNBufferGL::KeepsColorsWhenRead())
  {
    GTEST_SKIP() << "This renderer has no multisampled depth textures that can be read.";
  }
  ASSERT_TRUE(target.IsComplete());
  target.Bind(0, 0, Width, Height);
  const vtkNBufferDepthSource source = this->Inspect();
  TriangleProgram program;
  long long fragments = 0;
  long long strays = 0;
  double farthest = 0.0; // stray, in depth ranges of its box
  for (const CameraCase& camera : Cameras)
  {
    Sampler sampler(camera, 42);
    sampler.SetSamples(vtkNBufferGL::GetSamplePlaces());
    program.SetMatrix(sampler);
    const vtkNBufferProjection projection = sampler.GetProjection();
    for (int n = 0; n < count; ++n)
    {
      const Triangle triangle = sampler.Make(Kind::Sliver);
      const vtkNBufferBox box = BoundTriangle(triangle, sampler);
      vtkNBufferScreenBox screen;
      if (projection.Project(box, screen) != vtkNBufferPlacement::Inside)
      {
        continue;
      }
      program.Draw(triangle, sampler, screen, true);
      const std::vector<float> depth = this->ReadNearest(source, screen.Pixels);
      const float* next = depth.data();
      for (const auto& [x, y] : Pixels(screen.Pixels))
      {
        const float z = *next++;
        fragments += z < 1.0f;
        if (z < 1.0f && z < screen.Nearest)
        {
          ++strays;
          farthest = std::max(farthest, (screen.Nearest - z) / screen.DepthRange);
          ASSERT_TRUE(IsForetold(projection, triangle, box, screen, source.Places, x, y, z))
            << camera.Name << ", triangle " << n << ", pixel " << x << " " << y;
        }
      }
    }
  }
  if (std::getenv("VTKNBUFFER_TEST_VERBOSE"))
  {
    std::printf("slivers: %lld fragments, %lld nearer than their box by up to %.3g of its depth\n",
      fragments, strays, farthest);
  }
  EXPECT_GT(fragments, 0);
  EXPECT_EQ(strays > 0, vtkNBufferGL::DrawsStraySamples());
}

INSTANTIATE_TEST_SUITE_P(Each, GpuTestNBufferPrecisionSamples, ::testing::Values(0, 4),
  [](const auto& info) { return "Samples" + std::to_string(info.param); });

// The same errors, of triangles that mappers draw, with the boxes that the culler computes for
// their actors.
TEST_F(GpuTestNBufferPrecision, ActorsStayUnderTheSlack)
{
  this->Window = NewWindow(Width, Height);
  vtkNew<vtkRenderer> renderer;
  this->Window->AddRenderer(renderer);
  for (const CameraCase& camera : Cameras)
  {
    Sampler sampler(camera, 41);
    renderer->SetActiveCamera(sampler.GetCamera());
    const vtkNBufferProjection projection = sampler.GetProjection();
    for (const Kind kind : { Kind::Facing, Kind::Slanted, Kind::Steep })
    {
      SCOPED_TRACE(std::string(camera.Name) + ", " + KindNames[static_cast<int>(kind)]);
      Finding finding;
      for (int n = 0; n < 12; ++n)
      {
        ASSERT_NO_FATAL_FAILURE(this->CheckActor(renderer, sampler, projection, kind, finding));
      }
      Print(std::string("actors | ") + camera.Name, kind, finding);
      EXPECT_GT(finding.Fragments, kind == Kind::Steep ? 0 : 1000);
    }
  }
}
