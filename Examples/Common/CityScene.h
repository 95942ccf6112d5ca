// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CityScene.h
 * @brief A city as actors: one per building, the ground and the streets; z up, in metres.
 */
#ifndef CityScene_h
#define CityScene_h

#include "City.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkRenderer;

namespace NBufferExamples
{

/**
 * Returns the closed surface of a building: walls, flat roof and floor face outward, and
 * neighbouring faces share their points. The building reaches half a metre into the ground, so that
 * its floor and the ground never share a plane. Holes become courtyards. A footprint that crosses
 * itself gets a roof with overlapping triangles, and no cells at all if that fails as well.
 */
vtkSmartPointer<vtkPolyData> MakeBuilding(const CityBuilding& building);

/// Returns the width in metres of a street of this kind.
double GetStreetWidth(const std::string& kind);

/// Returns whether cars drive on a street of this kind; otherwise it is a path for feet and
/// bicycles.
bool IsCarriageway(const std::string& kind);

struct CityActors
{
  /// The buildings, in the order of City::Buildings.
  std::vector<vtkSmartPointer<vtkActor>> Buildings;
  /// The ground, then the carriageways and the paths in tiles of 1 km.
  std::vector<vtkSmartPointer<vtkActor>> Surroundings;
};

/// Makes the actors of a city.
CityActors MakeCityActors(const City& city);

/// Sets the light of a renderer, and the colour of the sky as its background.
void LightCity(vtkRenderer* renderer);

} // namespace NBufferExamples

#endif
