// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Mip chains and one level of several images on the device equal the double loop, bit for bit.
#include "DepthChain.h"
#include "StudyImage.h"
#include "WindowFixture.h"

#include "vtkOpenGLRenderWindow.h"

#include <utility>

namespace
{
using NBufferPeers::ChainEdges;
using NBufferPeers::DepthChain;
using NBufferPeers::GroupForm;
using StudyTest::Image;
using StudyTest::Interval;

constexpr std::pair<int, int> Sizes[] = { { 1, 1 }, { 1, 37 }, { 41, 2 }, { 7, 3 }, { 16, 16 },
  { 17, 33 }, { 103, 111 }, { 64, 64 }, { 301, 173 }, { 511, 129 } };

constexpr int AllLevels = 64;

/// Returns the pixels along an axis that a texel of a chain covers.
Interval GetCovered(ChainEdges edges, int size, int level, int texel)
{
  if (level == 0)
  {
    return { texel, texel + 1 };
  }
  const int below = DepthChain::GetLevelSize(size, level - 1);
  const bool isLast = texel == DepthChain::GetLevelSize(size, level) - 1;
  const bool hasThird = below % 2 == 1 && (edges == ChainEdges::Exact || isLast);
  const int last = std::min(2 * texel + 1 + hasThird, below - 1);
  return { GetCovered(edges, size, level - 1, 2 * texel).Begin,
    GetCovered(edges, size, level - 1, last).End };
}

class StudyDepthChain : public WindowFixture
{
protected:
  void SetDepth(const std::vector<Image>& images)
  {
    std::vector<std::vector<float>> layers;
    for (const Image& image : images)
    {
      layers.push_back(image.Depth);
    }
    this->Chain.SetDepth(this->Window, layers, images.front().Width, images.front().Height);
  }

  void CompareChain(ChainEdges edges, const std::vector<Image>& images, int count)
  {
    this->Chain.BuildChain(edges, count);
    const int levels = std::min(count + 1, this->Chain.GetNumberOfLevels());
    for (int level = 0; level < levels; ++level)
    {
      for (std::size_t layer = 0; layer < images.size(); ++layer)
      {
        const std::vector<float> texels = this->Chain.DownloadChain(level, static_cast<int>(layer));
        const Image& image = images[layer];
        ExpectLevel(image, texels, DepthChain::GetLevelSize(image.Width, level),
          DepthChain::GetLevelSize(image.Height, level), "level " + std::to_string(level),
          [=](int size, int texel) { return GetCovered(edges, size, level, texel); });
      }
    }
  }

  void CompareGroups(const GroupForm& form, const std::vector<Image>& images)
  {
    this->Chain.BuildGroups(form);
    for (std::size_t layer = 0; layer < images.size(); ++layer)
    {
      const std::vector<float> texels = this->Chain.DownloadGroups(static_cast<int>(layer));
      const Image& image = images[layer];
      ExpectLevel(image, texels, (image.Width + 15) / 16, (image.Height + 15) / 16,
        "side " + std::to_string(form.Side) + (form.Gather ? ", gather" : "") +
          (form.Atomics ? ", atomics" : ""),
        [](int size, int texel) {
          return Interval{ 16 * texel, std::min(16 * texel + 16, size) };
        });
    }
  }

  static std::vector<Image> MakeEyes(int width, int height)
  {
    return { Image(width, height, 7), Image(width, height, 8) };
  }

  DepthChain Chain;
};

TEST_F(StudyDepthChain, AllLevelsAreTheDoubleLoop)
{
  for (const auto& [width, height] : Sizes)
  {
    const std::vector<Image> images = MakeEyes(width, height);
    this->SetDepth(images);
    for (ChainEdges edges : { ChainEdges::Exact, ChainEdges::Fat })
    {
      this->CompareChain(edges, images, AllLevels);
    }
  }
}

TEST_F(StudyDepthChain, ExactTexelsHaveAllAtTheirPlace)
{
  for (int size = 1; size < 300; ++size)
  {
    for (int level = 0; (size >> level) > 0; ++level)
    {
      const int texels = DepthChain::GetLevelSize(size, level);
      for (int texel = 0; texel < texels; ++texel)
      {
        const Interval covered = GetCovered(ChainEdges::Exact, size, level, texel);
        ASSERT_LE(covered.Begin, texel * size / texels);
        ASSERT_GE(covered.End, ((texel + 1) * size + texels - 1) / texels);
      }
    }
  }
}

TEST_F(StudyDepthChain, FewerLevelsCanBeBuilt)
{
  const std::vector<Image> images = MakeEyes(61, 45);
  this->SetDepth(images);
  this->CompareChain(ChainEdges::Exact, images, AllLevels);
  this->CompareChain(ChainEdges::Fat, images, 1);
  // What is above has not been built again.
  const std::vector<float> above = this->Chain.DownloadChain(2, 1);
  ExpectLevel(images[1], above, 15, 11, "level 2",
    [](int size, int texel) { return GetCovered(ChainEdges::Exact, size, 2, texel); });
}

TEST_F(StudyDepthChain, GroupsOfAllFormsAreTheDoubleLoop)
{
  if (!DepthChain::WhyNotGroups().empty())
  {
    GTEST_SKIP() << DepthChain::WhyNotGroups();
  }
  for (const auto& [width, height] : Sizes)
  {
    const std::vector<Image> images = MakeEyes(width, height);
    this->SetDepth(images);
    for (int side : { 2, 4, 8, 16 })
    {
      for (bool atomics : { false, true })
      {
        this->CompareGroups({ side, false, atomics }, images);
        if (side < 16)
        {
          this->CompareGroups({ side, true, atomics }, images);
        }
      }
    }
  }
}
}
