// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyFiles.h
 * @brief The documents and charts of a study, from its figures.
 */
#ifndef StudyFiles_h
#define StudyFiles_h

#include "StudyOptions.h"

#include "vtk_jsoncpp.h"

#include <string>
#include <vector>

namespace NBufferBench
{

/// accuracy.md and what goes with it, where the texts for them come with the program. Throws
/// std::runtime_error when one cannot be read or written.
void WriteDocuments(const StudyOptions& options, const Json::Value& report);

/// `folder`/CHART of a scene of the study, .png and .svg: error against time.
void WriteSceneChart(const Json::Value& scene, const std::string& folder);

/// Documents and charts of error once more, from study.json files: the first one with the shadows
/// and the settings of the last one that has some. Throws std::runtime_error when one cannot be
/// read.
void RewriteStudy(const StudyOptions& options, const std::vector<std::string>& fileNames);

} // namespace NBufferBench

#endif
