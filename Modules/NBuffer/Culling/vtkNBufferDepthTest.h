// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDepthTest
 * @brief Which candidates of a list lie behind what has been drawn in this frame so far.
 *
 * A test has up to three steps:
 *
 *  1. The box of each candidate is compared with the levels (vtkNBufferOcclusionTest).
 *  2. Candidates that the levels do not find hidden are compared with the pixels
 *     (vtkNBufferPixelTest): first their boxes, then the triangles of small meshes. This step needs
 *     the depth image, and is done where that is in host memory or worth reading.
 *  3. Candidates that were found hidden may have slivers that a device draws in front of their
 *     boxes (vtkNBufferSliverTest). Such candidates count as visible.
 */
#ifndef vtkNBufferDepthTest_h
#define vtkNBufferDepthTest_h

#include "vtkNBufferBackend.h"
#include "vtkNBufferCandidateList.h"
#include "vtkNBufferDividedProp.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferProjection.h"
#include "vtkNBufferSliverTest.h"
#include "vtkNBufferStatistics.h"
#include "vtkNBufferTuning.h"

#include <initializer_list>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

/// Whether to look for slivers of the props whose boxes were found hidden.
enum class vtkNBufferSliverPolicy
{
  Never,      ///< In no frame.
  OnSoftware, ///< Where OpenGL runs in software, as with Mesa's llvmpipe.
  Always      ///< In every frame.
};

/// The settings of vtkNBufferCuller with the same names and its tuning, as they are when a frame
/// begins.
struct vtkNBufferSettings : vtkNBufferTuning
{
  vtkNBufferBackend::Kind Backend = vtkNBufferBackend::Auto;
  vtkNBufferSliverPolicy TestSlivers = vtkNBufferSliverPolicy::Never;
  bool DivideProps = true;
  bool Freeze = false;
};

class vtkNBufferDepthTest
{
public:
  /// All arguments are kept by reference and must outlive the test.
  vtkNBufferDepthTest(vtkNBufferBackend& backend, vtkNBufferLevels& levels,
    const vtkNBufferProjection& projection, vtkNBufferCandidateList& props,
    vtkNBufferStatistics& statistics, const vtkNBufferSettings& settings);

  /**
   * Build the levels that the candidates in all lists of `places` need, and at least `levels` of
   * them, from the depth of the framebuffer that is bound for drawing, which `source` describes.
   * Returns None, or a failure with its cause and remedy in `why`, as vtkNBufferBackend::Build()
   * does.
   */
  vtkNBufferDecision Build(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source,
    std::initializer_list<const std::vector<int>*> places, int levels, std::string& why);

  /// What units of props are compared with after Build(), until something is drawn.
  vtkNBufferDividedProp::Depth GetDepthOfUnits();

  /// Remove the places of hidden candidates from `places`. Returns how many candidates the levels
  /// alone did not find hidden. Nothing may have been drawn since Build().
  int RemoveHidden(std::vector<int>& places);

private:
  /// What the back-end builds and reads, with this many levels.
  vtkNBufferBackend::Job GetJob(int levels)
  {
    return { this->Window, this->Source, this->Settings.BaseFactor, levels, this->Levels,
      this->Statistics };
  }
  /// The depth image, with the pixels of these candidates, if it is worth having for them, else
  /// null.
  const float* GetDepth(const std::vector<int>& places);
  /// The pixels of a candidate, or null for one that is not Inside.
  const vtkNBufferScreenBox* GetScreen(int i);
  bool TestsSlivers() const;
  /// Put those of `tested` back into `places` of which a sliver may be visible. Before and after
  /// the call `places` is a part of `tested`, in the same order.
  void PutBackSlivers(const std::vector<int>& tested, std::vector<int>& places);
  bool HasVisibleSlivers(int i, vtkNBufferSliverTest& test);

  vtkNBufferBackend& Backend;
  vtkNBufferLevels& Levels;
  const vtkNBufferProjection& Projection;
  vtkNBufferCandidateList& Props;
  vtkNBufferStatistics& Statistics;
  const vtkNBufferSettings& Settings;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkNBufferDepthSource Source;
  /// How far a sample may be from the middle of its pixel in x and in y, in pixels.
  double SampleDistance = 0.5;
};

VTK_ABI_NAMESPACE_END
#endif
