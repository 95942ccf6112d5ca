// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModeSettings.h
 * @brief Settings in the name of a mode, such as nbuffer:RoundSize=16:BackOff=0.
 *
 * They have the names of members of vtkNBufferTuning, vtkShadowTuning and ShadowMapSettings, or
 * TestSlivers, and their values are whole numbers; a switch is 0 or 1.
 */
#ifndef ModeSettings_h
#define ModeSettings_h

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

class vtkNBufferCuller;
class vtkShadowMapBakerPass;
class vtkShadowVolumeClampPass;

namespace NBufferBench
{

/// Returns the entry of an array that has a Name, or nullptr if there is none.
template <typename Entry, std::size_t N>
const Entry* FindNamed(const Entry (&entries)[N], const std::string& name)
{
  const Entry* found = std::find_if(std::begin(entries), std::end(entries),
    [&name](const Entry& entry) { return name == entry.Name; });
  return found == std::end(entries) ? nullptr : found;
}

/// Settings of vtkShadowMapPass, and what its map is drawn with.
struct ShadowMapSettings
{
  /// The exponential constant, 1 to 88 (its exponential has to be a float). 11 is VTK's own, and
  /// the only one of versions that have no setting for it.
  int Exponent = 11;
  ///@{
  /// The polygon offset with which the map is drawn, 0 to 1000. VTK draws it without.
  int OffsetFactor = 0;
  int OffsetUnits = 0;
  ///@}
  int EachFrame = 0; ///< Whether a map is drawn for each frame, as where something moves.

  ///@{
  /// As the other classes with settings.
  const ShadowMapSettings& GetTuning() const { return *this; }
  void SetTuning(const ShadowMapSettings& settings) { *this = settings; }
  ///@}
};

/// Returns the name without settings.
std::string GetModeKind(const std::string& mode);

/// Removes each name that occurs earlier in the list.
void RemoveRepeated(std::vector<std::string>& modes);

/// Sets the exponential constant, where this version of VTK has a setting for it.
void SetExponent(vtkShadowMapBakerPass* baker, int exponent);

/// Applies the settings in a mode's name to a vtkNBufferCuller, a vtkShadowVolumeClampPass or
/// ShadowMapSettings. Throws std::runtime_error for a setting that is unknown, is not a whole
/// number, or is refused.
template <typename Object>
void ApplySettings(const std::string& mode, Object* object);

/// Returns the default of every setting, in the members `culler`, `shadow` and `maps`.
Json::Value GetDefaults();

} // namespace NBufferBench

#endif
