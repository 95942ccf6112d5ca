// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDepthTest
 * @brief Which candidates of a list lie behind what has been drawn in this frame so far.
 *
 * First by the levels (vtkNBufferOcclusionTest), then, for those in doubt and where the depth
 * image is at hand, by the pixels (vtkNBufferPixelTest). What they found hidden may have slivers
 * that are drawn before its box (vtkNBufferSliverTest).
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
  Never,
  OnSoftware,
  Always
};

class vtkNBufferDepthTest
{
public:
  /// The culler's settings of the same names, and its tuning.
  struct Options
  {
    vtkNBufferBackend::Kind Backend;
    vtkNBufferSliverPolicy TestSlivers;
    const vtkNBufferTuning& Tuning;
  };

  /// All but the options are kept by reference and must outlive the test.
  vtkNBufferDepthTest(vtkNBufferBackend& backend, vtkNBufferLevels& levels,
    const vtkNBufferProjection& projection, vtkNBufferCandidateList& props,
    vtkNBufferStatistics& statistics, const Options& options);

  /**
   * Build the levels that the props in all of `places` need, from the depth of the framebuffer
   * that is being drawn. As vtkNBufferBackend::Build.
   */
  vtkNBufferDecision Build(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source,
    std::initializer_list<const std::vector<int>*> places, std::string& why);

  /// Take the places of hidden props out of `places`; returns how many of them the levels alone did
  /// not find hidden. Nothing may be drawn since Build().
  int RemoveHidden(std::vector<int>& places);

private:
  const float* GetDepth(std::size_t doubtful);
  bool TestsSlivers() const;
  void PutBackSlivers(const std::vector<int>& asked, std::vector<int>& places);
  bool HasVisibleSlivers(int i, vtkNBufferSliverTest& test);

  vtkNBufferBackend& Backend;
  vtkNBufferLevels& Levels;
  const vtkNBufferProjection& Projection;
  vtkNBufferCandidateList& Props;
  vtkNBufferStatistics& Statistics;
  Options Settings;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkNBufferDepthSource Source;
};

VTK_ABI_NAMESPACE_END
#endif
