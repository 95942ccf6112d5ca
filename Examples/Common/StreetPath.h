// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StreetPath.h
 * @brief The camera paths that only a city has; CameraPath.h describes them.
 */
#ifndef StreetPath_h
#define StreetPath_h

#include "CameraPose.h"
#include "City.h"

#include <cstdint>
#include <string>

namespace NBufferExamples
{

/// `name` is street, rooftop, drone or cuts.
CameraPath MakeCityPath(const City& city, const std::string& name, int frames, std::uint64_t seed);

} // namespace NBufferExamples

#endif
