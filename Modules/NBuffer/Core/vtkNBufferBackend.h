// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferBackend
 * @brief Gets the levels of the framebuffer that is being drawn into host memory, on either path.
 *
 * OpenGL: the depth is reduced and the levels are built by fragment passes, then read back once.
 * CPU: the depth is read back once, reduced and built here. Both give the same levels to the bit.
 *
 * Which one is faster depends on the machine. On llvmpipe the passes took 20 to 40 times what the
 * host needs (docs/benchmarks.md), so that Auto takes the CPU on software renderers without a
 * trial. Elsewhere it times both on real frames, once per graphics context: the first build warms
 * the passes up, the second and third are measured, the faster path stays.
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

  /// What Build() builds, and where the levels and their costs go.
  struct Job
  {
    vtkOpenGLRenderWindow* Window;
    const vtkNBufferDepthSource& Source; ///< The framebuffer that is bound for drawing.
    int Factor;                          ///< Side of the square of pixels in a texel of level 0.
    int NumberOfLevels;                  ///< How many levels the test needs.
    vtkNBufferLevels& Levels;
    vtkNBufferStatistics& Statistics; ///< Counts and times are added.
  };

  /**
   * Build levels of the farthest depths over the viewport of the source. Returns None. On failure
   * returns NoFloatTextures or NoDepth, with cause and remedy in `why`, and the levels hold
   * nothing. Auto goes on with the CPU where the device cannot build.
   */
  vtkNBufferDecision Build(Kind wanted, const Job& job, std::string& why);

  /**
   * The whole depth image from which the last levels were built, width * height of the viewport: of
   * each pixel the farthest sample; or nullptr if it cannot be read. On the CPU path it is there
   * already; on the OpenGL path it is read now, which must be before anything else is drawn.
   */
  const float* GetDepth(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source,
    vtkNBufferStatistics& statistics);

  /**
   * Whether props are drawn now in the way that the test presumes: with a depth test that
   * lets nearer fragments pass, into the whole viewport, with depth written over the whole range
   * [0, 1]. The answer is OpenGL's.
   */
  static bool DrawsOrdinaryDepth(const vtkNBufferDepthSource& source);

  /// See vtkNBufferTexture.
  void SetAllowFloatTextures(bool allow)
  {
    this->Texture->SetAllowFloatTextures(allow);
    this->FarthestTexture->SetAllowFloatTextures(allow);
  }

  ///@{
  /// Count a frame that is drawn whole because of `failure`. True for the first failure of its
  /// kind, about which the caller warns.
  bool CountFailure(vtkNBufferDecision failure);
  int GetFailedFrames() const { return this->FailedFrames; }
  ///@}

  Kind GetInUse() const { return this->InUse; }
  const std::string& GetReason() const { return this->Reason; }

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
  /// The farthest sample of each pixel, as the device finds it. The levels are kept for their
  /// memory.
  vtkNew<vtkNBufferTexture> FarthestTexture;
  vtkNBufferLevels FarthestSamples;
  ///@}
  std::vector<float> Depth; ///< The whole image; empty if the last build did not read it.
  Kind InUse = Auto;
  std::string Reason = "nothing built yet";
  ///@{
  /// What Auto has come to in the context: the choice with its reason, or Auto while trials go on.
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
