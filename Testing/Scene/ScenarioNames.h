// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioNames.h
 * @brief Names of the values of enumerators, as the files of scenarios have them.
 */
#ifndef ScenarioNames_h
#define ScenarioNames_h

namespace TestScene
{
/// Names of an enumerator's values in files, ended by a null pointer.
template <typename Enum>
struct EnumNames;

#define NBUFFER_SCENE_NAMES(Enum, ...)                                                             \
  template <>                                                                                      \
  struct EnumNames<Enum>                                                                           \
  {                                                                                                \
    static const char* const* Get()                                                                \
    {                                                                                              \
      static const char* const names[] = { __VA_ARGS__, nullptr };                                 \
      return names;                                                                                \
    }                                                                                              \
  }
}

#endif
