// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModeSettings.h"

#include "vtkNBufferCuller.h"
#include "vtkShadowVolumeClampPass.h"

#include <algorithm>
#include <charconv>
#include <iterator>
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

using Culler = vtkNBufferCuller;
constexpr Setting<Culler> CullerSettings[] = {
  { "RoundSize", [](Culler* c, int v) { c->SetRoundSize(v); },
    [](Culler* c) { return c->GetRoundSize(); } },
  { "MaximumNumberOfRounds", [](Culler* c, int v) { c->SetMaximumNumberOfRounds(v); },
    [](Culler* c) { return c->GetMaximumNumberOfRounds(); } },
  { "MinimumNumberOfCandidates", [](Culler* c, int v) { c->SetMinimumNumberOfCandidates(v); },
    [](Culler* c) { return c->GetMinimumNumberOfCandidates(); } },
  { "BaseFactor", [](Culler* c, int v) { c->SetBaseFactor(v); },
    [](Culler* c) { return c->GetBaseFactor(); } },
  { "MaximumNumberOfPieces", [](Culler* c, int v) { c->SetMaximumNumberOfPieces(v); },
    [](Culler* c) { return c->GetMaximumNumberOfPieces(); } },
  { "HierarchySize", [](Culler* c, int v) { c->SetHierarchySize(v); },
    [](Culler* c) { return c->GetHierarchySize(); } },
  { "TestPixels", [](Culler* c, int v) { c->SetTestPixels(v != 0); },
    [](Culler* c) { return int(c->GetTestPixels()); } },
  { "TestSlivers", [](Culler* c, int v) { c->SetTestSlivers(v); },
    [](Culler* c) { return c->GetTestSlivers(); } },
  { "BackOff", [](Culler* c, int v) { c->SetBackOff(v != 0); },
    [](Culler* c) { return int(c->GetBackOff()); } },
  { "ReuseWhenStill", [](Culler* c, int v) { c->SetReuseWhenStill(v != 0); },
    [](Culler* c) { return int(c->GetReuseWhenStill()); } },
  { "TakeOverFrustumCulling", [](Culler* c, int v) { c->SetTakeOverFrustumCulling(v != 0); },
    [](Culler* c) { return int(c->GetTakeOverFrustumCulling()); } },
};

using Pass = vtkShadowVolumeClampPass;
constexpr Setting<Pass> PassSettings[] = {
  { "BoxCost", [](Pass* p, int v) { p->SetBoxCost(v); }, [](Pass* p) { return p->GetBoxCost(); } },
  { "SlabGap", [](Pass* p, int v) { p->SetSlabGap(v); }, [](Pass* p) { return p->GetSlabGap(); } },
  { "Scissor", [](Pass* p, int v) { p->SetScissor(v != 0); },
    [](Pass* p) { return int(p->GetScissor()); } },
  { "SkipUnlitReceivers", [](Pass* p, int v) { p->SetSkipUnlitReceivers(v != 0); },
    [](Pass* p) { return int(p->GetSkipUnlitReceivers()); } },
};

template <typename Object, std::size_t N>
const Setting<Object>& Find(const Setting<Object> (&settings)[N], const std::string& name)
{
  const auto* found = std::find_if(std::begin(settings), std::end(settings),
    [&name](const Setting<Object>& setting) { return name == setting.Name; });
  if (found == std::end(settings))
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

void ApplySettings(const std::string& mode, vtkNBufferCuller* culler)
{
  Apply(CullerSettings, mode, culler);
}

void ApplySettings(const std::string& mode, vtkShadowVolumeClampPass* pass)
{
  Apply(PassSettings, mode, pass);
}

int GetSetting(const std::string& name, vtkNBufferCuller* culler)
{
  return Find(CullerSettings, name).Get(culler);
}

int GetSetting(const std::string& name, vtkShadowVolumeClampPass* pass)
{
  return Find(PassSettings, name).Get(pass);
}

} // namespace NBufferBench
