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

/// Makes the actors of a city: the buildings, in the order of City::Buildings, the ground, then the
/// carriageways and the paths in tiles of 1 km.
std::vector<vtkSmartPointer<vtkActor>> MakeCityActors(const City& city);

/// Sets the light of a renderer, and the colour of the sky as its background.
void LightCity(vtkRenderer* renderer);

} // namespace NBufferExamples

#endif
