// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OracleImage.h"

#include "vtkLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

OracleLight::OracleLight(vtkLight* light)
  : Positional(light->GetPositional() != 0)
{
  double focalPoint[3];
  light->GetTransformedPosition(this->Position);
  light->GetTransformedFocalPoint(focalPoint);
  vtkMath::Subtract(focalPoint, this->Position, this->Direction);
  vtkMath::Normalize(this->Direction);
  if (this->Positional && light->GetConeAngle() < 90.0)
  {
    this->ConeCosine = std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()));
  }
}

void OracleLight::GetDirectionTo(const double place[3], double direction[3]) const
{
  for (int i = 0; i < 3; ++i)
  {
    direction[i] = this->Positional ? this->Position[i] - place[i] : -this->Direction[i];
  }
  vtkMath::Normalize(direction);
}

int OracleImage::Count(OracleSample sample) const
{
  return static_cast<int>(std::count(this->Samples.begin(), this->Samples.end(), sample));
}

int OracleImage::CountAmbiguous() const
{
  return static_cast<int>(
    this->Ambiguous.size() - std::count(this->Ambiguous.begin(), this->Ambiguous.end(), 0));
}
