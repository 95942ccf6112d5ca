// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkNBufferQuery.glsl answers, in vertex and in fragment programs, is what vtkNBufferLevels
// answers for the same levels, bit for bit.
#include "DepthTarget.h"
#include "GpuTestNBufferQueryAnswer.h"
#include "GpuTestNBufferQueryFS.h"
#include "GpuTestNBufferQueryVS.h"
#include "WindowFixture.h"
#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferQuery.h"
#include "vtkNBufferTexture.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>

namespace
{
constexpr int Count = 1500; // queries of one image

struct Query
{
  vtkNBufferRectangle Pixels;
  float Depth = 0.0f;
  int Level = 0; ///< Of the square at the corner of Pixels, which is then a texel of level 0.
};

using Answer = std::array<float, 4>;

/// The whole image and beyond, single pixels, single rows, and rectangles at random places, of
/// which some lie partly or wholly outside or are empty.
std::vector<Query> MakeQueries(const vtkNBufferLevels& levels, int known)
{
  const int size[2] = { levels.GetPixelWidth(), levels.GetPixelHeight() };
  std::mt19937 random(static_cast<unsigned int>(size[0] + known));
  std::vector<Query> queries(Count);
  for (int i = 0; i < Count; ++i)
  {
    int range[2][2];
    for (int axis = 0; axis < 2; ++axis)
    {
      const int n = size[axis];
      const auto place = [&](int reach)
      { return static_cast<int>(random() % static_cast<unsigned int>(n + 2 * reach + 1)) - reach; };
      int& begin = range[axis][0];
      int& end = range[axis][1];
      begin = i == 0 ? 0 : i == 1 ? -7 : place(i % 3 == 0 ? 9 : 0);
      end = i == 0   ? n
        : i == 1     ? n + 9
        : i % 4 == 1 ? begin + 1
                     : (i % 4 == 2 ? begin + (1 << random() % 6) : std::max(place(9), begin - 2));
    }
    Query& query = queries[static_cast<std::size_t>(i)];
    query.Pixels = { range[0][0], range[1][0], range[0][1], range[1][1] };
    // Just on a depth of the image, or any.
    const float* texels =
      levels.GetLevelData(static_cast<int>(random() % levels.GetNumberOfLevels()));
    query.Depth = i % 2
      ? texels[random() % static_cast<unsigned int>(levels.GetWidth() * levels.GetHeight())]
      : static_cast<float>(random() % 4096u) / 4096.0f;
    query.Level = static_cast<int>(random() % (known + 1));
  }
  return queries;
}

/// What the host answers, of levels of which only `known` are there.
Answer GetAnswer(const vtkNBufferLevels& levels, int known, const Query& query)
{
  const bool isMaximum = levels.GetExtremum() == vtkNBufferExtremum::Maximum;
  const float nothing = isMaximum ? 0.0f : 1.0f;
  const float unknown = isMaximum ? 1.0f : 0.0f;
  Answer answer = { nothing, isMaximum ? 1.0f : 0.0f, 0.0f, 0.0f };
  const vtkNBufferRectangle pixels =
    query.Pixels.GetIntersection({ 0, 0, levels.GetPixelWidth(), levels.GetPixelHeight() });
  if (!pixels.IsEmpty())
  {
    const vtkNBufferRectangle texels = vtkNBufferMath::GetBaseRectangle(pixels, levels.GetFactor());
    const vtkNBufferCover cover =
      isMaximum ? vtkNBufferMath::GetCoverOfFour(texels) : vtkNBufferMath::GetCoverOfOne(texels);
    answer[0] = cover.Level < known ? levels.Query(cover) : unknown;
    if (cover.Level < known)
    {
      const vtkNBufferRectangle place = levels.FindPixels(cover);
      answer[3] = static_cast<float>(
        place.X0 + 512 * (place.Y0 + 512 * (place.GetWidth() % 8 + 8 * (place.GetHeight() % 8))));
    }
    answer[1] = (isMaximum ? query.Depth > answer[0] : query.Depth < answer[0]) ? 1.0f : 0.0f;
  }
  const int x = query.Pixels.X0;
  const int y = query.Pixels.Y0;
  const int side = 1 << query.Level;
  if (isMaximum && x < levels.GetWidth() && y < levels.GetHeight() && x + side > 0 && y + side > 0)
  {
    answer[2] =
      query.Level < known ? levels.GetTexel(query.Level, std::max(x, 0), std::max(y, 0)) : unknown;
  }
  return answer;
}

class GpuTestNBufferQuery : public OffscreenFixtureWithParam<bool, WindowFixture>
{
protected:
  vtkShaderProgram* UseProgram()
  {
    std::string vertexText = GpuTestNBufferQueryVS;
    std::string fragmentText = GpuTestNBufferQueryFS;
    for (std::string* text : { &vertexText, &fragmentText })
    {
      const std::string stage = this->GetParam() ? "1\n" : "0\n";
      vtkShaderProgram::Substitute(*text, "//VTK::NBuffer::Query",
        "#define NBUFFER_IN_VERTEX_STAGE " + stage + vtkNBufferQuery);
      vtkShaderProgram::Substitute(*text, "//VTK::NBuffer::Answer", GpuTestNBufferQueryAnswer);
    }
    std::string why;
    return vtkNBufferGL::UseProgram(
      this->Window, this->Program, vertexText.c_str(), fragmentText, "does not compile", why);
  }

  /// The answers of the device; `texture` holds the levels.
  std::vector<Answer> Draw(
    vtkNBufferTexture* texture, const vtkNBufferLevels& levels, const std::vector<Query>& queries)
  {
    std::vector<Answer> answers(2 * Count);
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      const vtkNBufferRectangle& r = queries[i].Pixels;
      answers[i] = { static_cast<float>(r.X0), static_cast<float>(r.Y0), static_cast<float>(r.X1),
        static_cast<float>(r.Y1) };
      answers[Count + i] = { queries[i].Depth, static_cast<float>(queries[i].Level), 0.0f, 0.0f };
    }
    const vtkNBufferGL::ScopedPass pass(this->Window);
    vtkNBufferGL::Texture input;
    vtkNBufferGL::Texture output;
    vtkNBufferGL::Framebuffer framebuffer;
    {
      const vtkNBufferGL::ScopedUpload upload(0);
      for (vtkNBufferGL::Texture* each : { &output, &input })
      {
        glBindTexture(GL_TEXTURE_2D, each->Create());
        vtkNBufferGL::SetPlainSampling(GL_TEXTURE_2D);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, Count, 2, 0, GL_RGBA, GL_FLOAT, answers.data());
      }
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Create());
    glFramebufferTexture2D(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, output.GetName(), 0);
    glViewport(0, 0, Count, 1);
    vtkShaderProgram* program = this->UseProgram();
    EXPECT_NE(program, nullptr);
    if (program)
    {
      const int size[2] = { levels.GetPixelWidth(), levels.GetPixelHeight() };
      program->SetUniformi("queries", 0);
      program->SetUniformi("even", 1);
      program->SetUniformi("odd", 2);
      program->SetUniform2i("shape.size", size);
      program->SetUniformi("shape.factor", levels.GetFactor());
      program->SetUniformi("shape.levels", texture->GetNumberOfLevels());
      program->SetUniformi("shape.minima", texture->GetBothExtrema());
      program->SetUniformi("count", Count);
      program->SetUniformi("isMaximum", levels.GetExtremum() == vtkNBufferExtremum::Maximum);
      for (int i : { 0, 1 })
      {
        glActiveTexture(GL_TEXTURE1 + i);
        // There is no odd level where there is only one level.
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture->GetHandle(i % texture->GetNumberOfLevels()));
      }
      glActiveTexture(GL_TEXTURE0);
      vtkNBufferGL::VertexArray none;
      glBindVertexArray(none.Create());
      glDrawArrays(GL_POINTS, 0, Count);
      for (int i : { 0, 1 })
      {
        glActiveTexture(GL_TEXTURE1 + i);
        glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
      }
      glActiveTexture(GL_TEXTURE0);
    }
    const vtkNBufferGL::ScopedReadback readback(framebuffer.GetName());
    glReadPixels(0, 0, Count, 1, GL_RGBA, GL_FLOAT, answers.data());
    return answers;
  }

  /// Compares the answers of at most `count` levels of an image of random depths. With `both`, they
  /// are in a texture of maxima that has both extrema.
  void Compare(
    int width, int height, int factor, vtkNBufferExtremum extremum, int count, bool both = false)
  {
    SCOPED_TRACE(testing::Message()
      << width << " x " << height << ", factor " << factor << (both ? ", both extrema" : ""));
    const DepthTarget target(GetTargetFormats()[3], width, height, true);
    target.Fill(static_cast<unsigned int>(width));
    target.Bind(0, 0, width, height);
    vtkNew<vtkNBufferTexture> texture;
    vtkNBufferLevels levels;
    ASSERT_TRUE(texture->Build(this->Window, factor, 99, extremum)) << texture->GetError();
    ASSERT_TRUE(texture->Download(this->Window, levels)) << texture->GetError();
    texture->SetBothExtrema(both);
    ASSERT_TRUE(
      texture->Build(this->Window, factor, count, both ? vtkNBufferExtremum::Maximum : extremum))
      << texture->GetError();
    const int known = texture->GetNumberOfLevels();
    const std::vector<Query> queries = MakeQueries(levels, known);
    const std::vector<Answer> answers = this->Draw(texture, levels, queries);
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      const vtkNBufferRectangle& r = queries[i].Pixels;
      ASSERT_EQ(answers[i], GetAnswer(levels, known, queries[i]))
        << "query " << i << ", pixels " << r.X0 << " " << r.Y0 << " " << r.X1 << " " << r.Y1
        << ", depth " << queries[i].Depth << ", level " << queries[i].Level << " of " << known;
      ++(answers[i][1] == 1.0f ? this->Yes : this->No)[extremum == vtkNBufferExtremum::Maximum];
    }
    texture->ReleaseGraphicsResources(this->Window);
  }

  void CheckThatAnswersDiffer() const
  {
    for (const int i : { 0, 1 })
    {
      EXPECT_GT(this->Yes[i], Count / 4);
      EXPECT_GT(this->No[i], Count / 4);
    }
  }

  vtkSmartPointer<vtkShaderProgram> Program;
  int Yes[2] = { 0, 0 }; ///< How often the answer was true, of minima and of maxima.
  int No[2] = { 0, 0 };
};
}

TEST_P(GpuTestNBufferQuery, EqualsHost)
{
  for (const auto& [width, height] :
    { std::pair(1, 1), std::pair(1, 9), std::pair(37, 22), std::pair(64, 64), std::pair(301, 83) })
  {
    for (const int factor : { 1, 2, 4, 8 })
    {
      this->Compare(width, height, factor, vtkNBufferExtremum::Maximum, 99);
      this->Compare(width, height, factor, vtkNBufferExtremum::Minimum, 99);
      this->Compare(width, height, factor, vtkNBufferExtremum::Maximum, 99, true);
      this->Compare(width, height, factor, vtkNBufferExtremum::Minimum, 99, true);
    }
  }
  this->CheckThatAnswersDiffer();
}

// Hazard: a query of a level that is not built reads what an earlier build left there.
TEST_P(GpuTestNBufferQuery, LevelsThatAreNotBuiltAreUnknown)
{
  for (const int count : { 1, 2, 4 })
  {
    this->Compare(90, 70, 1, vtkNBufferExtremum::Maximum, count);
    this->Compare(90, 70, 2, vtkNBufferExtremum::Minimum, count);
  }
}

INSTANTIATE_TEST_SUITE_P(Stages, GpuTestNBufferQuery, ::testing::Bool(),
  [](const auto& info) { return std::string(info.param ? "Vertex" : "Fragment"); });
