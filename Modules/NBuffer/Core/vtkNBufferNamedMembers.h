// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferNamedMembers.h
 * @brief Access to the numbers of a struct by name, for vtkNBufferTuning and vtkShadowTuning.
 *
 * Each of the two has one array of vtkNBufferNamedMember, an element for each of its constants.
 */
#ifndef vtkNBufferNamedMembers_h
#define vtkNBufferNamedMembers_h

#include "vtkIndent.h"
#include "vtkNBufferVTKVersion.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// A member of a struct that is a number with a range, or a switch.
template <typename Struct>
struct vtkNBufferNamedMember
{
  const char* Name;
  std::variant<int Struct::*, bool Struct::*> Member;
  int Lowest = 0;
  int Highest = 1; ///< A switch is 0 or 1.

  bool IsSwitch() const { return this->Member.index() == 1; }

  int Get(const Struct& object) const
  {
    return std::visit(
      [&object](auto member) { return static_cast<int>(object.*member); }, this->Member);
  }
};

namespace vtkNBufferNamedMembers
{
/// Return the member with this name, or nullptr if there is none.
template <typename Struct, std::size_t N>
const vtkNBufferNamedMember<Struct>* Find(
  const vtkNBufferNamedMember<Struct> (&members)[N], const std::string& name)
{
  const auto found = std::find_if(std::begin(members), std::end(members),
    [&name](const vtkNBufferNamedMember<Struct>& member) { return name == member.Name; });
  return found == std::end(members) ? nullptr : found;
}

/// Return all names.
template <typename Members>
std::vector<std::string> GetNames(const Members& members)
{
  std::vector<std::string> names;
  std::transform(std::begin(members), std::end(members), std::back_inserter(names),
    [](const auto& member) { return member.Name; });
  return names;
}

/// Set the member with this name, without checking its range. Return false if there is no such
/// name, or if a switch gets a number that is neither 0 nor 1.
template <typename Members, typename Struct>
bool Set(const Members& members, Struct& object, const std::string& name, int value)
{
  const auto* member = Find(members, name);
  if (!member || (member->IsSwitch() && value != 0 && value != 1))
  {
    return false;
  }
  std::visit([&](auto place) { object.*place = value; }, member->Member);
  return true;
}

/// Return whether all members of two structs are equal.
template <typename Members, typename Struct>
bool AreEqual(const Members& members, const Struct& one, const Struct& other)
{
  return std::all_of(std::begin(members), std::end(members),
    [&](const auto& member) { return member.Get(one) == member.Get(other); });
}

/// Return a sentence about the first number that is out of its range, or an empty string.
template <typename Members, typename Struct>
std::string FindFault(const Members& members, const Struct& object)
{
  for (const auto& member : members)
  {
    const int value = member.Get(object);
    if (value < member.Lowest || value > member.Highest)
    {
      return std::string(member.Name) + " must be " + std::to_string(member.Lowest) + " to " +
        std::to_string(member.Highest) + ", not " + std::to_string(value);
    }
  }
  return "";
}

/// Print a line for each member.
template <typename Members, typename Struct>
void Print(const Members& members, const Struct& object, ostream& os, vtkIndent indent)
{
  for (const auto& member : members)
  {
    os << indent << member.Name << ": " << member.Get(object) << "\n";
  }
}
}

VTK_ABI_NAMESPACE_END
#endif
