// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tune.h
 * @brief Sets one constant of a culler or a shadow pass (vtkNBufferTuning, vtkShadowTuning).
 */
#ifndef Tune_h
#define Tune_h

#include <type_traits>

/// Sets one constant, as in Tune(culler, &vtkNBufferTuning::RoundSize, 16). `object` is a pointer
/// or a smart pointer. An object that has the value already is not modified.
template <typename Object, typename Tuning, typename Value>
void Tune(const Object& object, Value Tuning::*member, const std::common_type_t<Value>& value)
{
  Tuning tuning = object->GetTuning();
  tuning.*member = value;
  object->SetTuning(tuning);
}

#endif
