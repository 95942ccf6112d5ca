// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferExchangeMessage.h"

#include "vtkNBufferDepthConvention.h"

#include <algorithm>
#include <cmath>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Where the parts of a report begin behind the texels.
constexpr std::size_t ViewSize = std::tuple_size<decltype(vtkNBufferRankReport::View)>::value;
constexpr std::size_t NegativeView = ViewSize;
constexpr std::size_t Step = 2 * ViewSize;
constexpr std::size_t Changed = Step + 1;
constexpr std::size_t Misfit = Changed + 1;
constexpr std::size_t NewProps = Misfit + 1;
constexpr std::size_t PerRank = NewProps + 1;
constexpr std::size_t Sums = 3; // Candidates, Gain and Unhidden, each with a float for each rank.

/// A float that is not less than a double.
float RoundUp(double value)
{
  const auto rounded = static_cast<float>(value);
  return rounded < value ? std::nextafter(rounded, HUGE_VALF) : rounded;
}

int AddNegated(const float* begin, int count)
{
  double sum = 0.0;
  std::for_each(begin, begin + count, [&sum](float value) { sum -= value; });
  return static_cast<int>(std::min(sum, 2147483647.0));
}
}

vtkNBufferExchangeMessage::vtkNBufferExchangeMessage(std::size_t texels, int ranks, int rank)
  : Texels(texels)
  , Ranks(ranks)
  , Rank(rank)
  , Values(texels + PerRank + Sums * static_cast<std::size_t>(ranks), 0.0F)
{
  std::fill_n(this->Values.begin(), texels, vtkNBufferDepthConvention::Background);
}

void vtkNBufferExchangeMessage::SetReport(const vtkNBufferRankReport& report)
{
  float* values = this->Values.data() + this->Texels;
  std::copy(report.View.begin(), report.View.end(), values);
  std::transform(report.View.begin(), report.View.end(), values + NegativeView,
    [](float value) { return -value; });
  values[Step] = -RoundUp(report.Step);
  values[Changed] = report.Changed ? -1.0F : 0.0F;
  values[Misfit] = report.Misfit ? -1.0F : 0.0F;
  values[NewProps] = static_cast<float>(-report.NewProps);
  values[PerRank + this->Rank] = static_cast<float>(-report.Candidates);
  values[PerRank + this->Ranks + this->Rank] = static_cast<float>(-report.Gain);
  values[PerRank + 2 * this->Ranks + this->Rank] = static_cast<float>(-report.Unhidden);
}

vtkNBufferRankReply vtkNBufferExchangeMessage::GetReply(const std::vector<float>& minima) const
{
  const float* values = minima.data() + this->Texels;
  vtkNBufferRankReply reply;
  reply.SameView = std::equal(values, values + ViewSize, values + NegativeView,
    [](float minimum, float negativeMaximum) { return minimum == -negativeMaximum; });
  reply.Step = -values[Step];
  reply.Changed = values[Changed] < 0.0F;
  reply.Misfit = values[Misfit] < 0.0F;
  reply.NewProps = static_cast<int>(-values[NewProps]);
  reply.Candidates = AddNegated(values + PerRank, this->Ranks);
  reply.Gain = AddNegated(values + PerRank + this->Ranks, this->Ranks);
  reply.Unhidden = AddNegated(values + PerRank + 2 * this->Ranks, this->Ranks);
  return reply;
}
VTK_ABI_NAMESPACE_END
