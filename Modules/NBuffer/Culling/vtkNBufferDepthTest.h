// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDepthTest
 * @brief Which candidates of a list lie behind what has been drawn in this frame so far.
 *
 * A candidate is compared with the levels first (vtkNBufferOcclusionTest). Those that the levels do
 * not find hidden are compared with the pixels (vtkNBufferPixelTest) where the depth image is in
 * host memory or worth reading: first their boxes, then the triangles of small meshes. Candidates that were found hidden may have slivers that a device
 * draws before their box; these candidates are kept (vtkNBufferSliverTest).
 */
#ifndef vtkNBufferDepthTest_h
#define vtkNBufferDepthTest_h

#include "vtkNBufferBackend.h"
#include "vtkNBufferCandidateList.h"
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

/// When the triangles of hidden props are looked at.
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
   * Build the levels that the candidates at all of `places` need, from the depth of the framebuffer
   * that is being drawn. Returns None, or a failure with its cause and remedy in `why`, as
   * vtkNBufferBackend::Build() does.
   */
  vtkNBufferDecision Build(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source,
    std::initializer_list<const std::vector<int>*> places, std::string& why);

  /// Remove the places of hidden candidates from `places`. Returns how many candidates the levels
  /// alone did not find hidden. Nothing may have been drawn since Build().
  int RemoveHidden(std::vector<int>& places);

private:
  /// The depth image if it is worth having for this many candidates, else null.
  const float* GetDepth(std::size_t candidates);
  bool TestsSlivers() const;
  /// Put those of `tested` back into `places` that may be seen by a sliver. `places` is what is
  /// left of `tested`, in the same order, before and after.
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
  double SampleDistance = 0.5; ///< From the middle of its pixel, in x and in y, in pixels.
};

VTK_ABI_NAMESPACE_END
#endif
