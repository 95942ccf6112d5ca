// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SameList.h"

#include "CompositeMapper.h"
#include "VisibleProps.h"
#include "vtkNBufferProtectedBlocks.h"

#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace NBufferBench
{
using vtkNBufferProtectedMembers::BlockMap;
using vtkNBufferProtectedMembers::GetBlockList;

/// Exchanges the list of blocks that a mapper draws, as vtkNBufferBlockStream does. In the property
/// keys of an actor it is called before each draw.
class BlockListPass : public vtkOpenGLRenderPass
{
public:
  static BlockListPass* New();
  vtkTypeMacro(BlockListPass, vtkOpenGLRenderPass);

  /// The blocks of the next draws, and the number of their list.
  void SetBlocks(std::size_t number, const std::set<unsigned int>* blocks)
  {
    this->Number = number;
    this->Blocks = blocks;
  }

  void Render(const vtkRenderState*) override {}

  bool SetShaderParameters(
    vtkShaderProgram*, vtkAbstractMapper* mapper, vtkProp*, vtkOpenGLVertexArrayObject*) override
  {
    this->Restore();
    if (!GetBlockList(mapper).Blocks || !this->Blocks)
    {
      return true;
    }
    const BlockMap& all = *GetBlockList(mapper).Blocks;
    const auto [entry, isNew] = this->Parts.try_emplace({ this->Number, mapper });
    for (auto block = all.begin(); isNew && block != all.end(); ++block)
    {
      if (this->Blocks->count(vtkNBufferProtectedMembers::GetFlatIndex(*block)) > 0)
      {
        entry->second.insert(*block);
      }
    }
    this->Changed = mapper;
    this->Exchanged = &entry->second;
    this->Exchanged->swap(*GetBlockList(mapper).Blocks);
    this->Observer = mapper->AddObserver(vtkCommand::ProgressEvent, this, &BlockListPass::Restore);
    return true;
  }

protected:
  ~BlockListPass() override { this->Restore(); }

private:
  void Restore()
  {
    if (this->Changed)
    {
      this->Exchanged->swap(*GetBlockList(this->Changed).Blocks);
      this->Changed->RemoveObserver(this->Observer);
      this->Changed = nullptr;
    }
  }

  std::size_t Number = 0;
  const std::set<unsigned int>* Blocks = nullptr;
  /// What a mapper of blocks draws of a list, by the number of the list. The mapper is static, so
  /// that its blocks stay the same.
  std::map<std::pair<std::size_t, vtkAbstractMapper*>, BlockMap> Parts;
  vtkSmartPointer<vtkAbstractMapper> Changed;
  BlockMap* Exchanged = nullptr;
  unsigned long Observer = 0;
};
vtkStandardNewMacro(BlockListPass);

namespace
{
bool IsDrawn(vtkNBufferVerdict verdict)
{
  return verdict != vtkNBufferVerdict::Unknown && verdict != vtkNBufferVerdict::Outside &&
    verdict != vtkNBufferVerdict::Hidden;
}

vtkMultiBlockDataSet* GetBlocks(vtkActor* actor)
{
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  return mapper && vtkNBufferProtectedMembers::HasBlockLists(mapper)
    ? vtkMultiBlockDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
}
}

SameList::SameList() = default;
SameList::~SameList() = default;

void SameList::AddCopy(vtkActor* actor)
{
  auto* original = static_cast<CompositeMapper*>(actor->GetMapper());
  vtkNew<CompositeMapper> mapper;
  mapper->SetCompositeDataDisplayAttributes(original->GetCompositeDataDisplayAttributes());
  mapper->SetInputDataObject(GetBlocks(actor));
  mapper->SetStatic(true);
  Copy copy;
  copy.Actor = vtkSmartPointer<vtkActor>::New();
  copy.Actor->ShallowCopy(actor);
  copy.Actor->SetMapper(mapper);
  copy.Pass = vtkSmartPointer<BlockListPass>::New();
  vtkNew<vtkInformation> keys;
  copy.Actor->SetPropertyKeys(keys);
  vtkOpenGLRenderPass::RenderPasses()->Append(keys, copy.Pass);
  this->Copies.emplace(actor, std::move(copy));
}

void SameList::AddLists(vtkNBufferCuller* culler)
{
  for (auto& [prop, copy] : this->Copies)
  {
    copy.Lists.emplace_back();
    const unsigned int count = GetBlocks(copy.Actor)->GetNumberOfBlocks();
    // The root has flat index 0.
    for (unsigned int flatIndex = 1; flatIndex <= count; ++flatIndex)
    {
      if (IsDrawn(culler->GetVerdict(prop, static_cast<int>(flatIndex))))
      {
        copy.Lists.back().insert(flatIndex);
      }
    }
  }
}

std::vector<std::vector<vtkProp*>> SameList::Record(
  Session& session, const NBufferExamples::CameraPath& path, const std::string& backend)
{
  const std::vector<vtkProp*> props = session.GetProps();
  for (vtkProp* prop : props)
  {
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    if (GetBlocks(actor))
    {
      this->AddCopy(actor);
    }
  }
  if (this->Copies.empty())
  {
    throw std::runtime_error("mode same-list draws lists of blocks, but there is no composite data "
                             "of which lists can be drawn; --merge composite makes it");
  }
  Mode mode("nbuffer", backend);
  vtkNBufferCuller* culler = mode.GetNBufferCuller();
  mode.Enter(session.GetRenderer());
  const auto render = [&](std::size_t frame)
  {
    session.SetPose(path[frame]);
    session.Render();
  };
  // The units are made in the background, and the first tests know little of the view.
  constexpr int patience = 30;
  constexpr int tests = 10;
  for (int frame = 0, tested = 0; frame < patience && tested < tests; ++frame)
  {
    render(0);
    tested += culler->GetStatistics().Units > 0;
  }
  std::vector<std::vector<vtkProp*>> drawn(path.size());
  for (std::size_t frame = 0; frame < path.size(); ++frame)
  {
    render(frame);
    this->AddLists(culler);
    for (vtkProp* prop : props)
    {
      if (IsDrawn(culler->GetVerdict(prop)))
      {
        const auto found = this->Copies.find(prop);
        drawn[frame].push_back(found == this->Copies.end() ? prop : found->second.Actor);
      }
    }
    ShowProgress("recording what nbuffer draws: frame " + std::to_string(frame + 1) + " of " +
      std::to_string(path.size()));
  }
  mode.Leave(session.GetRenderer());
  for (std::size_t frame = 0; frame < path.size(); ++frame)
  {
    this->SetFrame(frame);
    session.SetPose(path[frame]);
    RenderOnly(session, drawn[frame]);
  }
  return drawn;
}

void SameList::SetFrame(std::size_t frame)
{
  for (auto& [prop, copy] : this->Copies)
  {
    copy.Pass->SetBlocks(frame, &copy.Lists[frame]);
  }
}

std::vector<double> SameList::CountBlocks() const
{
  std::vector<double> counts;
  for (const auto& [prop, copy] : this->Copies)
  {
    counts.resize(copy.Lists.size());
    for (std::size_t frame = 0; frame < counts.size(); ++frame)
    {
      counts[frame] += static_cast<double>(copy.Lists[frame].size());
    }
  }
  return counts;
}

} // namespace NBufferBench
