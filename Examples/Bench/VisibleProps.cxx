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

std::vector<std::vector<vtkProp*>> FindVisibleProps(Session& session,
  const NBufferExamples::CameraPath& path, const std::function<void(std::size_t)>& progress)
{
  vtkRenderer* renderer = session.GetRenderer();
  renderer->GetCullers()->RemoveAllItems();
  vtkNew<vtkFrustumCoverageCuller> frustum;
  renderer->AddCuller(frustum);

  std::unordered_map<vtkProp*, std::size_t> order;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    order.emplace(prop, order.size());
  }

  const int* size = session.GetWindow()->GetActualSize();
  const auto pixels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(
    0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetActorPassOnly(true);

  std::vector<std::vector<vtkProp*>> visible(path.size());
  for (std::size_t frame = 0; frame < path.size(); ++frame)
  {
    session.SetPose(path[frame]);
    const unsigned char* rgb = nullptr;
    if (selector->CaptureBuffers())
    {
      rgb = selector->GetPixelBuffer(vtkHardwareSelector::ACTOR_PASS);
    }
    if (!rgb)
    {
      throw std::runtime_error("the props that own a pixel could not be found: no selection");
    }
    std::vector<char> found(order.size() + 1, 0);
    for (std::size_t i = 0; i < pixels; ++i)
    {
      // 0 is the background, and a prop is its index plus one.
      const std::size_t id = rgb[3 * i] | rgb[3 * i + 1] << 8 | rgb[3 * i + 2] << 16;
      found[std::min(id, order.size())] = 1;
    }
    for (std::size_t id = 1; id < found.size(); ++id)
    {
      vtkProp* prop = found[id] ? selector->GetPropFromID(static_cast<int>(id - 1)) : nullptr;
      if (prop)
      {
        visible[frame].push_back(prop);
      }
    }
    std::sort(visible[frame].begin(), visible[frame].end(),
      [&order](vtkProp* a, vtkProp* b) { return order.at(a) < order.at(b); });
    if (progress)
    {
      progress(frame);
    }
  }
  return visible;
}

} // namespace NBufferBench
