// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyPeersCSV.h
 * @brief Whole frames and fragments by mode, and what runs on the device, one a line each.
 */
#ifndef StudyPeersCSV_h
#define StudyPeersCSV_h

#include "vtk_jsoncpp.h"

#include <string>

namespace NBufferBench
{

/// `folder`/peers.csv and `folder`/device.csv; columns are named as in the report, what a mode does
/// not have is empty. Throws std::runtime_error when they cannot be written.
void WritePeersCSV(const Json::Value& report, const std::string& folder);

} // namespace NBufferBench

#endif
