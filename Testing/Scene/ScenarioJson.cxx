// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScenarioJson.h"

#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace TestScene
{
namespace
{
/// Calls visit(name, member) for each.
template <typename T, typename Visitor>
void VisitMembers(T& object, Visitor&& visit)
{
  auto name = T::GetMemberNames().begin();
  std::apply([&](auto&... members) { (visit(*name++, members), ...); }, object.GetMembers());
}

//------------------------------------------------------------------------------------------------
Json::Value Encode(bool value)
{
  return value;
}
Json::Value Encode(int value)
{
  return value;
}
Json::Value Encode(std::uint64_t value)
{
  return Json::UInt64(value);
}
Json::Value Encode(const std::string& value)
{
  return value;
}
Json::Value Encode(double value)
{
  if (std::isfinite(value))
  {
    return value;
  }
  return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

Json::Value Encode(const glm::dvec3& value)
{
  Json::Value result(Json::arrayValue);
  for (int i = 0; i < 3; ++i)
  {
    result.append(Encode(value[i]));
  }
  return result;
}

template <typename T>
std::enable_if_t<std::is_enum<T>::value, Json::Value> Encode(T value)
{
  return EnumNames<T>::Get()[static_cast<int>(value)];
}

template <typename T>
std::enable_if_t<std::is_class<T>::value, Json::Value> Encode(const T& value);

template <typename Range>
Json::Value EncodeRange(const Range& range)
{
  Json::Value result(Json::arrayValue);
  for (const auto& value : range)
  {
    result.append(Encode(value));
  }
  return result;
}
template <typename T>
Json::Value Encode(const std::vector<T>& values)
{
  return EncodeRange(values);
}
template <std::size_t N>
Json::Value Encode(const std::array<double, N>& values)
{
  return EncodeRange(values);
}

template <typename T>
std::enable_if_t<std::is_class<T>::value, Json::Value> Encode(const T& value)
{
  const auto encodeAll = [](const T& object)
  {
    Json::Value result(Json::objectValue);
    VisitMembers(object,
      [&result](const std::string& name, const auto& member) { result[name] = Encode(member); });
    return result;
  };
  static const Json::Value defaults = encodeAll(T());
  Json::Value result = encodeAll(value);
  for (const std::string& name : defaults.getMemberNames())
  {
    if (result[name] == defaults[name])
    {
      result.removeMember(name);
    }
  }
  return result;
}

//------------------------------------------------------------------------------------------------
/// Says where in the file something is wrong.
class Decoder
{
public:
  explicit Decoder(std::string place)
    : Place(std::move(place))
  {
  }

  void operator()(const Json::Value& json, bool& value) const
  {
    this->Demand(json.isBool(), "true or false");
    value = json.asBool();
  }
  void operator()(const Json::Value& json, int& value) const
  {
    this->Demand(json.isInt(), "an integer");
    value = json.asInt();
  }
  void operator()(const Json::Value& json, std::uint64_t& value) const
  {
    this->Demand(json.isUInt64(), "an integer that is not negative");
    value = json.asUInt64();
  }
  void operator()(const Json::Value& json, std::string& value) const
  {
    this->Demand(json.isString(), "a string");
    value = json.asString();
  }
  void operator()(const Json::Value& json, double& value) const
  {
    if (json.isString())
    {
      const std::string text = json.asString();
      this->Demand(text == "nan" || text == "inf" || text == "-inf", "a number");
      value = text == "nan"
        ? std::numeric_limits<double>::quiet_NaN()
        : std::numeric_limits<double>::infinity() * (text == "inf" ? 1.0 : -1.0);
      return;
    }
    this->Demand(json.isNumeric(), "a number");
    value = json.asDouble();
  }

  template <typename T>
  std::enable_if_t<std::is_enum<T>::value> operator()(const Json::Value& json, T& value) const
  {
    const std::string text = json.isString() ? json.asString() : "";
    const char* const* names = EnumNames<T>::Get();
    int i = 0;
    while (names[i] && text != names[i])
    {
      ++i;
    }
    this->Demand(names[i] != nullptr, "one of the names known here");
    value = static_cast<T>(i);
  }
  void operator()(const Json::Value& json, glm::dvec3& value) const
  {
    std::array<double, 3> values;
    (*this)(json, values);
    value = { values[0], values[1], values[2] };
  }
  template <std::size_t N>
  void operator()(const Json::Value& json, std::array<double, N>& values) const
  {
    this->Demand(json.isArray() && json.size() == N, std::to_string(N) + " numbers");
    for (std::size_t i = 0; i < N; ++i)
    {
      (*this)(json[static_cast<Json::ArrayIndex>(i)], values[i]);
    }
  }
  template <typename T>
  void operator()(const Json::Value& json, std::vector<T>& values) const
  {
    this->Demand(json.isArray(), "an array");
    values.assign(json.size(), T());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      Decoder element(this->Place + "[" + std::to_string(i) + "]");
      element(json[static_cast<Json::ArrayIndex>(i)], values[i]);
    }
  }
  template <typename T>
  std::enable_if_t<std::is_class<T>::value> operator()(const Json::Value& json, T& value) const
  {
    this->Demand(json.isObject(), "an object");
    unsigned int known = 0;
    VisitMembers(value,
      [&](const std::string& name, auto& member)
      {
        if (json.isMember(name))
        {
          ++known;
          Decoder inside(this->Place + "." + name);
          inside(json[name], member);
        }
      });
    this->Demand(known == json.size(), "without members that are not known here");
  }

private:
  void Demand(bool fulfilled, const std::string& what) const
  {
    if (!fulfilled)
    {
      throw std::runtime_error(this->Place + " must be " + what);
    }
  }

  std::string Place;
};
}

std::vector<std::string> MakeMemberNames(const std::string& members)
{
  std::vector<std::string> names(1);
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    const char c = members[i];
    if (c == ',')
    {
      names.emplace_back();
    }
    else if (std::isupper(c) && i > 0 && std::islower(members[i - 1]))
    {
      names.back() += '_';
    }
    if (std::isalpha(c))
    {
      names.back() += static_cast<char>(std::tolower(c));
    }
  }
  return names;
}

Json::Value ToJson(const Scenario& scenario)
{
  return Encode(scenario);
}

Scenario FromJson(const Json::Value& value)
{
  Scenario scenario;
  Decoder decoder("scenario");
  decoder(value, scenario);
  return scenario;
}

std::string ToText(const Json::Value& value)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = " ";
  builder["precision"] = std::numeric_limits<double>::max_digits10;
  return Json::writeString(builder, value) + "\n";
}

Json::Value ReadJson(const std::string& fileName)
{
  std::ifstream file(fileName);
  Json::Value value;
  std::string errors;
  if (!file || !Json::parseFromStream(Json::CharReaderBuilder(), file, &value, &errors))
  {
    throw std::runtime_error(
      fileName + ": " + (file.is_open() ? errors : std::string(std::strerror(errno))));
  }
  return value;
}

void WriteJson(const std::string& fileName, const Json::Value& value)
{
  std::ofstream file(fileName);
  file << ToText(value);
  file.close();
  if (!file)
  {
    throw std::runtime_error(fileName + ": " + std::strerror(errno));
  }
}
}
