// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrintVectors.h
 * @brief Makes GoogleTest print vectors of GLM with 17 digits, enough to restore every double.
 */
#ifndef PrintVectors_h
#define PrintVectors_h

#include "vtkNBufferGLM.h"

#include <ostream>

namespace glm
{
template <length_t Length, typename Number, qualifier Qualifier>
void PrintTo(const vec<Length, Number, Qualifier>& x, std::ostream* os)
{
  const std::streamsize digits = os->precision(17);
  for (length_t i = 0; i < Length; ++i)
  {
    *os << (i == 0 ? "(" : ", ") << x[i];
  }
  *os << ")";
  os->precision(digits);
}
}

#endif
