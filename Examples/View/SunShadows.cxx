// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunShadows.h"

#include "vtkLight.h"
#include "vtkProperty.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace NBufferView
{
namespace
{
/// The sun of 21 June is above the horizon of Neubrandenburg between these hours.
constexpr double Morning = 4.0;
constexpr double Evening = 20.0;
}

SunShadows::SunShadows(View& view, const NBufferExamples::Scene& scene)
  : Where(view)
  , Parts(scene)
  , Sun(NBufferExamples::MakeSun(Time))
{
  this->Fill->SetLightTypeToHeadlight();
  this->Fill->SetIntensity(0.25);
  this->PlaceSun();
}

void SunShadows::SetShown(bool shown)
{
  if (shown == this->Shown)
  {
    return;
  }
  this->Shown = shown;
  vtkRenderer* renderer = this->Where.GetScene();
  if (shown)
  {
    this->Before->RemoveAllItems();
    vtkLightCollection* lights = renderer->GetLights();
    vtkCollectionSimpleIterator iterator;
    lights->InitTraversal(iterator);
    while (vtkLight* light = lights->GetNextLight(iterator))
    {
      this->Before->AddItem(light);
    }
    renderer->RemoveAllLights();
    renderer->AddLight(this->Sun);
    renderer->AddLight(this->Fill);
    renderer->SetPass(this->Pass);
  }
  else
  {
    renderer->SetPass(nullptr);
    renderer->RemoveAllLights();
    vtkCollectionSimpleIterator iterator;
    this->Before->InitTraversal(iterator);
    while (vtkLight* light = this->Before->GetNextLight(iterator))
    {
      renderer->AddLight(light);
    }
  }
  this->LightGround(shown);
}

void SunShadows::Move(double hours)
{
  const double length = Evening - Morning;
  const double since = std::fmod(this->Time.Hour + hours - Morning, length);
  this->Time.Hour = Morning + (since < 0.0 ? since + length : since);
  this->PlaceSun();
}

std::string SunShadows::GetTime() const
{
  const auto minutes = static_cast<int>(std::lround(60.0 * this->Time.Hour));
  std::ostringstream text;
  text << std::setfill('0') << std::setw(2) << minutes / 60 << ":" << std::setw(2) << minutes % 60;
  return text.str();
}

void SunShadows::PlaceSun()
{
  // East, north and up are x, y and z where z points up, and turned about where it does not.
  const glm::dvec3 way = NBufferExamples::GetDirectionToSun(this->Time);
  const glm::dvec3 place = this->Parts.UpAxis == 2 ? way
    : this->Parts.UpAxis == 1                      ? glm::dvec3(way.x, way.z, -way.y)
                                                   : glm::dvec3(way.z, way.x, way.y);
  this->Sun->SetPosition(glm::value_ptr(place));
}

void SunShadows::LightGround(bool lit)
{
  // In a city the ground and the streets have one colour, which no shadow would change.
  const std::size_t first =
    this->Parts.Plan ? this->Parts.Plan->Buildings.size() : this->Parts.Actors.size();
  for (std::size_t i = first; i < this->Parts.Actors.size(); ++i)
  {
    this->Parts.Actors[i]->GetProperty()->SetLighting(lit);
  }
}

} // namespace NBufferView
