// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModeSettings.h"

#include "Tune.h"

#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkShadowVolumeClampPass.h"

#include <charconv>
#include <sstream>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
template <typename Object>
struct Setting
{
  const char* Name;
  void (*Set)(Object*, int);
  int (*Get)(Object*);
};

// These two lists are the only place where settings of modes are named.
// clang-format off
#define NBUFFER_TUNING(Class, Tuning, Name)                                                        \
  {                                                                                                \
    #Name, [](Class* object, int value) { Tune(object, &Tuning::Name, value); },                  \
      [](Class* object) { return static_cast<int>(object->GetTuning().Name); }                    \
  }
#define NBUFFER_CULLER(Name) NBUFFER_TUNING(vtkNBufferCuller, vtkNBufferTuning, Name)
constexpr Setting<vtkNBufferCuller> CullerSettings[] = {
  NBUFFER_CULLER(RoundSize),
  NBUFFER_CULLER(MaximumNumberOfRounds),
  NBUFFER_CULLER(MinimumNumberOfCandidates),
  NBUFFER_CULLER(BaseFactor),
  NBUFFER_CULLER(HierarchySize),
  NBUFFER_CULLER(ObserveAfter),
  NBUFFER_CULLER(TestTriangles),
  NBUFFER_CULLER(TestPixels),
  NBUFFER_CULLER(BackOff),
  NBUFFER_CULLER(ReuseWhenStill),
  NBUFFER_CULLER(TakeOverFrustumCulling),
  { "TestSlivers", [](vtkNBufferCuller* culler, int value) { culler->SetTestSlivers(value); },
    [](vtkNBufferCuller* culler) { return culler->GetTestSlivers(); } },
};
constexpr Setting<vtkShadowVolumeClampPass> PassSettings[] = {
  NBUFFER_TUNING(vtkShadowVolumeClampPass, vtkShadowTuning, BoxCost),
  NBUFFER_TUNING(vtkShadowVolumeClampPass, vtkShadowTuning, SlabGap),
};
// clang-format on
#undef NBUFFER_CULLER
#undef NBUFFER_TUNING

template <typename Object, std::size_t N>
const Setting<Object>& Find(const Setting<Object> (&settings)[N], const std::string& name)
{
  const Setting<Object>* found = FindNamed(settings, name);
  if (!found)
  {
    std::string message = "no setting " + name + "; there are";
    for (const Setting<Object>& setting : settings)
    {
      message += std::string(" ") + setting.Name;
    }
    throw std::runtime_error(message);
  }
  return *found;
}

template <typename Object, std::size_t N>
void Apply(const Setting<Object> (&settings)[N], const std::string& mode, Object* object)
{
  std::istringstream words(mode);
  std::string word;
  std::getline(words, word, ':');
  while (std::getline(words, word, ':'))
  {
    const std::size_t equals = std::min(word.find('='), word.size());
    const Setting<Object>& setting = Find(settings, word.substr(0, equals));
    const char* begin = word.data() + std::min(equals + 1, word.size());
    const char* end = word.data() + word.size();
    int value = 0;
    const std::from_chars_result read = std::from_chars(begin, end, value);
    if (begin == end || read.ec != std::errc() || read.ptr != end)
    {
      throw std::runtime_error("mode " + mode + ": " + setting.Name +
        " is to be a whole number, such as " + setting.Name + "=" +
        std::to_string(setting.Get(object)));
    }
    setting.Set(object, value);
    if (setting.Get(object) != value)
    {
      throw std::runtime_error(
        "mode " + mode + ": " + setting.Name + " cannot be " + std::to_string(value));
    }
  }
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

void ApplySettings(const std::string& mode, vtkNBufferCuller* culler)
{
  Apply(CullerSettings, mode, culler);
}

void ApplySettings(const std::string& mode, vtkShadowVolumeClampPass* pass)
{
  Apply(PassSettings, mode, pass);
}

Json::Value GetDefaults()
{
  Json::Value defaults;
  vtkNew<vtkNBufferCuller> culler;
  for (const Setting<vtkNBufferCuller>& setting : CullerSettings)
  {
    defaults["culler"][setting.Name] = setting.Get(culler);
  }
  vtkNew<vtkShadowVolumeClampPass> pass;
  for (const Setting<vtkShadowVolumeClampPass>& setting : PassSettings)
  {
    defaults["shadow"][setting.Name] = setting.Get(pass);
  }
  defaults["shadow"]["LitmapResolution"] = pass->GetTuning().LitmapResolution;
  return defaults;
}

} // namespace NBufferBench
