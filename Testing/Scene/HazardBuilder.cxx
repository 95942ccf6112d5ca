// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazardBuilder.h"

#include <algorithm>

namespace TestScene
{
HazardBuilder::HazardBuilder(const std::string& name, int width, int height)
{
  this->Result.Name = name;
  this->Scene.Family = name;
  this->Scene.Window.Width = width;
  this->Scene.Window.Height = height;
  this->Scene.Culler.DefaultCuller = DefaultCuller::Before;
  this->Scene.Culler.RoundSize = 12;
}

void HazardBuilder::BeExact(int baseFactor)
{
  this->Scene.Culler.DefaultCuller = DefaultCuller::Removed;
  this->Scene.Culler.BaseFactor = baseFactor;
  this->Scene.Culler.ReuseWhenStill = false;
}

Expectation& HazardBuilder::ExpectHidden(int minimum, int maximum, int renderer)
{
  Expectation& expectation = this->Expect(renderer);
  expectation.MinimumHidden = minimum;
  expectation.MaximumHidden = maximum;
  return expectation;
}

void HazardBuilder::ExpectCulled(int minimum, int renderer)
{
  this->Expect(renderer).MinimumCulled = minimum;
}

void HazardBuilder::ExpectVerdicts(
  const std::vector<int>& props, const std::vector<vtkNBufferVerdict>& allowed, int minimumHidden)
{
  Expectation& expectation = this->Expect();
  expectation.Props = props;
  expectation.Allowed = allowed;
  expectation.MinimumHiddenOfProps = minimumHidden;
}

void HazardBuilder::ExpectNone(
  const std::vector<int>& props, const std::vector<vtkNBufferVerdict>& unwanted)
{
  std::vector<vtkNBufferVerdict> allowed;
  for (int i = 0; i < vtkNBufferStatistics::NumberOfVerdicts; ++i)
  {
    const auto verdict = static_cast<vtkNBufferVerdict>(i);
    if (std::find(unwanted.begin(), unwanted.end(), verdict) == unwanted.end())
    {
      allowed.push_back(verdict);
    }
  }
  this->ExpectVerdicts(props, allowed);
}

void HazardBuilder::ExpectDecision(vtkNBufferDecision decision, int renderer)
{
  this->Expect(renderer).Decision = decision;
}

void HazardBuilder::ExpectPixels(const glm::dvec3& color, int minimum)
{
  Expectation& expectation = this->Expect();
  expectation.Color = color;
  expectation.MinimumPixels = minimum;
}

NamedScenario HazardBuilder::Finish()
{
  this->Result.Scenario = this->Scene;
  return this->Result;
}

Expectation& HazardBuilder::Expect(int renderer)
{
  this->Result.Expectations.emplace_back();
  Expectation& expectation = this->Result.Expectations.back();
  expectation.Frame = this->GetFrame();
  expectation.Renderer = renderer;
  return expectation;
}

std::vector<int> MakeRange(int first, int last, int step)
{
  std::vector<int> range;
  for (int i = first; i < last; i += step)
  {
    range.push_back(i);
  }
  return range;
}
}
