// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSharedDepth
 * @brief What one rank of a parallel program knows of the depth that all ranks have drawn for a
 * renderer. This class also makes the rank join every exchange.
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
 * The minima that an exchange has brought are used until the end of the frame, because depth only
 * gets nearer while a frame is drawn. They are not used if the ranks have different views, or if
 * another rank's depth buffer has a larger step than was assumed when the boxes were projected.
 * That step is assumed from the next frame on.
 *
 * ## When the verdicts of the last frame are still valid
 *
 * The verdicts are valid if no rank's depth has become farther since the last exchange. A rank
 * knows this of its own depth if its culler has found no change, or if the rank gave nothing but
 * the far plane to that exchange. If the rank gave the depth of its finished picture, its culler
 * knows this only if no prop of any stage changes without a newer time. If the poll shows that
 * every rank knows it, nothing is exchanged. A view that has not tested in a frame with an
 * exchange, because the rank had no props or was frozen, does not know what that exchange has
 * brought (HasExchangedSince()).
 *
 * ## Layouts
 *
 * All messages of an exchange must have the same size. Before the first exchange the ranks agree on
 * their layout, which is the size of level 0 and the settings. A rank whose layout changes after
 * that, alone or together with the others, still sends a message of the size that was agreed on,
 * and reports in it that its layout differs. All ranks then agree anew in the same frame.
 */
#ifndef vtkNBufferSharedDepth_h
#define vtkNBufferSharedDepth_h

#include "vtkNBufferCamera.h"
#include "vtkNBufferExchangeMessage.h"
#include "vtkNBufferExchangePlan.h"

#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferLevels;
class vtkRenderer;

class vtkNBufferSharedDepth
{
public:
  /// See vtkNBufferDepthExchange::ReduceToMinimum().
  using Reduction = std::function<bool(const float* values, float* minima, int count)>;

  /// The exchange's settings, which must be the same on all ranks, and the rank's own number.
  struct Layout
  {
    int Ranks = 1;
    int Rank = 0;
    int TileSize = 4; ///< The side in pixels of a texel of level 0.
    bool BackOff = true;
  };

  /// The messages of one frame, polls included.
  struct Counts
  {
    int Exchanges = 0;
    long long Bytes = 0; ///< The size of this rank's messages, in bytes.
    double Time = 0.0;   ///< Milliseconds spent in them, mostly waiting for other ranks.
  };

  explicit vtkNBufferSharedDepth(Reduction reduction)
    : Reduce(std::move(reduction))
  {
  }

  /// Begin a frame of the renderer unless it has begun already.
  void BeginFrame(vtkRenderer* renderer, const Layout& layout);

  /// Forget a frame that has begun if EndFrame() will not be called for it.
  void AbandonFrame() { this->HasBegun = false; }

  /// Whether this frame has exchanges, by what is known so far.
  bool IsShared() const { return this->Plan.GetNumberOfExchanges() > 0; }

  /**
   * Join the poll of a frame for which IsShared() is true, if the frame has a poll. `changed` says
   * whether what this rank draws in the opaque stage may have changed since the last frame, and
   * `pictureChanged` whether what it draws after that may have. Returns whether there is no
   * exchange, because nothing has changed on any rank and all verdicts of the last frame are still
   * valid. To be called once in a frame, before anything is drawn.
   */
  bool Poll(bool changed, bool pictureChanged);

  /// What this rank reports of this frame. The culler sets NewProps, Candidates and, if it
  /// reads the depth, Step. This class sets what is left.
  vtkNBufferRankReport& GetReport() { return this->Report; }

  /// Set what a trial has found hidden by this rank's own depth, and by that of all ranks. The
  /// number of candidates must have been reported.
  void SetTrial(int hiddenByOwn, int hiddenByAll);

  /// Whether the next Merge() is that of a trial. In a trial the culler counts what its own depth
  /// hides before Merge(), and what all ranks' depth hides after it, and calls SetTrial().
  bool IsTrial() const { return this->Joined == 0 && this->Plan.IsTrial(); }

  /**
   * If an exchange is left in this frame, join it with level 0 of this rank's depth. Then merge
   * into level 0 the minima that the last exchange has brought. Returns whether that made a texel
   * nearer.
   */
  bool Merge(vtkNBufferLevels& base);

  /// Join the exchanges that are left, and end the frame. The window's context must be current.
  void EndFrame(vtkRenderer* renderer, const Layout& layout);

  /// The largest step of any rank's depth buffer, in window depth, as known when the frame began.
  double GetStep() const { return this->AssumedStep; }

  /// How many candidates the other ranks have reported in the last exchange.
  int GetOtherCandidates() const { return this->OtherCandidates; }

  /// When this frame began. This number grows from frame to frame.
  vtkMTimeType GetFrameTime() const { return this->FrameTime.GetMTime(); }

  /// Whether a frame that began later than that of `time` had an exchange.
  bool HasExchangedSince(vtkMTimeType time) const { return this->ExchangeTime > time; }

  const Layout& GetLayout() const { return this->Current; }
  const Counts& GetCounts() const { return this->LastCounts; }

private:
  std::vector<float> GetWanted() const;
  bool Agree();
  void Join(const float* texels);
  bool Exchange(const float* texels, int number);
  bool ReadDepth(vtkRenderer* renderer, std::vector<float>& texels);
  /// Get the minima of all ranks' values. Returns false, after a warning, if that fails.
  bool Send(const std::vector<float>& values, std::vector<float>& minima);
  void WarnOnce(const std::string& text);

  Reduction Reduce;
  vtkNBufferExchangePlan Plan;
  Layout Current;
  vtkNBufferRankReport Report;
  Counts Frame;
  Counts LastCounts;
  vtkTimeStamp FrameTime;
  vtkMTimeType ExchangeTime = 0; ///< GetFrameTime() of the last frame that had an exchange.
  vtkNBufferViewKey View;        ///< That of the last frame.
  std::vector<float> Minima;     ///< The last reply; it begins with level 0 of all ranks.
  int Size[2] = { 0, 0 };        ///< The size of level 0, in texels.
  std::vector<float> Agreed;     ///< What all ranks have agreed on; empty if they have not.
  bool HasBegun = false;
  bool HasMoved = false;          ///< Whether the view is not that of the last frame.
  bool HasPolled = false;         ///< Whether Poll() was called in this frame.
  bool HasGiven = false;          ///< Whether this rank gave any depth to the last exchange.
  bool GivesPicture = false;      ///< Whether that depth was the one of its finished picture.
  bool HasShared = false;         ///< Whether Minima is valid for this frame.
  std::set<std::string> Warnings; ///< Those given so far.
  int Joined = 0;
  int Gain = 0; ///< The results of the last trial, until they are reported.
  int Unhidden = 0;
  int OtherCandidates = 0;
  double Step = 0.0;
  double AssumedStep = 0.0; ///< Step, as it was when the frame began.
};

VTK_ABI_NAMESPACE_END
#endif
