// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class SunShadows
 * @brief The shadows of a view in the light of the sun of 21 June, which can be moved.
 *
 * The axis of the scene that points up is the vertical; without a map nobody knows where its north
 * is.
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

  /// Moves the sun; after the evening comes the morning.
  void Move(double hours);

  /// Returns the solar time as in 09:30.
  std::string GetTime() const;

  const vtkShadowStatistics& GetStatistics() const { return this->Pass->GetStatistics(); }

private:
  void PlaceSun();
  void LightGround(bool lit);

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
