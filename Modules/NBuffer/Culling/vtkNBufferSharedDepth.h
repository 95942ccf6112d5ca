// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSharedDepth
 * @brief The depth that all ranks of a parallel program have drawn of a renderer, as far as one
 * rank knows it; and that the rank joins every exchange.
 *
 * In each frame of the renderer:
 *
 *     BeginFrame()    plans the number of exchanges (vtkNBufferExchangePlan)
 *     the culler      Poll(): joins the poll, if there is one, before anything is drawn.
 *                     Merge() after each level 0 that it builds: joins an exchange if one is left,
 *                     and makes level 0 the minimum of the rank's own depth and that of all ranks
 *     EndFrame()      joins the poll and the exchanges that are left. A rank without a culler,
 *                     without props, or whose culler does not test this frame joins all of them
 *                     here, with the depth of its finished picture, or the far plane where depth
 *                     cannot be read
 *
 * What an exchange has brought is used until the end of the frame: all depths only get nearer. It
 * is not used where ranks have different views, or another rank has coarser depth than was assumed
 * when the boxes were placed; that depth is then assumed from the next frame on.
 *
 * ## When the verdicts of the last frame are still valid
 *
 * They are if the depth of no rank has become farther since the last exchange. A rank can tell that
 * of its own depth if its culler says so, or if all that it gave to that exchange was the far
 * plane. If all ranks can tell (in the poll), nothing is exchanged.
 *
 * ## Layouts
 *
 * All messages of an exchange must have the same size. Before the first exchange the ranks agree on
 * their layout, which is the size of level 0 and the settings. A rank whose layout changes after
 * that, alone or together with the others, still sends a message of the size that was agreed on,
 * which says so; then all ranks agree anew in the same frame.
 */
#ifndef vtkNBufferSharedDepth_h
#define vtkNBufferSharedDepth_h

#include "vtkNBufferBackend.h"
#include "vtkNBufferExchangeMessage.h"
#include "vtkNBufferExchangePlan.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

class vtkNBufferSharedDepth
{
public:
  /// Writes the minima over all ranks of so many floats; see vtkNBufferDepthExchange.
  using Reduction = std::function<bool(const float* values, float* minima, int count)>;

  /// What must be the same on all ranks, except for Rank.
  struct Layout
  {
    int Ranks = 1;
    int Rank = 0;
    int TileSize = 4; ///< The side in pixels of a texel of level 0.
    bool BackOff = true;
  };

  /// What happened in the last frame that is over.
  struct Counts
  {
    int Exchanges = 0;
    long long Bytes = 0; ///< The size of this rank's messages.
    double Time = 0.0;   ///< The milliseconds in them, most of them for waiting for other ranks.
  };

  explicit vtkNBufferSharedDepth(Reduction reduction)
    : Reduce(std::move(reduction))
  {
  }

  /// Begin a frame of the renderer unless it has begun already.
  void BeginFrame(vtkRenderer* renderer, const Layout& layout);

  /// Whether this frame has exchanges, as far as is known.
  bool IsShared() const { return this->Plan.GetNumberOfExchanges() > 0; }

  /**
   * Join the poll of a frame that IsShared(), if it has one. `changed`: whether what this rank
   * draws may have changed since the last frame. Returns whether no rank has changed, so that all
   * verdicts of the last frame are still valid, and there is no exchange. Call it once in a frame,
   * before anything is drawn.
   */
  bool Poll(bool changed);

  /// What the culler reports of this frame. The view is filled in already, and so is Gain before
  /// the message is sent.
  vtkNBufferRankReport& GetReport() { return this->Report; }

  /// What a trial has found; see vtkNBufferRankReport::Gain.
  void SetGain(int gain) { this->Gain = gain; }

  /// Whether the culler is to count what its own depth hides, before it merges, and SetGain().
  bool IsTrial() const { return this->Joined == 0 && this->Plan.IsTrial(); }

  /**
   * Join an exchange with level 0 of this rank's depth, if one is left, and merge into level 0 what
   * the exchanges of this frame have brought. Returns whether that made a texel nearer.
   */
  bool Merge(vtkNBufferLevels& base);

  /// Join the exchanges that are left, and end the frame. The window's context must be current.
  void EndFrame(vtkRenderer* renderer, const Layout& layout);

  /// The largest step of any rank's depth buffer, as known when the frame began.
  double GetStep() const { return this->AssumedStep; }

  /// The candidates of the other ranks at the last exchange.
  int GetOtherCandidates() const { return this->OtherCandidates; }

  const Layout& GetLayout() const { return this->Current; }
  const Counts& GetCounts() const { return this->LastCounts; }

private:
  std::vector<float> GetWanted() const;
  bool Agree();
  void Join(const float* texels);
  bool Exchange(const float* texels, int number);
  bool ReadDepth(vtkRenderer* renderer, std::vector<float>& texels);
  void WarnOnce(const char* text);

  Reduction Reduce;
  vtkNBufferExchangePlan Plan;
  Layout Current;
  vtkNBufferRankReport Report;
  Counts Frame;
  Counts LastCounts;
  std::vector<double> View;  ///< The view of the last frame.
  std::vector<float> Minima; ///< The last reply; it begins with level 0 of all ranks.
  int Size[2] = { 0, 0 };    ///< That of level 0, in texels.
  std::vector<float> Agreed; ///< What all ranks have agreed on; empty if they have not.
  bool HasBegun = false;
  bool HasMoved = false;  ///< Whether the view is not that of the last frame.
  bool HasPolled = false; ///< Whether Poll() was called in this frame.
  bool HasGiven = false;  ///< Whether this rank gave any depth to the last exchange.
  bool HasShared = false; ///< Whether Minima is valid for this frame.
  bool HasWarned = false;
  int Joined = 0;
  int Gain = 0;
  int OtherCandidates = 0;
  double Step = 0.0;
  double AssumedStep = 0.0; ///< Step, as it was when the frame began.
};

VTK_ABI_NAMESPACE_END
#endif
