// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferBackend
 * @brief Builds the levels of the depth of the framebuffer that is being drawn, and returns them in
 * host memory.
 *
 * There are two paths, which give the same levels to the bit. OpenGL: fragment passes reduce the
 * depth and build the levels, which are then read back once. CPU: the depth is read back once, and
 * the host reduces it and builds the levels.
 *
 * Which one is faster depends on the machine. On llvmpipe the passes took 20 to 40 times as long as
 * the host (docs/benchmarks.md), so Auto chooses the CPU on software renderers without a trial.
 * Elsewhere Auto measures both paths in real frames, once per graphics context: the first build, by
 * OpenGL, warms the passes up; the second, by OpenGL, and the third, by the CPU, are measured. Auto
 * then stays with the faster path.
 */
#ifndef vtkNBufferBackend_h
#define vtkNBufferBackend_h

#include "vtkNBufferDepthSource.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferStatistics.h"
#include "vtkNBufferTexture.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <set>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class vtkNBufferBackend
{
public:
  /// As vtkNBufferCuller::BackendType.
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
    int Factor;                          ///< Side in pixels of a square of level 0: 1, 2, 4 or 8.
    int NumberOfLevels;                  ///< How many levels the test needs.
    vtkNBufferLevels& Levels;
    vtkNBufferStatistics& Statistics; ///< Counts and times are added.
  };

  /**
   * Build levels of the farthest depths over the viewport of the source. Returns None on success.
   * On failure returns NoFloatTextures or NoDepth, with cause and remedy in `why`, and leaves no
   * levels. If `wanted` is Auto and the device cannot build, the CPU builds instead, now and later
   * in this context.
   */
  vtkNBufferDecision Build(Kind wanted, const Job& job, std::string& why);

  /**
   * The whole depth image from which the last levels were built: the farthest sample of each pixel
   * of the viewport, row by row, the lowest row first; or nullptr if it cannot be read. The CPU
   * path has it already. The OpenGL path reads it now, so nothing may have been drawn since
   * Build().
   */
  const float* GetDepth(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source,
    vtkNBufferStatistics& statistics);

  /**
   * Whether the state of OpenGL is the one that the test requires while props are drawn: a depth
   * test that lets nearer fragments pass, no scissor that cuts the viewport, depth that is written,
   * and the depth range [0, 1].
   */
  static bool DrawsOrdinaryDepth(const vtkNBufferDepthSource& source);

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
  static vtkNBufferDecision BuildOnDevice(
    vtkNBufferTexture* texture, const Job& job, std::string& why);
  vtkNBufferDecision BuildOnHost(const Job& job, std::string& why);
  vtkNBufferDecision ReadDepth(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source,
    vtkNBufferStatistics& statistics, std::string& why);

  vtkNew<vtkNBufferTexture> Texture;
  ///@{
  /// The farthest sample of each pixel of a multisampled framebuffer, which the device finds and
  /// which is read back. Both members are kept only for their memory.
  vtkNew<vtkNBufferTexture> FarthestTexture;
  vtkNBufferLevels FarthestSamples;
  ///@}
  std::vector<float> Depth; ///< The whole depth image; empty while it has not been read.
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
