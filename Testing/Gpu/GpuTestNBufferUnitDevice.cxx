// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compute shaders find the same units hidden as the host, and both make the same lists.
#include "vtkNBufferHostList.h"
#include "vtkNBufferTexture.h"
#include "vtkNBufferUnitCulling.h"
#include "vtkNBufferUnitDevice.h"

#include "DepthTarget.h"
#include "GLStateSnapshot.h"
#include "WindowFixture.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <optional>
#include <random>
#include <tuple>

namespace
{
constexpr int Width = 150;
constexpr int Height = 110;

using Answer = vtkNBufferUnitAnswers::Answer;

class UnitDeviceFixture : public WindowFixture
{
protected:
  void SetUp() override
  {
    WindowFixture::SetUp();
    if (!this->IsSkipped() && this->NeedsDevice() &&
      !this->Device.Begin(this->Window, vtkNBufferBackend::OpenGL))
    {
      GTEST_SKIP() << this->Device.GetError();
    }
  }

  void TearDown() override
  {
    this->OnDevice.Delete();
    this->List.Object.Delete();
    WindowFixture::TearDown();
  }

  virtual bool NeedsDevice() const { return true; }

  /// Triangles in random places of a cube, or in a row.
  void MakeMesh(std::size_t triangles, bool areInRow)
  {
    std::minstd_rand random(3);
    std::uniform_real_distribution<> anywhere(-1.0, 1.0);
    std::vector<glm::dvec3> places;
    for (std::size_t i = 0; i < triangles; ++i)
    {
      const glm::dvec3 place(anywhere(random), anywhere(random), anywhere(random));
      places.push_back(areInRow ? glm::dvec3(0.1 * static_cast<double>(i), 0.0, 0.0) : place);
    }
    this->Mesh = {};
    for (const glm::dvec3& place : places)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->Mesh.Indices.push_back(static_cast<unsigned int>(this->Mesh.Points.size()));
        this->Mesh.Points.push_back(place + 0.01 * glm::dvec3(corner == 0, corner == 1, corner));
      }
    }
    this->Units = vtkNBufferUnits::Make(this->Mesh, 8);
    EXPECT_EQ(this->Units.AreSpatial(), !areInRow);
    this->OnDevice.Delete();
  }

  /// Returns every third mark or so.
  std::vector<unsigned char> MarkSome(unsigned int seed) const
  {
    std::minstd_rand random(seed);
    std::vector<unsigned char> marked(this->Units.GetSize());
    std::generate(marked.begin(), marked.end(), [&random] { return random() % 3 == 0; });
    return marked;
  }

  vtkNBufferUnitDevice Device;
  vtkNBufferUnitDevice::Buffers OnDevice;
  vtkNBufferUnitDevice::List List;
  vtkNBufferUnits::Mesh Mesh;
  vtkNBufferUnits Units;
};

template <typename T>
void WriteBuffer(unsigned int buffer, const std::vector<T>& values)
{
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(T)),
    values.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

/// Copies `size` values of a buffer.
template <typename T>
std::vector<T> ReadBuffer(unsigned int buffer, std::size_t size)
{
  std::vector<T> values(size);
  glBindBuffer(GL_COPY_READ_BUFFER, buffer);
  glGetBufferSubData(
    GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(size * sizeof(T)), values.data());
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  return values;
}

/// A depth buffer with some walls before the far plane.
class Walls
{
public:
  Walls()
    : Target(GetTargetFormats()[1], Width, Height, true)
  {
    EXPECT_TRUE(this->Target.IsComplete());
    this->Target.Bind(0, 0, Width, Height);
    glDepthMask(GL_TRUE);
    glEnable(GL_SCISSOR_TEST);
    const double walls[][5] = { { 0, 0, Width, Height, 1.0 }, { 20, 10, 60, 70, 0.93 },
      { 70, 40, 70, 60, 0.955 }, { 0, 80, 40, 20, 0.9 }, { 100, 0, 50, 45, 0.97 } };
    for (const auto& [x, y, width, height, depth] : walls)
    {
      glScissor(static_cast<int>(x), static_cast<int>(y), static_cast<int>(width),
        static_cast<int>(height));
      glClearDepth(depth);
      glClear(GL_DEPTH_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
    glClearDepth(1.0);
  }

private:
  DepthTarget Target;
};
}

/// The factor of level 0, the distance of the eye, and the margin of boxes.
using View = std::tuple<int, double, double>;

using GpuTestNBufferUnitAnswers = OffscreenFixtureWithParam<View, UnitDeviceFixture>;

// From outside, from inside of the mesh, and with a box of several projections.
TEST_P(GpuTestNBufferUnitAnswers, AreThoseOfTheHost)
{
  const auto [factor, distance, margin] = this->GetParam();
  this->MakeMesh(30000, false);
  const Walls walls;
  const vtkNBufferDepthSource source = this->Inspect();
  vtkNew<vtkNBufferTexture> texture;
  vtkNBufferLevels levels;
  ASSERT_TRUE(texture->Build(
    this->Window, source, 0, 0, Width, Height, factor, 5, vtkNBufferExtremum::Maximum));
  ASSERT_TRUE(texture->Download(this->Window, levels));
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.4 * distance, 0.2 * distance, distance);
  // The walls are farther away than 10 times the near plane.
  camera->SetClippingRange(distance > 1.0 ? 0.2 : 0.05, 20.0);
  const glm::dmat4 toClip = vtkNBufferGLM::ToMatrix(
    camera->GetCompositeProjectionTransformMatrix(1.0 * Width / Height, -1.0, 1.0)->GetData());
  vtkNBufferProjection projection;
  projection.Set(vtkNBufferGLM::ToRows(toClip).data(), Width, Height,
    vtkNBufferDepthFormat::FromQuantum(0x1p-24), glm::ivec2(0), 8);

  vtkNBufferUnitCulling onHost;
  vtkNBufferUnitCulling onDevice;
  for (vtkNBufferUnitCulling* culling : { &onHost, &onDevice })
  {
    culling->SetUnits(this->Units);
    culling->SetRounding({ glm::dvec3(0.0), glm::dvec3(1.1), margin });
  }
  vtkNBufferUnitAnswers answers;
  int hidden = 0;
  // An application's part of a buffer stays bound.
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, 1024, nullptr, GL_STATIC_DRAW);
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 1, buffer, 256, 512);
  for (const double sampleDistance : { 0.0, 0.5, 0.0 })
  {
    const vtkNBufferUnitCulling::Depth depth = { levels, nullptr, sampleDistance };
    const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
    this->Device.Test(this->Units, this->OnDevice, projection, onHost.MakeBox({}), texture, levels,
      sampleDistance, answers);
    EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
    EXPECT_TRUE(onHost.AreRight(answers, projection, depth));
    onHost.FindKept(projection);
    onDevice.FindKept(projection);
    EXPECT_EQ(onHost.Test(projection, depth), onDevice.Test(projection, depth, &answers));
    EXPECT_EQ(onHost.GetFresh(), onDevice.GetFresh());
    const vtkNBufferUnitCulling::Counts& counts = onHost.GetCounts();
    hidden = counts.Units - counts.Outside - counts.Kept - counts.Fresh;
  }
  glDeleteBuffers(1, &buffer);
  EXPECT_GT(hidden, 50);
  EXPECT_GT(onHost.GetCounts().Kept, 100);

  // The device leaves to the host what the near plane or the eye cuts, and nothing else.
  std::size_t left = 0;
  for (std::size_t i = 0; i < this->Units.GetSize(); ++i)
  {
    const bool isAnswered = answers.Get(1, i / vtkNBufferUnits::Fanout) == Answer::Visible;
    vtkNBufferScreenBox screen;
    const vtkNBufferPlacement placement =
      projection.Project(onHost.MakeBox(this->Units.GetLevels()[0][i]), screen);
    if (isAnswered && answers.Get(0, i) == Answer::None)
    {
      EXPECT_TRUE(placement == vtkNBufferPlacement::Crossing || screen.Clipped) << i;
      ++left;
    }
  }
  EXPECT_LT(left, this->Units.GetSize() / 10);
}

INSTANTIATE_TEST_SUITE_P(Views, GpuTestNBufferUnitAnswers,
  ::testing::Values(View(4, 3.0, 0.0), View(1, 3.0, 2.0), View(4, 0.7, 0.0), View(2, 0.6, 0.0)));

/// The device, or the host, makes lists.
class GpuTestNBufferUnitList : public OffscreenFixtureWithParam<bool, UnitDeviceFixture>
{
protected:
  using Records = vtkNBufferUnitDevice::Records;

  bool NeedsDevice() const override { return this->GetParam(); }

  /// Make a list of those of `size` primitives from number `first` on that are marked, each of
  /// which is drawn by so many indices, as an instance if `areInstances` is true. Returns how many
  /// primitives are drawn.
  std::size_t MakeList(const std::vector<unsigned char>& marked, std::size_t first,
    std::size_t size, const std::vector<Records>& records, std::size_t indices, bool areInstances)
  {
    const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
    std::optional<std::size_t> onHost;
    const vtkNBufferUnits::Range part = { first, first + size };
    if (!this->GetParam())
    {
      onHost = vtkNBufferHostList::Copy(this->Units.GetRanges(marked), part, records);
      EXPECT_TRUE(onHost.has_value());
    }
    else
    {
      this->Device.MakeList(
        this->Units, marked, this->OnDevice, part, records, indices, areInstances, this->List);
    }
    EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
    if (onHost)
    {
      return *onHost;
    }
    const auto command = ReadBuffer<unsigned int>(this->List.Object.GetName(), 5);
    const unsigned int count = areInstances ? command[1] : command[0] / 3;
    const auto perPrimitive = static_cast<unsigned int>(indices);
    EXPECT_EQ(command,
      areInstances ? (std::vector<unsigned int>{ perPrimitive, count, 0, 0, 0 })
                   : (std::vector<unsigned int>{ perPrimitive * count, 1, 0, 0, 0 }));
    return count;
  }
};
INSTANTIATE_TEST_SUITE_P(By, GpuTestNBufferUnitList, testing::Values(true, false),
  [](const auto& info) { return std::string(info.param ? "Device" : "Host"); });

// The sizes are those at which the numbers of work groups change.
TEST_P(GpuTestNBufferUnitList, HasTheTrianglesInTheirOrder)
{
  for (const std::size_t size : { 20u, 2047u, 2048u, 2049u, 3u * 2048u + 1u, 600001u })
  {
    for (const bool areInRow : { true, false })
    {
      SCOPED_TRACE(testing::Message() << size << (areInRow ? " in a row" : ""));
      this->MakeMesh(size, areInRow);
      const std::vector<std::uint32_t> units = this->Units.GetUnitsOfPrimitives();
      vtkNBufferGL::Buffer all;
      vtkNBufferGL::Buffer some;
      WriteBuffer(all.Create(), this->Mesh.Indices);
      for (const std::vector<unsigned char>& marked :
        { this->MarkSome(1), this->MarkSome(2), std::vector<unsigned char>(this->Units.GetSize()) })
      {
        std::vector<unsigned int> expected;
        for (std::size_t i = 0; i < 3 * size; ++i)
        {
          if (marked[units[i / 3]])
          {
            expected.push_back(this->Mesh.Indices[i]);
          }
        }
        const std::size_t count =
          this->MakeList(marked, 0, size, { { all.GetName(), some.Create(), 3 } }, 3, false);
        EXPECT_EQ(3 * count, expected.size());
        EXPECT_EQ(ReadBuffer<unsigned int>(some.GetName(), expected.size()), expected);
      }
    }
  }
}

// Instances of the second source of a glyph mapper: not from the first one on, with two buffers.
TEST_P(GpuTestNBufferUnitList, HasTheInstancesOfOneSource)
{
  constexpr std::size_t first = 5000;
  constexpr std::size_t size = 12345;
  this->MakeMesh(first + size, false);
  const std::vector<std::uint32_t> units = this->Units.GetUnitsOfPrimitives();
  std::vector<float> matrices;
  std::vector<std::uint32_t> colors;
  for (std::uint32_t i = 0; i < size; ++i)
  {
    matrices.insert(matrices.end(), 16, static_cast<float>(i) + 0.5F);
    colors.push_back(3 * i);
  }
  vtkNBufferGL::Buffer buffers[4];
  WriteBuffer(buffers[0].Create(), matrices);
  WriteBuffer(buffers[1].Create(), colors);
  for (const unsigned int seed : { 5u, 6u, 7u })
  {
    const std::vector<unsigned char> marked = this->MarkSome(seed);
    std::vector<float> expectedMatrices;
    std::vector<std::uint32_t> expectedColors;
    for (std::size_t i = 0; i < size; ++i)
    {
      if (marked[units[first + i]])
      {
        expectedMatrices.insert(expectedMatrices.end(), 16, matrices[16 * i]);
        expectedColors.push_back(colors[i]);
      }
    }
    const std::size_t count = this->MakeList(marked, first, size,
      { { buffers[0].GetName(), buffers[2].Create(), 16 },
        { buffers[1].GetName(), buffers[3].Create(), 1 } },
      36, true);
    EXPECT_EQ(count, expectedColors.size());
    EXPECT_EQ(ReadBuffer<float>(buffers[2].GetName(), expectedMatrices.size()), expectedMatrices);
    EXPECT_EQ(
      ReadBuffer<std::uint32_t>(buffers[3].GetName(), expectedColors.size()), expectedColors);
  }
}

// Points that VTK draws without an index buffer.
using GpuTestNBufferHostList = WindowFixture;
TEST_F(GpuTestNBufferHostList, HasNumbersIfThereAreNoIndices)
{
  vtkNBufferGL::Buffer list;
  EXPECT_EQ(
    vtkNBufferHostList::Copy({ { 2, 4 }, { 7, 8 } }, { 0, 9 }, { { 0, list.Create(), 1 } }), 3U);
  EXPECT_EQ(ReadBuffer<unsigned int>(list.GetName(), 3), (std::vector<unsigned int>{ 2, 3, 7 }));
}
