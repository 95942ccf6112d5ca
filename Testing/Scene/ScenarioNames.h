// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioNames.h
 * @brief The names of members and enumerators in the files of scenarios.
 */
#ifndef ScenarioNames_h
#define ScenarioNames_h

#include <string>
#include <tuple>
#include <vector>

namespace TestScene
{
/// Returns the names of members in files: { "caster_keys", "oit" } for "CasterKeys, OIT".
std::vector<std::string> MakeMemberNames(const std::string& members);

/// Lists the members of a struct that are written to files.
#define NBUFFER_SCENE_MEMBERS(...)                                                                 \
  auto GetMembers()                                                                                \
  {                                                                                                \
    return std::tie(__VA_ARGS__);                                                                  \
  }                                                                                                \
  auto GetMembers() const                                                                          \
  {                                                                                                \
    return std::tie(__VA_ARGS__);                                                                  \
  }                                                                                                \
  static const std::vector<std::string>& GetMemberNames()                                          \
  {                                                                                                \
    static const std::vector<std::string> names = MakeMemberNames(#__VA_ARGS__);                   \
    return names;                                                                                  \
  }                                                                                                \
  static_assert(true, "for the semicolon")

/// Get() returns the names of an enumeration's values in files, and a null pointer at the end.
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
