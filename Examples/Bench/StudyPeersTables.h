// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyPeersTables.h
 * @brief The study's tables of queries of the hardware, of fragments and of the device.
 */
#ifndef StudyPeersTables_h
#define StudyPeersTables_h

#include "vtk_jsoncpp.h"

#include <string>

namespace NBufferBench
{

/// Whole frames by every mode of each path.
std::string MakePeersTable(const Json::Value& report);

/// Fragments drawn and wasted by every mode of each path.
std::string MakeFragmentsTable(const Json::Value& report);

/// Drawing, reading back, all levels and one, by size of the image.
std::string MakeDeviceTable(const Json::Value& report);

/// One level by the three ways of SingleLevel.h, by size and factor.
std::string MakeSingleTable(const Json::Value& report);

} // namespace NBufferBench

#endif
