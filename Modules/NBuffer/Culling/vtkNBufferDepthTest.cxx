// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDepthTest.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferCompatibility.h"
#include "vtkNBufferForEachProp.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"
#include "vtkNBufferSharedDepth.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// If the pixels are not in host memory yet, reading them is worth its cost for at least this many
/// candidates.
constexpr std::size_t CandidatesWorthARead = 32;

/// The number of props that is worth a thread of its own in the tests of pixels and slivers.
constexpr vtkIdType PropsPerThread = 800;

template <typename Predicate>
void RemoveIf(std::vector<int>& places, Predicate&& predicate)
{
  places.erase(
    std::remove_if(places.begin(), places.end(), std::forward<Predicate>(predicate)), places.end());
}
}

void vtkNBufferSettings::Share(const std::shared_ptr<vtkNBufferSharedDepth>& shared)
{
  this->Shared = shared;
  if (shared)
  {
    const vtkNBufferSharedDepth::Layout& layout = shared->GetLayout();
    this->BaseFactor = layout.TileSize;
    this->RoundSize = std::max(this->RoundSize / layout.Ranks, 1);
    this->BackOff = false;
    this->MinimumNumberOfCandidates =
      std::max(this->MinimumNumberOfCandidates - shared->GetOtherCandidates(), 1);
  }
}

void vtkNBufferSettings::ReportUntested(const vtkNBufferStatistics& statistics) const
{
  if (this->Shared && statistics.Decision != vtkNBufferDecision::Culled)
  {
    this->Shared->GetReport().Candidates = statistics.GetCount(vtkNBufferVerdict::Untested);
  }
}

double vtkNBufferSettings::GetStep(const vtkNBufferDepthSource& source) const
{
  return std::max(source.GetStep(), this->Shared ? this->Shared->GetStep() : 0.0);
}

void vtkNBufferDepthTest::FindDrawnRows(vtkRenderer* renderer)
{
  const int height = this->Source.Viewport[3];
  this->Rows.Begin = 0;
  this->Rows.End = height;
  if (!vtkNBufferCompatibility::ErasesDepth(renderer))
  {
    return;
  }
  int first = height;
  int end = 0;
  for (int i = 0; i < this->Props.GetSize() && (first > 0 || end < height); ++i)
  {
    const vtkNBufferVerdict verdict = this->Props.GetState(i).Verdict;
    if (verdict == vtkNBufferVerdict::Outside || verdict == vtkNBufferVerdict::Unknown ||
      verdict == vtkNBufferVerdict::Hidden || verdict == vtkNBufferVerdict::Translucent)
    {
      continue;
    }
    const vtkNBufferScreenBox* screen =
      verdict == vtkNBufferVerdict::Visible ? this->GetScreen(i) : nullptr;
    if (!screen)
    {
      return;
    }
    first = std::min(first, screen->Pixels.Y0);
    end = std::max(end, screen->Pixels.Y1);
  }
  this->Rows.Begin = std::clamp(first, 0, height);
  this->Rows.End = std::clamp(end, this->Rows.Begin, height);
}

vtkNBufferDecision vtkNBufferDepthTest::Build(vtkRenderer* renderer,
  const vtkNBufferDepthSource& source, std::initializer_list<const std::vector<int>*> places,
  int levels, const std::function<int()>& countHiddenUnits, std::string& why)
{
  this->Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->Source = source;
  this->FindDrawnRows(renderer);
  this->SampleDistance = source.Places.GetDistanceFromMiddle();
  for (const std::vector<int>* list : places)
  {
    for (int i : *list)
    {
      // A candidate with a stale rectangle needs no more levels than the nodes above it.
      if (!this->Props.GetState(i).RectangleIsStale)
      {
        levels = std::max(levels,
          vtkNBufferOcclusionTest::GetLevelsNeeded(
            this->Props.GetScreen(i).Pixels, this->Settings.BaseFactor));
      }
    }
  }
  levels = std::max(levels, this->Props.GetLevelsNeeded(this->Settings.BaseFactor));
  this->Backend.SetAllowFloatTextures(this->Settings.AllowFloatTextures);
  // Each rank's picture is composited by the depth that is in the window's framebuffer at the end.
  // VTK's compositors do not know reversed depth.
  const bool isShared = this->Settings.Shared && source.Samples <= 1 &&
    source.Stored == vtkNBufferStoredDepth::Ordinary &&
    source.Framebuffer == this->Window->GetRenderFramebuffer()->GetFBOIndex();
  const bool isTrial = isShared && this->Settings.Shared->IsTrial();
  const vtkNBufferDecision failure = this->Backend.Build(
    this->Settings.Backend, this->GetJob(isShared && !isTrial ? 1 : levels), why);
  if (failure == vtkNBufferDecision::None && isShared)
  {
    this->Settings.Shared->GetReport().Step = source.GetStep();
    const int hiddenByOwn = isTrial ? this->CountHidden(places) + countHiddenUnits() : 0;
    this->Backend.Merge([this](vtkNBufferLevels& base)
      { return this->Settings.Shared->Merge(base); },
      this->GetJob(levels));
    if (isTrial)
    {
      this->Settings.Shared->SetTrial(hiddenByOwn, this->CountHidden(places) + countHiddenUnits());
    }
  }
  return failure;
}

void vtkNBufferDepthTest::SetCounts(int candidates, int newProps)
{
  if (this->Settings.Shared)
  {
    vtkNBufferRankReport& report = this->Settings.Shared->GetReport();
    report.Candidates = candidates;
    report.NewProps = newProps;
  }
}

int vtkNBufferDepthTest::CountHidden(std::initializer_list<const std::vector<int>*> places)
{
  const vtkNBufferStatistics before = this->Statistics;
  const vtkNBufferClock clock;
  std::size_t hidden = 0;
  for (const std::vector<int>* list : places)
  {
    std::vector<int> left = *list;
    this->RemoveBehind(left);
    hidden += list->size() - left.size();
  }
  this->Statistics = before;
  this->Statistics.TestTime += clock.GetMilliseconds();
  return static_cast<int>(hidden);
}

vtkNBufferDividedProp::Depth vtkNBufferDepthTest::GetDepthOfUnits()
{
  const bool isAtHand =
    this->Settings.TestPixels && this->Backend.GetInUse() == vtkNBufferBackend::CPU;
  return { this->Levels, isAtHand ? this->Backend.GetDepth(this->GetJob(1), {}) : nullptr,
    this->SampleDistance,
    [this] { return this->Backend.GetTexture(this->GetJob(this->Levels.GetNumberOfLevels())); } };
}

const vtkNBufferScreenBox* vtkNBufferDepthTest::GetScreen(int i)
{
  // GetScreen() may set the placement.
  const vtkNBufferScreenBox& screen = this->Props.GetScreen(i);
  return this->Props.GetState(i).Placement == vtkNBufferPlacement::Inside ? &screen : nullptr;
}

const float* vtkNBufferDepthTest::GetDepth(const std::vector<int>& places)
{
  // With the OpenGL back-end this is a second read-back, which has to be worth its cost.
  const bool reads = this->Backend.GetInUse() == vtkNBufferBackend::OpenGL;
  if (!this->Settings.TestPixels || places.empty() ||
    (reads && places.size() < CandidatesWorthARead))
  {
    return nullptr;
  }
  std::vector<vtkNBufferRectangle> rectangles;
  if (reads)
  {
    for (int i : places)
    {
      if (const vtkNBufferScreenBox* screen = this->GetScreen(i))
      {
        rectangles.push_back(screen->GetSampled(this->SampleDistance));
      }
    }
  }
  return this->Backend.GetDepth(this->GetJob(1), rectangles);
}

bool vtkNBufferDepthTest::MayBeInFront(
  const vtkNBufferFaceTest& faceTest, const vtkNBufferFaces::Piece& piece)
{
  vtkNBufferScreenBox screen;
  const vtkNBufferPlacement placement = this->Props.GetProjection().Project(piece.GetBox(), screen);
  if (placement != vtkNBufferPlacement::Inside)
  {
    return placement == vtkNBufferPlacement::Crossing;
  }
  const double clearance =
    vtkNBufferOcclusionTest(this->Levels, this->SampleDistance).GetClearance(screen);
  return !(clearance > 0.0) ||
    (!std::isinf(clearance) && faceTest.MayBeInFront(this->Props.GetFaces(), piece, clearance));
}

vtkNBufferDepthTest::Slivers vtkNBufferDepthTest::FindSlivers(
  int i, const vtkNBufferFaceTest& faceTest, const vtkNBufferSliverTest& sliverTest)
{
  const auto clearance = std::max<double>(this->Props.GetState(i).Clearance, 0.0);
  const vtkNBufferFaces& faces = this->Props.GetFaces();
  const vtkNBufferFaces::OfProp& ofProp = this->Props.GetFaces(i);
  for (unsigned int place = ofProp.Begin; place < ofProp.End; ++place)
  {
    const vtkNBufferFaces::Piece& piece = faces.GetPieces()[place];
    if (!faceTest.MayBeInFront(faces, piece, clearance) || !this->MayBeInFront(faceTest, piece))
    {
      continue;
    }
    const std::vector<vtkNBufferMeshes::Placed>& meshes = this->Props.GetMeshes(i);
    if (meshes.empty())
    {
      return Slivers::Unknown;
    }
    // The rectangle is calculated now if only a node above the prop was found hidden so far.
    const vtkNBufferScreenBox* screen = this->GetScreen(i);
    if (!screen || screen->GetSampled(this->SampleDistance).IsEmpty())
    {
      return Slivers::Hidden;
    }
    const vtkNBufferMeshes::Placed& mesh = meshes[piece.Mesh];
    if (sliverTest.MayBeSeen(*mesh.Mesh, piece.Triangle,
          piece.Triangle + vtkNBufferFaces::TrianglesOfPiece, mesh.ToWorld.data(),
          this->Props.GetBox(i), *screen))
    {
      return Slivers::Visible;
    }
  }
  return Slivers::Hidden;
}

void vtkNBufferDepthTest::PutBackSlivers(const std::vector<int>& tested, std::vector<int>& places)
{
  if (tested.size() <= places.size())
  {
    return;
  }
  const vtkNBufferClock clock;
  const vtkNBufferFaceTest faceTest(this->Props.GetProjection(), this->Source.Places);
  const vtkNBufferSliverTest sliverTest(
    this->Props.GetProjection(), this->Levels, this->GetDepthOfUnits().Pixels, this->Source.Places);
  std::vector<Slivers> slivers(tested.size(), Slivers::Hidden);
  auto left = places.begin();
  for (std::size_t n = 0; n < tested.size() && left != places.end(); ++n)
  {
    if (*left == tested[n])
    {
      slivers[n] = Slivers::Visible;
      ++left;
    }
  }
  vtkNBufferForEachProp::RunEach(
    tested.size(),
    [&](vtkIdType n)
    {
      // A box without samples has an infinite clearance.
      if (slivers[n] == Slivers::Hidden && !std::isinf(this->Props.GetState(tested[n]).Clearance))
      {
        slivers[n] =
          this->Props.GetFaces(tested[n]).Limit == this->Settings.MinimumNumberOfPrimitives
          ? this->FindSlivers(tested[n], faceTest, sliverTest)
          : Slivers::Unknown;
      }
    },
    PropsPerThread);
  if (std::find(slivers.begin(), slivers.end(), Slivers::Unknown) != slivers.end())
  {
    vtkNBufferForEachProp::RunInOneThread(
      [&]()
      {
        for (std::size_t n = 0; n < tested.size(); ++n)
        {
          if (slivers[n] == Slivers::Unknown)
          {
            this->Props.ReadTriangles(tested[n], this->Settings.MinimumNumberOfPrimitives);
            slivers[n] = this->FindSlivers(tested[n], faceTest, sliverTest);
          }
        }
      });
    this->Props.ReleaseUnusedFaces();
  }
  std::vector<int> visible;
  for (std::size_t n = 0; n < tested.size(); ++n)
  {
    if (slivers[n] == Slivers::Visible)
    {
      visible.push_back(tested[n]);
    }
  }
  this->Statistics.Slivers += static_cast<int>(visible.size() - places.size());
  places.swap(visible);
  this->Statistics.SliverTestTime += clock.GetMilliseconds();
}

int vtkNBufferDepthTest::RemoveHidden(std::vector<int>& places)
{
  const bool testsSlivers = this->Settings.TestSlivers && vtkNBufferGL::DrawsStraySamples();
  const std::vector<int> tested = testsSlivers ? places : std::vector<int>();
  const int passed = this->RemoveBehind(places);
  this->PutBackSlivers(tested, places);
  return passed;
}

bool vtkNBufferDepthTest::IsHidden(const vtkNBufferContact& contact)
{
  if (vtkNBufferOcclusionTest(this->Levels, this->SampleDistance).IsHidden(contact.Screen))
  {
    return true;
  }
  const float* depth = this->GetDepthOfUnits().Pixels;
  return depth &&
    vtkNBufferPixelTest(this->Props.GetProjection(), this->Levels, depth, this->SampleDistance)
      .IsHidden(contact.Box, contact.Screen);
}

int vtkNBufferDepthTest::RemoveBehind(std::vector<int>& places)
{
  vtkNBufferClock clock;
  vtkNBufferOcclusionTest test(this->Levels, this->SampleDistance);
  this->Props.MarkHidden(test);
  RemoveIf(places,
    [&](int i)
    {
      // A prop below a hidden node need not be projected.
      float& clearance = this->Props.GetState(i).Clearance;
      const vtkNBufferScreenBox* screen = clearance > 0.0F ? nullptr : this->GetScreen(i);
      if (screen)
      {
        clearance = static_cast<float>(test.GetClearance(*screen));
      }
      return clearance > 0.0F;
    });
  this->Statistics.Queries += test.GetQueries();
  this->Statistics.Lookups += test.GetLookups();
  const auto passed = static_cast<int>(places.size());
  this->Statistics.TestTime += clock.Restart();

  if (const float* depth = this->GetDepth(places))
  {
    clock.Restart();
    this->RemoveBehindPixels(places, depth);
    this->Statistics.PixelTestTime += clock.GetMilliseconds();
  }
  return passed;
}

void vtkNBufferDepthTest::RemoveBehindPixels(std::vector<int>& places, const float* depth)
{
  std::vector<unsigned char> isHidden(places.size(), 0);
  std::atomic<int> hiddenByTriangles{ 0 };
  std::atomic<long long> lookups{ 0 };
  const bool triangles = this->Settings.TestTriangles;
  const auto test = [&](std::size_t begin, std::size_t end)
  {
    vtkNBufferPixelTest pixelTest(
      this->Props.GetProjection(), this->Levels, depth, this->SampleDistance);
    for (std::size_t n = begin; n < end; ++n)
    {
      const int i = places[n];
      const auto mayBeSeen = [&](std::size_t count, bool otherwise) {
        return triangles ? this->Props.MayBeSeen(i, pixelTest, count).value_or(otherwise)
                         : otherwise;
      };
      const vtkNBufferScreenBox* screen = this->GetScreen(i);
      // Most props that were visible are visible again, with the same triangle. That a triangle
      // that reaches behind the eye may be seen says nothing.
      const bool wasVisible = this->Props.GetState(i).WasVisible;
      if (!screen || (wasVisible && !screen->Clipped && mayBeSeen(1, false)))
      {
        continue;
      }
      const bool isBehind = pixelTest.IsHidden(this->Props.GetBox(i), *screen);
      isHidden[n] = isBehind || !mayBeSeen(std::numeric_limits<std::size_t>::max(), true);
      hiddenByTriangles += isHidden[n] && !isBehind;
    }
    lookups += pixelTest.GetLookups();
  };
  if (triangles)
  {
    this->Props.CopyTriangles(places);
  }
  vtkNBufferForEachProp::Run(places.size(), test, PropsPerThread);
  auto hidden = isHidden.begin();
  RemoveIf(places, [&](int) { return *hidden++ != 0; });
  this->Statistics.HiddenByTriangles += hiddenByTriangles;
  this->Statistics.Lookups += lookups;
}
VTK_ABI_NAMESPACE_END
