// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferTuning
 * @brief The constants of vtkNBufferCuller that measurements and tests vary and applications leave
 * alone.
 *
 * No value of any of them changes the image. The study (docs/accuracy-settings.md) found the
 * defaults to be as fast as any other value on its scenes, or faster.
 *
 * @code
 * vtkNBufferTuning tuning = culler->GetTuning();
 * tuning.RoundSize = 16;
 * culler->SetTuning(tuning);
 * @endcode
 */
#ifndef vtkNBufferTuning_h
#define vtkNBufferTuning_h

#include "vtkIndent.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

struct VTKNBUFFER_EXPORT vtkNBufferTuning
{
  /// The side in pixels of the square that a texel of level 0 covers: 1, 2, 4 or 8. With a larger
  /// square levels are cheaper to build and to read back, and more small props are false-visible.
  int BaseFactor = 4;

  /// A frame with fewer candidates than this in the frustum is drawn as without the culler, because
  /// a read-back would take longer than it saves; 1 or more.
  int MinimumNumberOfCandidates = 32;

  /// The largest number of rounds (one test and one draw each) in a frame; 1 to 8. A pass that
  /// draws the opaque props twice may add one.
  int MaximumNumberOfRounds = 6;

  /// The largest number of props that are drawn before the first test of a view of which little is
  /// known; 1 or more. If 1/512 of the props held back is more, that number is the limit. If a
  /// test leaves more than twice as many props, only those of them that probably hide others are
  /// drawn before another test (vtkNBufferCoarseDepth.h). The same holds for the units of a large
  /// prop that have become visible, if they are more than 16 times RoundSize, and more than a
  /// quarter of those that have been drawn.
  int RoundSize = 64;

  /// If a renderer has at least this many props, the culler uses a hierarchy over their boxes; 0
  /// means always. The hierarchy takes 150 bytes per prop. When the list of props changes, it is
  /// built again, which takes 0.5 microseconds per prop (vtkNBufferCandidateTree).
  int HierarchySize = 10000;

  /// The objects of a prop get observers (vtkNBufferObservedObjects) when the prop has not changed
  /// for this many frames; 0 means never. From then on a frame reads none of the modification times
  /// of the prop's objects, of which there are about fifteen. If the actor has a user's transform,
  /// or has never been drawn, each frame still reads the actor's own time.
  int ObserveAfter = 60;

  ///@{
  /**
   * A prop whose mapper's input has at least MinimumNumberOfPrimitives cells is divided into units
   * of UnitSize triangles or points, when it has stayed the same for DivideAfter frames. With
   * DivideInBackground a thread makes the units, which takes about 0.2 microseconds per triangle
   * (vtkNBufferUnits); until then the prop is drawn whole. The ranges are 1 to 2147483647, 1 to
   * 65536, and 0 to 2147483647.
   */
  int MinimumNumberOfPrimitives = 20000;
  int UnitSize = 64;
  int DivideAfter = 3;
  bool DivideInBackground = true;
  ///@}

  /// With the OpenGL back-end, the graphics device tests the units of a prop if it has at least
  /// this many, and as many are left after the host has tested groups of 512 units; 1 or more. It
  /// makes the lists of what is drawn of a prop wherever it can, whatever their length
  /// (vtkNBufferUnitDevice).
  int MinimumNumberOfUnitsOnDevice = 1024;

  /// Whether the times of a few frames decide if units are drawn (vtkNBufferUnitTrial). On a
  /// software renderer they only decide while at least half of all units are drawn, and otherwise
  /// units are drawn without a trial.
  bool TimeUnits = true;

  /// Whether the triangles of a prop whose box neither the levels nor the pixels hide are compared
  /// with the pixels one by one, if they are few (vtkNBufferMeshes::FindSmall). Requires
  /// TestPixels.
  bool TestTriangles = true;

  /// Whether a box that the levels do not hide is compared with its pixels one by one
  /// (vtkNBufferPixelTest). With the OpenGL back-end this is a second read-back, of the tiles of
  /// 64 x 64 pixels that such boxes touch, and happens only if many such boxes are left.
  bool TestPixels = true;

  /// Whether the device may draw into float textures, which the OpenGL back-end and multisampling
  /// need. If false, the culler behaves as on a device that cannot draw into them.
  bool AllowFloatTextures = true;

  /// Whether the verdicts of the last frame are used again while camera, window and props stay the
  /// same, from the first test on that finds nothing hidden of what was drawn before it.
  bool ReuseWhenStill = true;

  /// Whether the culler stops testing while tests find next to nothing hidden, except for a probe
  /// now and then (vtkNBufferBackOff in vtkNBufferCullingPolicy.h).
  bool BackOff = true;

  /// Whether the culler moves each vtkFrustumCoverageCuller with default settings behind itself in
  /// the renderer's list of cullers, and tests the frustum in its place. A vtkFrustumCoverageCuller
  /// with other settings stays where it is.
  bool TakeOverFrustumCulling = true;

  ///@{
  /**
   * Access by the name of a member as in this file, for Python and command lines. A switch is 0 or
   * 1. If there is no such name, Get() returns -1, and Set() returns false and changes nothing.
   * Set() also refuses other numbers for a switch; FindFault() reports all other wrong values.
   */
  static std::vector<std::string> GetNames();
  int Get(const std::string& name) const;
  bool Set(const std::string& name, int value);
  ///@}

  bool operator==(const vtkNBufferTuning& other) const;

  /// Return what is wrong with the first value that is out of its range, or an empty string if all
  /// values are valid.
  std::string FindFault() const;

  void PrintSelf(ostream& os, vtkIndent indent) const;
};

VTK_ABI_NAMESPACE_END
#endif
