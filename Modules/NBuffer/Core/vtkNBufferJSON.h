// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferJSON.h
 * @brief Functions for the names and the JSON of vtkNBufferStatistics and vtkShadowStatistics.
 */
#ifndef vtkNBufferJSON_h
#define vtkNBufferJSON_h

#include "vtkNBufferVTKVersion.h"

#include "vtk_jsoncpp.h"

#include <array>
#include <cstddef>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferJSON
{
/// The name of an enumerator, which is names[i] for the value i; "Invalid" beyond the names.
template <typename Enum, std::size_t Size>
const char* GetName(const char* const (&names)[Size], Enum value)
{
  const auto i = static_cast<std::size_t>(value);
  return i < Size ? names[i] : "Invalid";
}

/// A JSON object with a member for each enumerator: values[i] under the name of enumerator i.
template <typename Enum, typename Value, std::size_t Size>
Json::Value ByName(const std::array<Value, Size>& values, const char* (*getName)(Enum))
{
  Json::Value json(Json::objectValue);
  for (std::size_t i = 0; i < Size; ++i)
  {
    json[getName(static_cast<Enum>(i))] = values[i];
  }
  return json;
}

/// The text of a JSON value, on one line.
inline std::string Write(const Json::Value& json)
{
  Json::StreamWriterBuilder writer;
  writer["indentation"] = "";
  return Json::writeString(writer, json);
}
}
VTK_ABI_NAMESPACE_END
#endif
