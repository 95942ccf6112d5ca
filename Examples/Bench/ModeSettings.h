// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModeSettings.h
 * @brief Settings in the name of a mode, such as nbuffer:RoundSize=16:BackOff=0.
 *
 * Of vtkNBufferCuller: RoundSize, MaximumNumberOfRounds, MinimumNumberOfCandidates, BaseFactor,
 * MaximumNumberOfPieces, TestPixels, TestSlivers, BackOff, ReuseWhenStill, TakeOverFrustumCulling;
 * of vtkShadowVolumeClampPass: BoxCost, SlabGap.
 */
#ifndef ModeSettings_h
#define ModeSettings_h

#include <string>

class vtkNBufferCuller;
class vtkShadowVolumeClampPass;

namespace NBufferBench
{

/// The name without settings.
std::string GetModeKind(const std::string& mode);

///@{
/// Make the settings of a mode's name. Throws std::runtime_error for one that is not known, is no
/// whole number, or is refused.
void ApplySettings(const std::string& mode, vtkNBufferCuller* culler);
void ApplySettings(const std::string& mode, vtkShadowVolumeClampPass* pass);
///@}

///@{
/// Throws std::runtime_error for one that is not known.
int GetSetting(const std::string& name, vtkNBufferCuller* culler);
int GetSetting(const std::string& name, vtkShadowVolumeClampPass* pass);
///@}

} // namespace NBufferBench

#endif
