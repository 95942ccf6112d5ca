// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Contender.h"

#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"

#include <algorithm>
#include <limits>

namespace NBufferStudy
{
namespace
{
class StructureContender : public Contender
{
public:
  StructureContender(const std::string& name, const DepthStructure& levels)
    : Contender(name)
    , Levels(levels)
  {
  }

  void Build(const DepthFrame& frame) override
  {
    this->Levels.Build(frame.Depth.data(), frame.Width, frame.Height);
  }

  bool IsHidden(const DepthFrame&, const DepthBox& box, ContestCounts& counts) override
  {
    ++counts.Queries;
    return box.Screen.Nearest > this->Levels.Query(box.Screen.Pixels, counts.Lookups);
  }

  std::size_t GetNumberOfTexels() const override { return this->Levels.GetNumberOfTexels(); }
  std::size_t GetMemory() const override { return this->Levels.GetMemory(); }

  long long GetCoveredArea(const DepthBox& box) const override
  {
    const vtkNBufferRectangle covered = this->Levels.GetCovered(box.Screen.Pixels);
    return static_cast<long long>(covered.GetWidth()) * covered.GetHeight();
  }

private:
  DepthStructure Levels;
};

/// Has the module's levels.
class LevelsContender : public Contender
{
public:
  LevelsContender(const std::string& name, int factor)
    : Contender(name)
    , Factor(factor)
  {
  }

  std::size_t GetNumberOfTexels() const override
  {
    return static_cast<std::size_t>(this->Levels.GetWidth()) * this->Levels.GetHeight() *
      this->Levels.GetNumberOfLevels();
  }
  std::size_t GetMemory() const override { return this->GetNumberOfTexels() * sizeof(float); }

protected:
  void BuildLevels(const DepthFrame& frame, int levels)
  {
    this->Levels.BuildBase(
      frame.Depth.data(), frame.Width, frame.Height, this->Factor, vtkNBufferExtremum::Maximum);
    this->Levels.BuildLevels(levels);
  }

  const int Factor;
  vtkNBufferLevels Levels;
};

/// The module's levels without the pixels, and the place that keeps a box visible.
class PositionContender : public LevelsContender
{
public:
  explicit PositionContender(int factor)
    : LevelsContender("squares x4 1/" + std::to_string(factor) + " with positions", factor)
  {
  }

  void Build(const DepthFrame& frame) override
  {
    this->BuildLevels(frame, std::numeric_limits<int>::max());
  }

  bool IsHidden(const DepthFrame&, const DepthBox& box, ContestCounts& counts) override
  {
    const vtkNBufferCover cover = vtkNBufferMath::GetCoverOfFour(
      vtkNBufferMath::GetBaseRectangle(box.Screen.Pixels, this->Factor));
    ++counts.Queries;
    counts.Lookups += cover.Count;
    // A place is never empty. What it costs to find it is measured.
    return box.Screen.Nearest > this->Levels.Query(cover) ||
      this->Levels.FindPixels(cover).IsEmpty();
  }
};

std::string GetModuleName(int factor, bool testPixels)
{
  return "culler 1/" + std::to_string(factor) + (testPixels ? " + pixels" : "");
}

/// The order of vtkNBufferDepthTest: the levels that are needed, the levels' word on every box, and
/// the pixels' on what is in doubt.
class ModuleContender : public LevelsContender
{
public:
  ModuleContender(const std::string& name, int factor, bool testLevels, bool testPixels)
    : LevelsContender(name, factor)
    , TestLevels(testLevels)
    , TestPixels(testPixels)
  {
  }

  void Build(const DepthFrame& frame) override
  {
    // Squares of 8 pixels, from which the look at the pixels begins.
    int levels = vtkNBufferMath::CeilLog2(8 / std::min(this->Factor, 8)) + 1;
    for (const DepthBox& box : frame.Boxes)
    {
      if (this->TestLevels)
      {
        levels = std::max(
          levels, vtkNBufferOcclusionTest::GetLevelsNeeded(box.Screen.Pixels, this->Factor));
      }
    }
    this->BuildLevels(frame, levels);
    this->Occlusion = std::make_unique<vtkNBufferOcclusionTest>(this->Levels);
    this->Pixels = std::make_unique<vtkNBufferPixelTest>(
      frame.Projection, this->Levels, frame.Depth.data(), 0.0);
  }

  bool IsHidden(const DepthFrame&, const DepthBox& box, ContestCounts& counts) override
  {
    const long long queries = this->Occlusion->GetQueries();
    const long long lookups = this->Occlusion->GetLookups() + this->Pixels->GetLookups();
    const bool hidden = (this->TestLevels && this->Occlusion->IsHidden(box.Screen)) ||
      (this->TestPixels && this->Pixels->IsHidden(box.Box, box.Screen));
    counts.Queries += this->Occlusion->GetQueries() - queries;
    counts.Lookups += this->Occlusion->GetLookups() + this->Pixels->GetLookups() - lookups;
    return hidden;
  }

private:
  bool TestLevels;
  bool TestPixels;
  std::unique_ptr<vtkNBufferOcclusionTest> Occlusion;
  std::unique_ptr<vtkNBufferPixelTest> Pixels;
};
}

ContenderPointer MakeFamilyContender(const DepthFamily& family)
{
  return std::make_unique<StructureContender>(family.GetName(), DepthStructure(family));
}

ContenderPointer MakePositionContender(int factor)
{
  return std::make_unique<PositionContender>(factor);
}

ContenderPointer MakeModuleContender(int factor, bool testPixels)
{
  return std::make_unique<ModuleContender>(
    GetModuleName(factor, testPixels), factor, true, testPixels);
}

ContenderPointer MakePixelContender()
{
  return std::make_unique<ModuleContender>("outline per pixel", 4, false, true);
}

std::string GetDefaultName()
{
  return GetModuleName(4, true);
}

std::vector<ContenderPointer> MakeContenders(int width, int height, double megabytes)
{
  std::vector<ContenderPointer> contenders;
  const auto add = [&](const DepthFamily& family)
  {
    DepthStructure structure(family);
    structure.SetSize(width, height);
    if (static_cast<double>(structure.GetNumberOfTexels()) * sizeof(float) <= megabytes * 1e6)
    {
      contenders.push_back(MakeFamilyContender(family));
    }
  };
  constexpr DepthGrid windows = DepthGrid::Windows;
  constexpr DepthTaps four = DepthTaps::Four;
  for (int factor : { 1, 2, 4, 8, 16 })
  {
    add({ factor, windows, FullStride, 0, DepthTaps::One, false });
    add({ factor, windows, FullStride, 0, four, false });
  }
  for (int factor : { 1, 4 })
  {
    add({ factor, windows, FullStride, 0, four, true });
    for (int stride : { 0, 1, 2, 3 })
    {
      add({ factor, windows, stride, 0, four, false });
    }
    for (DepthGrid mips : { DepthGrid::Mips, DepthGrid::FatMips })
    {
      add({ factor, mips, FullStride, 0, DepthTaps::TwoByTwo, false });
      add({ factor, mips, FullStride, 0, DepthTaps::FourByFour, false });
    }
    for (int band : { 1, 2 })
    {
      add({ factor, windows, FullStride, band, four, false });
    }
    add({ factor, windows, 2, AllShapes, four, false });
    contenders.push_back(MakePositionContender(factor));
  }
  for (int factor : { 4, 8, 16 })
  {
    add({ factor, windows, FullStride, AllShapes, four, false });
    add({ factor, windows, FullStride, 0, DepthTaps::All, false });
  }
  for (int factor : { 2, 4, 8 })
  {
    contenders.push_back(MakeModuleContender(factor, false));
    contenders.push_back(MakeModuleContender(factor, true));
  }
  contenders.push_back(MakePixelContender());
  return contenders;
}

} // namespace NBufferStudy
