// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class Comparison
 * @brief The culler of a view, on and off, and the same view with and without it: times and bytes.
 */
#ifndef Comparison_h
#define Comparison_h

#include "View.h"

#include "vtkNBufferCuller.h"

namespace NBufferView
{

class Comparison
{
public:
  /// The culler is on at first.
  explicit Comparison(View& view);

  vtkNBufferCuller* GetCuller() { return this->Culler; }

  ///@{
  /// Set and return whether the scene is drawn with the culler; otherwise stock VTK draws it.
  void SetCulling(bool on);
  bool IsCulling() const { return this->On; }
  ///@}

  /// Draws the present view with and without the culler, by turns, a few frames each, and stores
  /// the medians of the last ones.
  void Measure(int turns);

  ///@{
  /// The milliseconds of a frame, measured last; 0 if they were not measured yet.
  double GetStockTime() const { return this->StockTime; }
  double GetOwnTime() const { return this->OwnTime; }
  ///@}

  /// Returns how many bytes of the present view differ with and without the culler: 0, unless the
  /// verdicts are frozen.
  long long Verify();

private:
  View& Where;
  bool On = false;
  double StockTime = 0.0;
  double OwnTime = 0.0;
  vtkNew<vtkNBufferCuller> Culler;
};

} // namespace NBufferView

#endif
