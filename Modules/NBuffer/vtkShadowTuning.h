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

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowLitmapSource;

struct VTKNBUFFER_EXPORT vtkShadowTuning
{
  /// A litmap has this many lexels along each side; 1 to 4096. More lexels make tighter boxes and
  /// slabs.
  int LitmapResolution = 256;

  /// Two slabs are separated by at least this many empty bins of the 64 between the nearest and the
  /// farthest receiver; 1 to 64. 64 makes one slab of all receivers, as in the paper.
  int SlabGap = 4;

  /// One more box around the receivers of a caster has to leave out at least this many pixels, plus
  /// 1/32 of that for each triangle of the caster's volume, which is drawn once more in that box;
  /// 0 to 1e9. The default is a compromise: software renderers fill in a few nanoseconds for each
  /// pixel and set up a triangle in some tenths of a microsecond, devices are limited by what they
  /// fill.
  int BoxCost = 256;

  /// The fragments of volumes are counted (vtkShadowStatistics::Fragments). The volumes are drawn
  /// once more for that, and the host waits for the device.
  bool CountFragments = false;

  /// The time of the graphics device is measured (vtkShadowStatistics::DeviceTimes). It costs two
  /// timer queries and two flushes for each light and for each draw of the props; the results are
  /// read when they are known, without waiting.
  bool MeasureDeviceTime = false;

  /// An experiment fills litmaps in its own way (Shadows/Litmap/vtkShadowLitmapSource.h); nullptr
  /// scatters the depth of the receivers.
  std::shared_ptr<vtkShadowLitmapSource> LitmapSource;

  bool operator==(const vtkShadowTuning& other) const;

  /// Says what is wrong with a value that is out of its range; empty if all are valid.
  std::string FindFault() const;

  void PrintSelf(ostream& os, vtkIndent indent) const;
};

VTK_ABI_NAMESPACE_END
#endif
