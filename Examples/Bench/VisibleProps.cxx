// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleProps.h"

#include "vtkDataObject.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <unordered_map>

namespace NBufferBench
{
namespace
{
/// Draws every prop in a colour of its own.
class Finder
{
public:
  explicit Finder(Session& session)
    : Where(session)
  {
    session.SetCuller(vtkNew<vtkFrustumCoverageCuller>());
    for (vtkProp* prop : session.GetProps())
    {
      this->Places.emplace(prop, static_cast<int>(this->Places.size()));
    }
    const int* size = session.GetWindow()->GetActualSize();
    this->Pixels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
    this->Selector->SetRenderer(session.GetRenderer());
    this->Selector->SetArea(
      0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
    this->Selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    this->Selector->SetActorPassOnly(true);
  }

  /// Returns, for every pixel, the place of its prop or -1.
  std::vector<int> Find(const NBufferExamples::CameraPose& pose)
  {
    this->Where.SetPose(pose);
    const unsigned char* rgb = this->Selector->CaptureBuffers()
      ? this->Selector->GetPixelBuffer(vtkHardwareSelector::ACTOR_PASS)
      : nullptr;
    if (!rgb)
    {
      throw std::runtime_error("the props that own a pixel could not be found: no selection");
    }
    std::vector<int> owners(this->Pixels);
    std::unordered_map<int, int> known = { { 0, -1 } }; // The background.
    for (std::size_t i = 0; i < this->Pixels; ++i)
    {
      const int id = rgb[3 * i] | rgb[3 * i + 1] << 8 | rgb[3 * i + 2] << 16;
      const auto [entry, isNew] = known.try_emplace(id, -1);
      if (isNew)
      {
        const auto place = this->Places.find(this->Selector->GetPropFromID(id - 1));
        entry->second = place == this->Places.end() ? -1 : place->second;
      }
      owners[i] = entry->second;
    }
    return owners;
  }

private:
  Session& Where;
  vtkNew<vtkHardwareSelector> Selector;
  std::unordered_map<vtkProp*, int> Places;
  std::size_t Pixels = 0;
};
}

std::vector<std::vector<vtkProp*>> FindVisibleProps(
  Session& session, const NBufferExamples::CameraPath& path)
{
  Finder finder(session);
  const std::vector<vtkProp*> props = session.GetProps();
  std::vector<std::vector<vtkProp*>> visible;
  for (const NBufferExamples::CameraPose& pose : path)
  {
    const std::vector<int> owners = finder.Find(pose);
    std::set<int> places(owners.begin(), owners.end());
    places.erase(-1); // The background.
    visible.emplace_back();
    for (int place : places)
    {
      visible.back().push_back(props[static_cast<std::size_t>(place)]);
    }
    ShowProgress("finding which props own a pixel: frame " + std::to_string(visible.size()) +
      " of " + std::to_string(path.size()));
  }
  return visible;
}

std::vector<std::vector<vtkProp*>> FindPropsInView(
  Session& session, const NBufferExamples::CameraPath& path)
{
  std::vector<vtkProp*> props = session.GetProps();
  props.erase(std::remove_if(props.begin(), props.end(),
                [](vtkProp* prop) { return prop->GetVisibility() == 0; }),
    props.end());
  vtkNew<vtkFrustumCoverageCuller> frustum;
  std::vector<std::vector<vtkProp*>> inView(path.size(), props);
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    session.SetPose(path[i]);
    int count = static_cast<int>(props.size());
    int initialized = 0;
    frustum->Cull(session.GetRenderer(), inView[i].data(), count, initialized);
    inView[i].resize(static_cast<std::size_t>(count));
  }
  return inView;
}

std::vector<int> FindPixelOwners(Session& session, const NBufferExamples::CameraPose& pose)
{
  return Finder(session).Find(pose);
}

vtkStandardNewMacro(OracleCuller);

double OracleCuller::Cull(
  vtkRenderer* vtkNotUsed(renderer), vtkProp** propList, int& listLength, int& initialized)
{
  if (!this->Props || this->Props->size() > static_cast<std::size_t>(listLength))
  {
    return listLength;
  }
  std::copy(this->Props->begin(), this->Props->end(), propList);
  listLength = static_cast<int>(this->Props->size());
  for (vtkProp* prop : *this->Props)
  {
    prop->SetRenderTimeMultiplier(1.0);
  }
  initialized = 1;
  return listLength;
}

void RenderOnly(Session& session, const std::vector<vtkProp*>& props)
{
  vtkNew<OracleCuller> culler;
  culler->SetProps(&props);
  session.SetCuller(culler);
  session.Render();
  session.SetCuller();
}

} // namespace NBufferBench
