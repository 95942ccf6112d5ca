// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class CulledParts
 * @brief Shows in red what the culler found hidden.
 *
 * The marks are props of their own in the second renderer of the view, so that the scene, its
 * culler and its image stay as they are. A mark is made when its part is found hidden for the first
 * time; it uses the mesh of the part.
 */
#ifndef CulledParts_h
#define CulledParts_h

#include "Comparison.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <vector>

namespace NBufferView
{

class CulledParts
{
public:
  CulledParts(View& view, Comparison& comparison, const NBufferExamples::Scene& scene);
  CulledParts(const CulledParts&) = delete;
  void operator=(const CulledParts&) = delete;

  ///@{
  void SetShown(bool shown);
  bool IsShown() const { return this->Shown; }
  ///@}

  /// Returns how many marks the last frame has.
  int GetCount() const { return this->Count; }

private:
  /// Before the marks are drawn, the verdicts of the frame are known.
  void Update();
  vtkActor* GetMark(std::size_t part);

  View& Where;
  Comparison& Culling;
  const NBufferExamples::Scene& Parts;
  bool Shown = false;
  int Count = 0;
  std::vector<vtkSmartPointer<vtkActor>> Marks; ///< One for each actor of the scene; or nullptr.
  vtkNew<vtkProperty> Red;
};

} // namespace NBufferView

#endif
