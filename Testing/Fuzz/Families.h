// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Families.h
 * @brief Scenes around one hazard each, and the cameras that look at them.
 */
#ifndef Families_h
#define Families_h

#include "Writer.h"

#include <vector>

namespace TestScene
{
using Family = void (*)(Writer&);

struct NamedFamily
{
  const char* Name;
  double Weight;
  Family Build;
};

const std::vector<NamedFamily>& GetFamilies();

/// Let some props draw what an earlier prop of their renderer draws, each in its own way.
void ShareMappers(Writer& writer);

/// In some scenarios with large props, replace the data of all props by data of the same size whose
/// points are in the reverse order: units of the same boxes, with other indices.
void ReversePoints(Writer& writer);

/// Make some props parts of the assembly that stands before them in the list.
void NestAssemblies(Writer& writer);

/// Props, views, lights and changes of any named scenario of the tests (NamedScenarios.h).
void BuildNamed(Writer& writer, bool shadows);
}

#endif
