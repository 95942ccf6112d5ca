// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class CulledParts
 * @brief Shows in red what the culler found hidden.
 *
 * The marks are props of their own in the second renderer of the view, so that the scene, its
 * culler and its image stay as they are. A mark is made when its part is found hidden for the first
 * time; it uses the mesh of the part. Of a large part, which the culler draws unit by unit, the
 * mark has the hidden instances of a vtkGlyph3DMapper or the hidden cells of a mesh; it is made
 * anew in each frame.
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

  /// Returns how much the last frame has marked: parts and, of large parts, instances and cells.
  int GetCount() const { return this->Count; }

private:
  /// Is called before the marks are drawn, when the verdicts of the frame are known.
  void Update();
  /// Marks what is hidden of a part, and returns how much that is.
  int Mark(std::size_t part);
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
