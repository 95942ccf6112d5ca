// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowTuning
 * @brief The constants of vtkShadowVolumeClampPass that measurements and tests vary and
 * applications leave alone.
 *
 * No value of any of them makes a shadow wrong, except a LitmapSource that misses receivers. The
 * study (docs/accuracy-settings.md, and docs/accuracy-scenes.md for LitmapResolution) found no
 * other value that is faster on all of its scenes.
 *
 * @code
 * vtkShadowTuning tuning = pass->GetTuning();
 * tuning.LitmapResolution = 512;
 * pass->SetTuning(tuning);
 * @endcode
 */
#ifndef vtkShadowTuning_h
#define vtkShadowTuning_h

#include "vtkIndent.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowLitmapSource;

struct VTKNBUFFER_EXPORT vtkShadowTuning
{
  /// The number of lexels along each side of a litmap; 1 to 4096. More lexels make tighter boxes
  /// and slabs.
  int LitmapResolution = 256;

  /// Two slabs are separated by at least this many empty bins of the 64 between the nearest and the
  /// farthest receiver; 1 to 64. With 64 there is one slab around all receivers of a caster, as in
  /// the paper (see vtkShadowVolumeClampPass).
  int SlabGap = 4;

  /// What one more box costs, in pixels; 0 to 1e9. A caster's volume is drawn into boxes of pixels
  /// around its receivers, and once more for each further box. So a box is divided only if that
  /// leaves out more than BoxCost * (1 + n / 32) pixels, where n is about the number of triangles
  /// of the volume. The default is a compromise: software renderers take a few nanoseconds to fill
  /// a pixel and some tenths of a microsecond to set up a triangle, whereas the time of graphics
  /// devices depends mostly on the pixels that they fill.
  int BoxCost = 256;

  /// Whether the fragments of volumes are counted (vtkShadowStatistics::Fragments). The volumes are
  /// drawn once more for that, the host waits for the device, and the masks of the last frame are
  /// never used again.
  bool CountFragments = false;

  /// Whether the time of the graphics device is measured (vtkShadowStatistics::DeviceTimes). This
  /// costs two timer queries and two flushes for each light and for each draw of the props. The
  /// pass reads the results when they have arrived and does not wait for them.
  bool MeasureDeviceTime = false;

  /// An experiment's own way to fill litmaps (Shadows/Litmap/vtkShadowLitmapSource.h). With nullptr
  /// the pass scatters the depth of the receivers into them.
  std::shared_ptr<vtkShadowLitmapSource> LitmapSource;

  ///@{
  /**
   * Access by the name of a member as in this file, for Python and command lines. LitmapSource has
   * no such access. A switch is 0 or 1. If there is no such name, Get() returns -1, and Set()
   * returns false and changes nothing. Set() does the same if the value of a switch is neither 0
   * nor 1. All other wrong values are set; FindFault() reports them.
   */
  static std::vector<std::string> GetNames();
  int Get(const std::string& name) const;
  bool Set(const std::string& name, int value);
  ///@}

  bool operator==(const vtkShadowTuning& other) const;

  /// Return what is wrong with the first value that is out of its range, or an empty string if all
  /// values are valid.
  std::string FindFault() const;

  void PrintSelf(ostream& os, vtkIndent indent) const;
};

VTK_ABI_NAMESPACE_END
#endif
