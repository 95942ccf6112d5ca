// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferExchangeMessage.h"

#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferGLM.h"

#include <algorithm>
#include <functional>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr std::size_t ViewSize = std::tuple_size<decltype(vtkNBufferRankReport::View)>::value;
constexpr std::size_t Maxima = 4; // Step, Changed, Misfit and NewProps.
constexpr std::size_t Sums = 3;   // Candidates, Gain and Unhidden, each with a float for each rank.

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
  , Values(texels + 2 * ViewSize + Maxima + Sums * static_cast<std::size_t>(ranks), 0.0F)
{
  std::fill_n(this->Values.begin(), texels, vtkNBufferDepthConvention::Background);
}

void vtkNBufferExchangeMessage::SetReport(const vtkNBufferRankReport& report)
{
  float* next =
    std::copy(report.View.begin(), report.View.end(), this->Values.data() + this->Texels);
  next = std::transform(report.View.begin(), report.View.end(), next, std::negate<>());
  *next++ = -vtkNBufferGLM::RoundUp(report.Step);
  *next++ = report.Changed ? -1.0F : 0.0F;
  *next++ = report.Misfit ? -1.0F : 0.0F;
  *next++ = static_cast<float>(-report.NewProps);
  for (const int summand : { report.Candidates, report.Gain, report.Unhidden })
  {
    next[this->Rank] = static_cast<float>(-summand);
    next += this->Ranks;
  }
}

vtkNBufferRankReply vtkNBufferExchangeMessage::GetReply(const std::vector<float>& minima) const
{
  const float* next = minima.data() + this->Texels;
  vtkNBufferRankReply reply;
  reply.SameView = std::equal(next, next + ViewSize, next + ViewSize,
    [](float minimum, float negativeMaximum) { return minimum == -negativeMaximum; });
  next += 2 * ViewSize;
  reply.Step = -*next++;
  reply.Changed = *next++ < 0.0F;
  reply.Misfit = *next++ < 0.0F;
  reply.NewProps = static_cast<int>(-*next++);
  for (int* sum : { &reply.Candidates, &reply.Gain, &reply.Unhidden })
  {
    *sum = AddNegated(next, this->Ranks);
    next += this->Ranks;
  }
  return reply;
}
VTK_ABI_NAMESPACE_END
