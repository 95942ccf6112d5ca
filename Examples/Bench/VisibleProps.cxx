// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleProps.h"

#include "vtkCullerCollection.h"
#include "vtkDataObject.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkHardwareSelector.h"
#include "vtkPropCollection.h"

#include <algorithm>
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
    vtkRenderer* renderer = session.GetRenderer();
    renderer->GetCullers()->RemoveAllItems();
    vtkNew<vtkFrustumCoverageCuller> frustum;
    renderer->AddCuller(frustum);
    vtkPropCollection* props = renderer->GetViewProps();
    vtkCollectionSimpleIterator iterator;
    props->InitTraversal(iterator);
    while (vtkProp* prop = props->GetNextProp(iterator))
    {
      this->Order.emplace(prop, this->Order.size());
    }
    const int* size = session.GetWindow()->GetActualSize();
    this->Pixels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
    this->Selector->SetRenderer(renderer);
    this->Selector->SetArea(
      0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
    this->Selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    this->Selector->SetActorPassOnly(true);
  }

  /// Of every pixel 0 for the background, or a number for GetProp().
  std::vector<std::size_t> Find(const NBufferExamples::CameraPose& pose)
  {
    this->Where.SetPose(pose);
    const unsigned char* rgb = nullptr;
    if (this->Selector->CaptureBuffers())
    {
      rgb = this->Selector->GetPixelBuffer(vtkHardwareSelector::ACTOR_PASS);
    }
    if (!rgb)
    {
      throw std::runtime_error("the props that own a pixel could not be found: no selection");
    }
    std::vector<std::size_t> ids(this->Pixels);
    for (std::size_t i = 0; i < this->Pixels; ++i)
    {
      // 0 is the background, and a prop is its index plus one.
      const std::size_t id = rgb[3 * i] | rgb[3 * i + 1] << 8 | rgb[3 * i + 2] << 16;
      ids[i] = std::min(id, this->Order.size());
    }
    return ids;
  }

  vtkProp* GetProp(std::size_t id)
  {
    return id > 0 ? this->Selector->GetPropFromID(static_cast<int>(id - 1)) : nullptr;
  }

  std::size_t GetNumberOfProps() const { return this->Order.size(); }
  std::size_t GetPlace(vtkProp* prop) const { return this->Order.at(prop); }

private:
  Session& Where;
  vtkNew<vtkHardwareSelector> Selector;
  std::unordered_map<vtkProp*, std::size_t> Order;
  std::size_t Pixels = 0;
};
}

std::vector<std::vector<vtkProp*>> FindVisibleProps(Session& session,
  const NBufferExamples::CameraPath& path, const std::function<void(std::size_t)>& progress)
{
  Finder finder(session);
  std::vector<std::vector<vtkProp*>> visible(path.size());
  for (std::size_t frame = 0; frame < path.size(); ++frame)
  {
    std::vector<char> found(finder.GetNumberOfProps() + 1, 0);
    for (std::size_t id : finder.Find(path[frame]))
    {
      found[id] = 1;
    }
    for (std::size_t id = 1; id < found.size(); ++id)
    {
      vtkProp* prop = found[id] ? finder.GetProp(id) : nullptr;
      if (prop)
      {
        visible[frame].push_back(prop);
      }
    }
    std::sort(visible[frame].begin(), visible[frame].end(),
      [&finder](vtkProp* a, vtkProp* b) { return finder.GetPlace(a) < finder.GetPlace(b); });
    if (progress)
    {
      progress(frame);
    }
  }
  return visible;
}

std::vector<int> FindPixelOwners(Session& session, const NBufferExamples::CameraPose& pose)
{
  Finder finder(session);
  std::vector<int> places(finder.GetNumberOfProps() + 1, -2);
  std::vector<int> owners;
  for (std::size_t id : finder.Find(pose))
  {
    int& place = places[id];
    if (place == -2)
    {
      vtkProp* prop = finder.GetProp(id);
      place = prop ? static_cast<int>(finder.GetPlace(prop)) : -1;
    }
    owners.push_back(place);
  }
  return owners;
}

} // namespace NBufferBench
