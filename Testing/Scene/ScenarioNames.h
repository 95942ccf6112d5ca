// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioNames.h
 * @brief Names of members and of the values of enumerators, as the files of scenarios have them.
 */
#ifndef ScenarioNames_h
#define ScenarioNames_h

#include <string>
#include <tuple>
#include <vector>

namespace TestScene
{
/// "CasterKeys, OIT" becomes { "caster_keys", "oit" }.
std::vector<std::string> MakeMemberNames(const std::string& members);

/// Which members of a struct are in files.
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
