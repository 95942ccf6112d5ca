// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferUnitChoice.h"

#include "vtkNBufferForEachProp.h"

#include <algorithm>
#include <cmath>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A view is new if less than 1/NewView of the units that the last test found visible are in the
/// frustum, or if the frustum has more than NewView times as many units as that of the last test.
constexpr int NewView = 4;

/// About one in this many units is chosen.
constexpr double NearestShare = 16.0;
}

void vtkNBufferUnitChoice::SetTested(const vtkNBufferProjection& projection, int tested, int seen)
{
  this->Eye = vtkNBufferEye(projection);
  this->Tested = tested;
  this->Seen = seen;
}

bool vtkNBufferUnitChoice::IsFromElsewhere(const vtkNBufferProjection& projection,
  const vtkNBufferUnits& units, const std::vector<unsigned char>& marked) const
{
  const vtkNBufferEye eye(projection);
  int difference = 0; // Between the units that are seen from elsewhere and the others.
  for (std::size_t i = 0; i < units.GetSize(); ++i)
  {
    if (marked[i])
    {
      const vtkNBufferUnits::Box& box = units.GetLevels()[0][i];
      const glm::dvec3 middle(0.5F * box.Low + 0.5F * box.High);
      difference += eye.SeesFromElsewhere(middle, this->Eye) ? 1 : -1;
    }
  }
  return difference > 0;
}

bool vtkNBufferUnitChoice::IsNew(int inside, int kept) const
{
  return NewView * kept < this->Seen || inside > NewView * this->Tested;
}

std::vector<std::size_t> vtkNBufferUnitChoice::FindNearest(
  std::size_t size, int number, const vtkNBufferProjection& projection, const Project& project)
{
  const double width = projection.GetWidth();
  const double height = projection.GetHeight();
  const double side = std::max(std::sqrt(width * height * NearestShare / number), 1.0);
  const auto columns = static_cast<std::size_t>(width / side) + 1;
  const std::size_t squares = columns * (static_cast<std::size_t>(height / side) + 1);
  // The square and the depth of each unit.
  std::vector<std::pair<std::size_t, double>> places(size, { squares, 0.0 });
  vtkNBufferForEachProp::RunEach(size,
    [&](std::size_t i)
    {
      vtkNBufferScreenBox screen;
      if (project(i, screen))
      {
        const vtkNBufferRectangle& pixels = screen.Pixels;
        const double x = 0.5 * (pixels.X0 + pixels.X1) / side;
        const double y = 0.5 * (pixels.Y0 + pixels.Y1) / side;
        places[i] = { static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x),
          screen.Nearest };
      }
    });
  std::vector<std::size_t> nearest(squares, size);
  for (std::size_t i = 0; i < size; ++i)
  {
    if (places[i].first < squares)
    {
      std::size_t& unit = nearest[places[i].first];
      unit = unit == size || places[i].second < places[unit].second ? i : unit;
    }
  }
  nearest.erase(std::remove(nearest.begin(), nearest.end(), size), nearest.end());
  return nearest;
}
VTK_ABI_NAMESPACE_END
