// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CityScene.h
 * @brief One actor per building, the ground and the streets, z up, in metres.
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
 * The closed surface of a building: walls, flat roof and floor, facing outward, neighbours sharing
 * their points. It goes half a metre into the ground, so that its floor and the ground never share
 * a plane. Holes become courtyards. A footprint that crosses itself gets a roof with overlapping
 * triangles, and no cells at all if that fails as well.
 */
vtkSmartPointer<vtkPolyData> MakeBuilding(const CityBuilding& building);

/// Metres that a street of this kind is wide.
double GetStreetWidth(const std::string& kind);

/// Whether cars drive on it; otherwise it is for feet and bicycles.
bool IsCarriageway(const std::string& kind);

struct CityActors
{
  /// In the order of City::Buildings.
  std::vector<vtkSmartPointer<vtkActor>> Buildings;
  /// The ground, then the carriageways and the paths in tiles of 1 km.
  std::vector<vtkSmartPointer<vtkActor>> Surroundings;
};

CityActors MakeCityActors(const City& city);

/// Light, and the colour of the sky as background.
void LightCity(vtkRenderer* renderer);

} // namespace NBufferExamples

#endif
