// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowErrors.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Pixels from a sample within which the border of a shadow may be displaced.
constexpr int OutlineReach = 2;
/// Widths of a pixel within which a caster touches what it shadows.
constexpr double ContactReach = 10.0;

/// Returns how wide a pixel is at the place of a receiver.
double GetPixelWidth(const Oracle& oracle, int x, int y, const Oracle::Receiver& receiver)
{
  const Ray here = oracle.GetEyeRay(x, y);
  const Ray there = oracle.GetEyeRay(x, y, 1.0, 0.0);
  const double distance =
    std::sqrt(vtkMath::Distance2BetweenPoints(here.Origin, receiver.Position));
  double places[2][3];
  for (int i = 0; i < 3; ++i)
  {
    places[0][i] = here.Origin[i] + distance * here.Direction[i];
    places[1][i] = there.Origin[i] + distance * there.Direction[i];
  }
  return std::sqrt(vtkMath::Distance2BetweenPoints(places[0], places[1]));
}
}

ShadowError ClassifyShadowError(
  const Oracle& oracle, const OracleLight& light, const OracleImage& expected, int x, int y)
{
  const auto sample = [&expected](int column, int row)
  { return expected.Samples[static_cast<std::size_t>(row) * expected.Width + column]; };
  const bool isLit = sample(x, y) == OracleSample::Lit;
  const OracleSample drawn = isLit ? OracleSample::Shadowed : OracleSample::Lit;
  for (int row = std::max(y - OutlineReach, 0);
       row <= std::min(y + OutlineReach, expected.Height - 1); ++row)
  {
    for (int column = std::max(x - OutlineReach, 0);
         column <= std::min(x + OutlineReach, expected.Width - 1); ++column)
    {
      if (sample(column, row) == drawn)
      {
        return ShadowError::Outline;
      }
    }
  }
  if (isLit)
  {
    return ShadowError::Acne;
  }
  Oracle::Receiver receiver;
  oracle.GetReceiver(x, y, 0.0, 0.0, receiver);
  const double contact = ContactReach * GetPixelWidth(oracle, x, y, receiver);
  bool touches = false;
  oracle.VisitCasters(receiver, light,
    [&](int, double distance)
    {
      touches = distance < contact;
      return !touches;
    });
  return touches ? ShadowError::PeterPanning : ShadowError::Leak;
}
