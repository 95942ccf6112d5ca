// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowTuning
 * @brief The constants of vtkShadowVolumeClampPass that measurements and tests vary and
 * applications leave alone.
 *
 * No value of any of them makes a shadow wrong, except a LitmapSource that misses receivers. The
 * study (docs/accuracy-settings.md) found the defaults to be as fast as any other value on its
 * scenes, or faster.
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

  /// What one more box of pixels costs, in pixels; 0 to 1e9. A caster's volume is drawn once more
  /// in each further box around its receivers. So there is a further box only if it leaves out at
  /// least this many pixels, and 1/32 of this number more for each triangle of the volume. The
  /// default is a compromise: software renderers take a few nanoseconds to fill a pixel and some
  /// tenths of a microsecond to set up a triangle, whereas graphics devices are limited by what
  /// they fill.
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
   * Access by the name of a member as in this file, for Python and command lines, except for
   * LitmapSource. A switch is 0 or 1. If there is no such name, Get() returns -1, and Set() returns false and changes nothing.
   * Set() also refuses other numbers for a switch; FindFault() reports all other wrong values.
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
