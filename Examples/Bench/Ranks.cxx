// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks.h"

#include "CoverageMask.h"
#include "Scene.h"

#include "vtkNBufferCuller.h"
#include "vtkNBufferDepthExchange.h"
#include "vtkNBufferExchangeMessage.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRendererCollection.h"

#include <algorithm>

namespace NBufferBench
{
namespace
{
/// The rounds until the counts stay nearly the same. A real exchange needs fewer: here a rank
/// learns what the others have drawn a round later.
constexpr int Rounds = 16;

/// What all ranks have sent in this round and in the round before.
struct Messages
{
  std::vector<float> Before;
  std::vector<float> Now;
  CoverageMask MaskBefore;
  CoverageMask MaskNow;
};

void Minimize(std::vector<float>& minima, const std::vector<float>& values)
{
  minima.resize(std::max(minima.size(), values.size()), 2.0e9F);
  std::transform(values.begin(), values.end(), minima.begin(), minima.begin(),
    [](float a, float b) { return std::min(a, b); });
}

/// Answers each exchange with the depth of the other ranks in the round before.
class SimulatedExchange : public vtkNBufferDepthExchange
{
public:
  static SimulatedExchange* New();
  vtkTypeMacro(SimulatedExchange, vtkNBufferDepthExchange);

  int GetNumberOfRanks() override { return this->Ranks; }
  int GetRank() override { return this->Rank; }
  bool ReduceToMinimum(const float* values, float* minima, int count) override
  {
    std::vector<float> mine(values, values + count);
    std::vector<float> result = mine;
    constexpr int AgreementSize = 8; // The message in which ranks agree on sizes.
    if (count > AgreementSize)
    {
      if (this->Width > 0)
      {
        const CoverageMask mask(mine.data(), this->Width, this->Height);
        this->All->MaskNow.Merge(mask);
        this->All->MaskBefore.Apply(result.data());
        std::fill_n(mine.begin(), static_cast<std::size_t>(this->Width) * this->Height, 1.0F);
      }
      Minimize(this->All->Now, mine);
      if (!this->All->Before.empty())
      {
        Minimize(result, this->All->Before);
      }
      // Exchanges would stop while nothing moves. They go on if a rank reports changes.
      const std::size_t report = vtkNBufferExchangeMessage(0, this->Ranks, 0).GetValues().size();
      vtkNBufferExchangeMessage changed(count - report, this->Ranks, this->Rank);
      vtkNBufferRankReport change;
      std::copy_n(values + (count - report), change.View.size(), change.View.begin());
      change.Changed = true;
      changed.SetReport(change);
      Minimize(result, changed.GetValues());
    }
    std::copy(result.begin(), result.end(), minima);
    return true;
  }

  Messages* All = nullptr;
  int Ranks = 1;
  int Rank = 0;
  int Width = 0; ///< The size of the image if coverage masks are sent, else 0.
  int Height = 0;
};
vtkStandardNewMacro(SimulatedExchange);

/// One rank: a renderer of the window that is drawn alone, and its culler.
struct Rank
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkNBufferCuller> Culler;
  vtkNew<SimulatedExchange> Exchange;

  /// The props that were drawn, or the units if the mesh is divided.
  int GetDrawn()
  {
    const vtkNBufferStatistics& statistics = this->Culler->GetStatistics(this->Renderer);
    return statistics.Units > 0 ? statistics.UnitsKept + statistics.UnitsFresh
                                : this->Renderer->GetNumberOfPropsRendered();
  }
};

/// Replaces the props of a renderer by one mesh, which its culler divides at once.
void MergeProps(Rank& rank)
{
  NBufferExamples::Scene part;
  vtkPropCollection* props = rank.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    part.Actors.emplace_back(static_cast<vtkActor*>(props->GetItemAsObject(i)));
  }
  if (part.Actors.empty())
  {
    return;
  }
  part.Merge(false);
  rank.Renderer->RemoveAllViewProps();
  rank.Renderer->AddViewProp(part.Actors.front());
  vtkNBufferTuning tuning = rank.Culler->GetTuning();
  tuning.MinimumNumberOfPrimitives = 2;
  tuning.DivideAfter = 0;
  tuning.DivideInBackground = false;
  tuning.ReuseWhenStill = false; // A culler does not begin to test units while nothing moves.
  // A mesh that is drawn whole would count as one unit.
  tuning.MinimumNumberOfCandidates = 1;
  tuning.BackOff = false;
  rank.Culler->SetTuning(tuning);
}

/// Draws a frame of each rank. The window has the renderer of one rank at a time: VTK takes longer
/// to pass over a thousand others than to draw one.
void DrawRound(Session& session, std::vector<Rank>& ranks)
{
  vtkRendererCollection* renderers = session.GetWindow()->GetRenderers();
  for (Rank& rank : ranks)
  {
    renderers->AddItem(rank.Renderer);
    session.Render();
    renderers->RemoveItem(rank.Renderer);
  }
}
}

RankCounts SimulateRanks(Session& session, const NBufferExamples::CameraPose& pose, int count,
  const std::vector<int>& rankOf, const std::vector<int>& owners, int tileSize, bool mask,
  bool merge)
{
  session.SetPose(pose);
  vtkRenderer* all = session.GetRenderer();
  all->DrawOff();
  const std::vector<vtkProp*> props = session.GetProps();
  std::vector<Rank> ranks(count);
  Messages messages;
  RankCounts result;
  for (int i = 0; i < count; ++i)
  {
    ranks[i].Renderer->SetActiveCamera(all->GetActiveCamera());
    ranks[i].Renderer->AddCuller(ranks[i].Culler);
    ranks[i].Exchange->All = &messages;
    ranks[i].Exchange->Ranks = count;
    ranks[i].Exchange->Rank = i;
    ranks[i].Exchange->BackOffOff();
    ranks[i].Exchange->SetTileSize(mask ? 1 : tileSize);
    if (mask)
    {
      ranks[i].Exchange->Width = session.GetWindow()->GetSize()[0];
      ranks[i].Exchange->Height = session.GetWindow()->GetSize()[1];
    }
    session.GetWindow()->AddRenderer(ranks[i].Renderer);
    session.GetWindow()->GetRenderers()->RemoveItem(ranks[i].Renderer);
  }
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    ranks[rankOf[i]].Renderer->AddViewProp(props[i]);
  }
  for (Rank& rank : ranks)
  {
    if (merge)
    {
      MergeProps(rank);
    }
  }
  for (int round = 0; round < (merge ? Rounds : 3); ++round)
  {
    DrawRound(session, ranks);
  }
  for (Rank& rank : ranks)
  {
    result.Local += rank.GetDrawn();
    rank.Exchange->SetRenderer(rank.Renderer);
    rank.Culler->SetDepthExchange(rank.Exchange);
  }
  for (int round = 0; round < Rounds && count > 1; ++round)
  {
    messages.Before.swap(messages.Now);
    messages.Now.clear();
    messages.MaskBefore = messages.MaskNow;
    messages.MaskNow = CoverageMask();
    DrawRound(session, ranks);
  }
  for (Rank& rank : ranks)
  {
    const int drawn = rank.GetDrawn();
    result.Shared += drawn;
    result.Busiest = std::max(result.Busiest, drawn);
    result.Idle += drawn == 0 ? 1 : 0;
    result.Bytes = std::max(result.Bytes, rank.Exchange->GetNumberOfBytes());
  }
  for (int owner : owners)
  {
    Rank& rank = ranks[rankOf[owner]];
    vtkProp* prop = merge ? rank.Renderer->GetViewProps()->GetLastProp() : props[owner];
    const vtkNBufferVerdict verdict = rank.Culler->GetVerdict(prop, rank.Renderer);
    result.VisibleHidden += verdict == vtkNBufferVerdict::Hidden ? 1 : 0;
  }
  for (Rank& rank : ranks)
  {
    session.GetWindow()->RemoveRenderer(rank.Renderer);
  }
  all->DrawOn();
  return result;
}

} // namespace NBufferBench
