// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunShadows.h"

#include "vtkLight.h"

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
  , Sun(NBufferExamples::MakeSun(Time, scene.UpAxis))
{
  this->Fill->SetLightTypeToHeadlight();
  this->Fill->SetIntensity(0.25);
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
  NBufferExamples::LightGround(this->Parts, shown);
}

void SunShadows::Move(double hours)
{
  const double length = Evening - Morning;
  const double since = std::fmod(this->Time.Hour + hours - Morning, length);
  this->Time.Hour = Morning + (since < 0.0 ? since + length : since);
  NBufferExamples::SetSun(this->Time, this->Sun, this->Parts.UpAxis);
}

std::string SunShadows::GetTime() const
{
  const auto minutes = static_cast<int>(std::lround(60.0 * this->Time.Hour));
  std::ostringstream text;
  text << std::setfill('0') << std::setw(2) << minutes / 60 << ":" << std::setw(2) << minutes % 60;
  return text.str();
}

} // namespace NBufferView
