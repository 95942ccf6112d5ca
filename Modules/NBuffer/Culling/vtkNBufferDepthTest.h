// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDepthTest
 * @brief Which candidates of a list lie behind what has been drawn in this frame so far.
 *
 * In a parallel program the levels are those of what all ranks have drawn (vtkNBufferSharedDepth).
 *
 * A test has up to three steps:
 *
 *  1. The box of each candidate is compared with the levels (vtkNBufferOcclusionTest).
 *  2. Candidates that the levels do not find hidden are compared with the pixels
 *     (vtkNBufferPixelTest): first their boxes, then the triangles of small meshes. This step needs
 *     the depth image, and is done only if that is in host memory or worth reading.
 *  3. With TestSlivers and a software renderer: candidates that were found hidden may have slivers
 *     that are drawn in front of their boxes. vtkNBufferFaceTest rules this out for most of them.
 *     What remains is tested triangle by triangle (vtkNBufferSliverTest). Candidates with a sliver
 *     that may be seen count as visible. Props of MinimumNumberOfPrimitives polygons or more, which
 *     are divided, are not examined.
 */
#ifndef vtkNBufferDepthTest_h
#define vtkNBufferDepthTest_h

#include "vtkNBufferBackend.h"
#include "vtkNBufferCandidateList.h"
#include "vtkNBufferDividedProp.h"
#include "vtkNBufferFaceTest.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferSliverTest.h"
#include "vtkNBufferStatistics.h"
#include "vtkNBufferTuning.h"

#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferSharedDepth;
class vtkOpenGLRenderWindow;
class vtkRenderer;

/// The settings of vtkNBufferCuller with the same names and its tuning, as they are when a frame
/// begins. vtkNBufferCuller sets all of them; their defaults stand there.
struct vtkNBufferSettings : vtkNBufferTuning
{
  /// Adapt the settings to a frame in which several ranks share their depth; with nullptr nothing
  /// is shared. A texel of level 0 is then a tile of the exchange. MinimumNumberOfCandidates counts
  /// the candidates of all ranks. RoundSize is divided by the number of ranks. No rank backs off
  /// alone, because it has to read its depth for the other ranks in any case; what it has learned
  /// of its tests is forgotten.
  void Share(const std::shared_ptr<vtkNBufferSharedDepth>& shared);

  /// Report to the other ranks how many candidates a frame has that is not tested. Even if they are
  /// too few for a test, those of all ranks together may be enough in the next frame.
  void ReportUntested(const vtkNBufferStatistics& statistics) const;

  /// The step of depth that the test allows for: that of the coarsest depth of any rank.
  double GetStep(const vtkNBufferDepthSource& source) const;

  std::shared_ptr<vtkNBufferSharedDepth> Shared; ///< nullptr if this frame is not shared.
  vtkNBufferBackend::Kind Backend;
  bool TestSlivers;
  bool DivideProps;
  bool Freeze;
};

class vtkNBufferDepthTest
{
public:
  /// All arguments are kept by reference and must outlive the test.
  vtkNBufferDepthTest(vtkNBufferBackend& backend, vtkNBufferLevels& levels,
    vtkNBufferCandidateList& props, vtkNBufferStatistics& statistics,
    const vtkNBufferSettings& settings)
    : Backend(backend)
    , Levels(levels)
    , Props(props)
    , Statistics(statistics)
    , Settings(settings)
  {
  }

  /**
   * Build the levels that the candidates in all lists of `places` need, and at least `levels` of
   * them, from the depth of the framebuffer that is bound for drawing, which `source` describes.
   * `countHiddenUnits` says how many units of large props the levels hide. It is only called in a
   * trial (vtkNBufferExchangePlan). Returns None, or a failure with its cause and remedy in `why`,
   * as vtkNBufferBackend::Build() does.
   */
  vtkNBufferDecision Build(vtkRenderer* renderer, const vtkNBufferDepthSource& source,
    std::initializer_list<const std::vector<int>*> places, int levels,
    const std::function<int()>& countHiddenUnits, std::string& why);

  /// The depth that units are compared with. It is valid after Build() until something is drawn.
  vtkNBufferDividedProp::Depth GetDepthOfUnits();

  /// Report to the other ranks the number of candidates and units in the frustum, and how many of
  /// the candidates are held back in a new view (0 if the view is not new). To be called before the
  /// first Build() of a frame.
  void SetCounts(int candidates, int newProps);

  /// Remove the places of hidden candidates from `places`. Returns how many candidates the levels
  /// alone did not find hidden. Nothing may have been drawn since Build().
  int RemoveHidden(std::vector<int>& places);

  /// Whether nothing can be seen of what two props have in common, by the depth of the last
  /// Build(). More may have been drawn since.
  bool IsHidden(const vtkNBufferContact& contact);

private:
  /// What the back-end builds and reads, with this many levels.
  vtkNBufferBackend::Job GetJob(int levels)
  {
    return { this->Window, this->Source, this->Rows, this->Settings.BaseFactor, levels,
      this->Levels, this->Statistics };
  }
  /// Find the rows in which props have been drawn so far, by their boxes. Where anything else may
  /// have been drawn these are all rows.
  void FindDrawnRows(vtkRenderer* renderer);
  /// The steps 1 and 2 of RemoveHidden().
  int RemoveBehind(std::vector<int>& places);
  /// Remove the places of candidates that are behind these pixels.
  void RemoveBehindPixels(std::vector<int>& places, const float* depth);
  /// How many candidates of all lists RemoveBehind() finds hidden. The statistics count only the
  /// time that this takes.
  int CountHidden(std::initializer_list<const std::vector<int>*> places);
  /// The depth image, with at least the pixels of these candidates, or nullptr if it is not worth
  /// reading for them.
  const float* GetDepth(const std::vector<int>& places);
  /// The screen box of a candidate, or nullptr for one that is not Inside.
  const vtkNBufferScreenBox* GetScreen(int i);
  /// Put back into `places` the candidates of `tested` that have a sliver that may be visible.
  /// Before and after the call `places` is a part of `tested`, in the same order.
  void PutBackSlivers(const std::vector<int>& tested, std::vector<int>& places);
  /// What is known of the slivers of a hidden candidate.
  enum class Slivers : char
  {
    Hidden,
    Visible,
    Unknown ///< Its triangles have to be read first.
  };
  /// Whether a piece of a hidden candidate may be in front, given what hides the piece itself.
  bool MayBeInFront(const vtkNBufferFaceTest& faceTest, const vtkNBufferFaces::Piece& piece);
  /// May run in parallel for different candidates.
  Slivers FindSlivers(
    int i, const vtkNBufferFaceTest& faceTest, const vtkNBufferSliverTest& sliverTest);

  vtkNBufferBackend& Backend;
  vtkNBufferLevels& Levels;
  vtkNBufferCandidateList& Props;
  vtkNBufferStatistics& Statistics;
  const vtkNBufferSettings& Settings;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkNBufferDepthSource Source;
  vtkNBufferRows Rows;         ///< Those in which anything has been drawn.
  double SampleDistance = 0.5; ///< How far from the middle of a pixel a sample may be.
};

VTK_ABI_NAMESPACE_END
#endif
