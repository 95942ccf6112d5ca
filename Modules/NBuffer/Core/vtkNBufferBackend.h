// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferBackend
 * @brief Builds the levels of the depth of the framebuffer that is being drawn, and returns them in
 * host memory.
 *
 * There are two paths, which build the same levels, to the bit. On the OpenGL path, a fragment pass
 * reduces the depth to level 0, which is then read back. On the CPU path, all rows of depth in
 * which anything may have been drawn are read back, and the host reduces them. On both paths the
 * host builds the other levels: together they are 8 to 10 times as large as level 0, so that
 * reading them back would take longer than building them.
 *
 * Which path is faster depends on the machine. Software renderers reduce on the same processor, and
 * slower than the host does (docs/benchmarks.md), so Auto chooses the CPU there without a trial.
 * Elsewhere Auto measures both paths in real frames, once per graphics context: the first build, by
 * OpenGL, warms the passes up; the second, by OpenGL, and the third, by the CPU, are measured. Auto
 * then stays with the faster path.
 */
#ifndef vtkNBufferBackend_h
#define vtkNBufferBackend_h

#include "vtkNBufferDepthSource.h"
#include "vtkNBufferDepthTiles.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferStatistics.h"
#include "vtkNBufferTexture.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class vtkNBufferBackend
{
public:
  /// The path, with the same values as vtkNBufferCuller::BackendType.
  enum Kind
  {
    Auto,
    OpenGL,
    CPU
  };

  /// What Build() builds, and where it stores the levels and adds their costs.
  struct Job
  {
    vtkOpenGLRenderWindow* Window;
    const vtkNBufferDepthSource& Source; ///< The framebuffer that is bound for drawing.
    /// The rows of the viewport in which anything may have been drawn. The CPU path reads no
    /// others: their pixels count as background.
    const vtkNBufferRows& Rows;
    int Factor;         ///< Side in pixels of a square of level 0: 1, 2, 4 or 8.
    int NumberOfLevels; ///< How many levels the test needs.
    vtkNBufferLevels& Levels;
    vtkNBufferStatistics& Statistics; ///< Counts and times are added.
  };

  /**
   * Build levels of the farthest depths over the viewport of the source, as orders
   * (vtkNBufferDepthConvention.h). Returns None on success.
   * On failure returns NoFloatTextures or NoDepth, with cause and remedy in `why`, and leaves no
   * levels. If `wanted` is Auto and the OpenGL path fails, the CPU path is used instead, now and
   * later in this context.
   */
  vtkNBufferDecision Build(Kind wanted, const Job& job, std::string& why);

  /**
   * To be called after Build(), to add depth that other ranks have drawn. merge(levels) replaces
   * texels of level 0 by nearer depth where the final picture has nearer depth; it returns whether
   * it replaced any. The other levels of `job` are then built from level 0. GetDepth() still
   * returns the depth that this rank has drawn.
   */
  void Merge(const std::function<bool(vtkNBufferLevels&)>& merge, const Job& job);

  /**
   * The depth image from which Build() made the levels of `job`: the order of the farthest sample
   * of each pixel of the viewport, row by row, the lowest row first; or nullptr if it cannot be
   * read. Only the pixels in `rectangles`, here and in earlier calls since Build(), are defined.
   * The CPU path has all of it already. The OpenGL path reads the tiles that it has not read
   * yet (vtkNBufferDepthTiles), so nothing may have been drawn since Build().
   */
  const float* GetDepth(const Job& job, const std::vector<vtkNBufferRectangle>& rectangles);

  /**
   * The levels of `job` on the device, the same texels as in host memory. Returns nullptr if the
   * host has built them, if other ranks have made them nearer, or if the depth is stored in another
   * order. Nothing may have been drawn since Build().
   */
  const vtkNBufferTexture* GetTexture(const Job& job);

  /**
   * Whether the state of OpenGL is the one that the test requires while props are drawn: a depth
   * test that lets nearer fragments pass (vtkNBufferStoredDepth), no scissor that cuts the
   * viewport, and depth that is written.
   */
  static bool DrawsKnownDepth(const vtkNBufferDepthSource& source);

  /// Whether float textures may be used; see vtkNBufferTexture.
  void SetAllowFloatTextures(bool allow)
  {
    this->Texture->SetAllowFloatTextures(allow);
    this->FarthestTexture->SetAllowFloatTextures(allow);
  }

  ///@{
  /// Count a frame in which everything is drawn because of `failure`. Returns true for the first
  /// failure of its kind, about which the caller has to warn.
  bool CountFailure(vtkNBufferDecision failure);
  int GetFailedFrames() const { return this->FailedFrames; }
  ///@}

  ///@{
  /// The path of the last Build() (Auto before the first one), and why it was chosen.
  Kind GetInUse() const { return this->InUse; }
  const std::string& GetReason() const { return this->Reason; }
  ///@}

private:
  Kind Choose(Kind wanted, vtkOpenGLRenderWindow* window);
  void Settle(Kind kind, const std::string& reason);
  void RecordTrial(double milliseconds);
  vtkNBufferDecision BuildOnDevice(const Job& job, std::string& why);
  vtkNBufferDecision BuildOnHost(const Job& job, std::string& why);
  vtkNBufferDecision ReadDepth(const Job& job, std::string& why);
  /// Give the depth image this many pixels. Those from `first` to `end` will be read, and what was
  /// read of others becomes background.
  void ClearDepth(std::size_t size, std::size_t first, std::size_t end);
  /// Let the device reduce the depth to level 0 of `texture`, and build the levels above it.
  static vtkNBufferDecision Reduce(
    vtkNBufferTexture* texture, const Job& job, int factor, std::string& why, int levels = 1);
  /// Read rectangles of level 0 of `texture` back to their places in `base`, as orders.
  static vtkNBufferDecision ReadBack(vtkNBufferTexture* texture, const Job& job,
    const std::vector<vtkNBufferRectangle>& rectangles, float* base, std::string& why);

  vtkNew<vtkNBufferTexture> Texture;
  /// The farthest sample of each pixel, for multisampled framebuffers and for the OpenGL path.
  vtkNew<vtkNBufferTexture> FarthestTexture;
  ///@{
  /// The depth image. With the OpenGL path only the tiles that were read since the last Build() are
  /// defined. All pixels before FirstRead and from EndRead on are background.
  std::vector<float> Depth;
  std::size_t FirstRead = 0;
  std::size_t EndRead = 0;
  bool HasDepth = false;
  bool IsMerged = false; ///< Whether Merge() has made level 0 nearer.
  vtkNBufferDepthTiles Tiles;
  ///@}
  Kind InUse = Auto;
  std::string Reason = "nothing built yet";
  ///@{
  /// What Auto has chosen in the context, and why; Chosen is Auto during the trials. Trial counts
  /// the builds of the trials, and DeviceTime is what OpenGL took, in milliseconds.
  Kind Chosen = Auto;
  std::string ReasonOfChoice;
  vtkMTimeType ContextTime = 0;
  int Trial = 0;
  double DeviceTime = 0.0;
  ///@}
  int FailedFrames = 0;
  std::set<vtkNBufferDecision> WarnedOf;
};

VTK_ABI_NAMESPACE_END
#endif
