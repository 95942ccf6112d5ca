// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Families.h
 * @brief The parts of random scenarios: the families of scenes, each built around one hazard, with
 * their cameras; windows, cullers and renderers; lights and shadow passes.
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
  double Weight; ///< The family is chosen in proportion to its weight.
  Family Build;
};

const std::vector<NamedFamily>& GetFamilies();
/// Returns the families around hazards of shadow volumes.
const std::vector<NamedFamily>& GetShadowFamilies();

/// Gives some props the mapper of an earlier prop in the same renderer.
void ShareMappers(Writer& writer);

/// In some scenarios with large props, replaces the data of all props by data of the same size
/// whose points are in the reverse order: the units have the same boxes, but other indices.
void ReversePoints(Writer& writer);

/// Makes some props parts of an assembly that is before them in the list.
void NestAssemblies(Writer& writer);

/// Copies the props, views, lights and changes of a random named scenario (NamedScenarios.h): of a
/// hazard of shadows if `shadows` is true, else of culling.
void BuildNamed(Writer& writer, bool shadows);

void MakeWindow(Writer& writer);
void MakeCuller(Writer& writer);
/// Makes one renderer, or sometimes two, of scenes whose props and views are complete.
void MakeRenderers(Writer& writer);

/// Adds lights, shadow passes and their changes to a scene that has everything else.
void AddShadows(Writer& writer);
}

#endif
