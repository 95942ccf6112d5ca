// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferUnitChoice.h"

#include "vtkNBufferCoarseDepth.h"
#include "vtkNBufferForEachProp.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A unit of which more than 1/OpenShare is in front of the others does not count as hidden. Of
/// props more must be (vtkNBufferPartition.cxx). A unit that is left out costs another round.
constexpr int OpenShare = 8;
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

std::vector<std::size_t> vtkNBufferUnitChoice::FindOccluders(
  std::size_t size, const vtkNBufferProjection& projection, const Project& project)
{
  struct Place
  {
    vtkNBufferRectangle Pixels;
    double Nearest;
    double Farthest;
  };
  std::vector<Place> places(size);
  vtkNBufferForEachProp::RunEach(size,
    [&](std::size_t i)
    {
      vtkNBufferScreenBox screen;
      if (project(i, screen))
      {
        places[i] = { screen.Pixels, screen.Nearest, screen.Farthest };
      }
    });
  vtkNBufferCoarseDepth depth(projection.GetWidth(), projection.GetHeight());
  for (const Place& place : places)
  {
    if (!place.Pixels.IsEmpty())
    {
      depth.Add(place.Pixels, place.Farthest);
    }
  }
  std::vector<unsigned char> areOpen(size);
  vtkNBufferForEachProp::RunEach(size,
    [&](std::size_t i)
    {
      areOpen[i] =
        !places[i].Pixels.IsEmpty() && depth.IsOpen(places[i].Pixels, places[i].Nearest, OpenShare);
    });
  std::vector<std::size_t> occluders;
  for (std::size_t i = 0; i < size; ++i)
  {
    if (areOpen[i])
    {
      occluders.push_back(i);
    }
  }
  return occluders;
}
VTK_ABI_NAMESPACE_END
