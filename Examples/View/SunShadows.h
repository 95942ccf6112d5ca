// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class SunShadows
 * @brief The shadows of a view in the light of the sun of 21 June, which can be moved.
 */
#ifndef SunShadows_h
#define SunShadows_h

#include "Sun.h"
#include "View.h"

#include "vtkLightCollection.h"
#include "vtkShadowVolumeClampPass.h"

#include <string>

namespace NBufferView
{

class SunShadows
{
public:
  SunShadows(View& view, const NBufferExamples::Scene& scene);

  ///@{
  /// Without shadows the scene has the lights that it had before.
  void SetShown(bool shown);
  bool IsShown() const { return this->Shown; }
  ///@}

  /// Moves the sun by a number of hours. The hours of the night are left out: after 20:00 comes
  /// 4:00.
  void Move(double hours);

  /// Returns the solar time as in 09:30.
  std::string GetTime() const;

  const vtkShadowStatistics& GetStatistics() const { return this->Pass->GetStatistics(); }

private:
  View& Where;
  const NBufferExamples::Scene& Parts;
  bool Shown = false;
  NBufferExamples::SunTime Time;
  vtkSmartPointer<vtkLight> Sun;
  vtkNew<vtkLight> Fill; ///< A weak light from the eye, so that shadows are not black.
  vtkNew<vtkLightCollection> Before;
  vtkNew<vtkShadowVolumeClampPass> Pass;
};

} // namespace NBufferView

#endif
