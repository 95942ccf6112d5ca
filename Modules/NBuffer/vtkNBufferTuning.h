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

VTK_ABI_NAMESPACE_BEGIN

struct VTKNBUFFER_EXPORT vtkNBufferTuning
{
  /// A texel of level 0 stands for a square of this many pixels on a side: 1, 2, 4 or 8. A larger
  /// square is cheaper to build and to read back, and leaves more small hidden props drawn.
  int BaseFactor = 4;

  /// A frame with fewer candidates in the frustum is drawn as without the culler, because a
  /// read-back would take longer than it saves; 1 or more.
  int MinimumNumberOfCandidates = 32;

  /// A frame has at most this many rounds of test and draw; 1 to 8.
  int MaximumNumberOfRounds = 6;

  /// Where nothing is known, the first round draws at most this many props, and each further round
  /// twice as many before the next test (vtkNBufferOccluderChoice.h); 1 or more. Of more
  /// than 512 times as many, the first round draws one in 512.
  int RoundSize = 64;

  /// A renderer with at least this many props is tested over a hierarchy of their boxes; 0 means
  /// always. The hierarchy costs 150 bytes per prop, and 0.5 microseconds per prop to build it
  /// where the list of props changes (vtkNBufferCandidateTree).
  int HierarchySize = 10000;

  /// Props that have not changed for this many frames are observed (vtkNBufferObservedObjects): of
  /// each, a frame then reads the times of the actor alone, and not those of some fifteen objects;
  /// 0 means never.
  int ObserveAfter = 60;

  /// Where neither levels nor pixels hide the box of a prop that has been visible for this many
  /// frames, its triangles are compared with the pixels one by one, if they are few
  /// (vtkNBufferMeshes::FindSmall); 0 means never. Needs TestPixels.
  int TestTrianglesAfter = 8;

  /// Where the levels do not hide a box, its pixels are compared one by one (vtkNBufferPixelTest).
  /// The OpenGL back-end reads the whole depth image back for that, once many props are in doubt.
  bool TestPixels = true;

  /// The device may draw into float textures, which the OpenGL back-end and multisampling need.
  /// false makes the culler behave as on a device that cannot.
  bool AllowFloatTextures = true;

  /// The verdicts of the last frame are used again while camera, window and props stay the same.
  bool ReuseWhenStill = true;

  /// Where tests hide next to nothing, the culler stops testing, except for a probe now and then
  /// (vtkNBufferBackOff in vtkNBufferCullingPolicy.h).
  bool BackOff = true;

  /// The culler moves in front of a vtkFrustumCoverageCuller that has default settings, and tests
  /// the frustum itself. A vtkFrustumCoverageCuller with other settings stays in front.
  bool TakeOverFrustumCulling = true;

  bool operator==(const vtkNBufferTuning& other) const;

  /// Says what is wrong with a value that is out of its range; empty if all are valid.
  std::string FindFault() const;

  void PrintSelf(ostream& os, vtkIndent indent) const;
};

VTK_ABI_NAMESPACE_END
#endif
