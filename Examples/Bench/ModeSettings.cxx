// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModeSettings.h"

#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowVolumeClampPass.h"

#include <charconv>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace NBufferBench
{
namespace
{
constexpr char TestSlivers[] = "TestSlivers";

/// The exponential constant of shadow maps: here of versions of VTK that have no setting for it.
template <typename Baker, typename = void>
struct ExponentOf
{
  static constexpr bool Exists = false;
  static void Set(Baker*, float) {}
};
template <typename Baker>
struct ExponentOf<Baker, std::void_t<decltype(std::declval<Baker&>().SetExponentialConstant(1.0f))>>
{
  static constexpr bool Exists = true;
  static void Set(Baker* baker, float exponent) { baker->SetExponentialConstant(exponent); }
};

struct MapSetting
{
  const char* Name;
  int ShadowMapSettings::*Member;
  int Least;
  int Most;
};
constexpr MapSetting MapSettings[] = { { "Exponent", &ShadowMapSettings::Exponent, 1, 88 },
  { "OffsetFactor", &ShadowMapSettings::OffsetFactor, 0, 1000 },
  { "OffsetUnits", &ShadowMapSettings::OffsetUnits, 0, 1000 },
  { "EachFrame", &ShadowMapSettings::EachFrame, 0, 1 } };

/// Sets one setting. Returns false if the name is unknown or the value is refused.
bool SetOne(vtkNBufferTuning& tuning, vtkNBufferCuller* culler, const std::string& name, int value)
{
  if (name == TestSlivers)
  {
    culler->SetTestSlivers(value != 0);
    return value == 0 || value == 1;
  }
  return tuning.Set(name, value) && tuning.FindFault().empty();
}

bool SetOne(vtkShadowTuning& tuning, vtkShadowVolumeClampPass*, const std::string& name, int value)
{
  return tuning.Set(name, value) && tuning.FindFault().empty();
}

bool SetOne(ShadowMapSettings& settings, ShadowMapSettings*, const std::string& name, int value)
{
  const MapSetting* setting = FindNamed(MapSettings, name);
  settings.*setting->Member = value;
  return value >= setting->Least && value <= setting->Most;
}

std::vector<std::string> GetNames(vtkNBufferCuller*)
{
  std::vector<std::string> names = vtkNBufferTuning::GetNames();
  names.emplace_back(TestSlivers);
  return names;
}

std::vector<std::string> GetNames(vtkShadowVolumeClampPass*)
{
  return vtkShadowTuning::GetNames();
}

std::vector<std::string> GetNames(ShadowMapSettings*)
{
  std::vector<std::string> names;
  for (const MapSetting& setting : MapSettings)
  {
    if (setting.Member != &ShadowMapSettings::Exponent || ExponentOf<vtkShadowMapBakerPass>::Exists)
    {
      names.emplace_back(setting.Name);
    }
  }
  return names;
}

int GetOne(vtkNBufferCuller* culler, const std::string& name)
{
  return name == TestSlivers ? culler->GetTestSlivers() : culler->GetTuning().Get(name);
}

int GetOne(vtkShadowVolumeClampPass* pass, const std::string& name)
{
  return pass->GetTuning().Get(name);
}

int GetOne(ShadowMapSettings* settings, const std::string& name)
{
  return settings->*FindNamed(MapSettings, name)->Member;
}

template <typename Object>
void CheckName(Object* object, const std::string& name)
{
  const std::vector<std::string> names = GetNames(object);
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    std::string message = "no setting " + name + "; there are";
    for (const std::string& known : names)
    {
      message += " " + known;
    }
    throw std::runtime_error(message);
  }
}

template <typename Object>
Json::Value GetDefaultsOf(Object* object)
{
  Json::Value defaults;
  for (const std::string& name : GetNames(object))
  {
    defaults[name] = GetOne(object, name);
  }
  return defaults;
}
}

std::string GetModeKind(const std::string& mode)
{
  return mode.substr(0, mode.find(':'));
}

void RemoveRepeated(std::vector<std::string>& modes)
{
  for (auto mode = modes.begin(); mode != modes.end();)
  {
    mode = std::find(modes.begin(), mode, *mode) == mode ? mode + 1 : modes.erase(mode);
  }
}

template <typename Object>
void ApplySettings(const std::string& mode, Object* object)
{
  std::istringstream words(mode);
  std::string word;
  std::getline(words, word, ':');
  auto tuning = object->GetTuning();
  while (std::getline(words, word, ':'))
  {
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string name = word.substr(0, equals);
    CheckName(object, name);
    const char* begin = word.data() + std::min(equals + 1, word.size());
    const char* end = word.data() + word.size();
    int value = 0;
    const std::from_chars_result read = std::from_chars(begin, end, value);
    if (begin == end || read.ec != std::errc() || read.ptr != end)
    {
      throw std::runtime_error("mode " + mode + ": " + name + " is to be a whole number, such as " +
        name + "=" + std::to_string(GetOne(object, name)));
    }
    if (!SetOne(tuning, object, name, value))
    {
      throw std::runtime_error(
        "mode " + mode + ": " + name + " cannot be " + std::to_string(value));
    }
  }
  object->SetTuning(tuning);
}
template void ApplySettings(const std::string&, vtkNBufferCuller*);
template void ApplySettings(const std::string&, vtkShadowVolumeClampPass*);
template void ApplySettings(const std::string&, ShadowMapSettings*);

void SetExponent(vtkShadowMapBakerPass* baker, int exponent)
{
  ExponentOf<vtkShadowMapBakerPass>::Set(baker, static_cast<float>(exponent));
}

Json::Value GetDefaults()
{
  Json::Value defaults;
  defaults["culler"] = GetDefaultsOf(vtkNew<vtkNBufferCuller>().Get());
  defaults["shadow"] = GetDefaultsOf(vtkNew<vtkShadowVolumeClampPass>().Get());
  ShadowMapSettings maps;
  defaults["maps"] = GetDefaultsOf(&maps);
  return defaults;
}

} // namespace NBufferBench
