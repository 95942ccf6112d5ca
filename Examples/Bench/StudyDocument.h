// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyDocument.h
 * @brief The figures of a study as a document: a text written by hand, with tables filled in.
 *
 * Lines of the text that are `@name argument@` are replaced:
 *
 *     machine            where and with what it was measured
 *     frames             whole frames of all paths; peers, fragments, latent likewise
 *     device, single     by size: what runs on the device; one level by three ways
 *     pareto PATH        the Pareto line of a path, in the order of its chart, and the default
 *     best PATH          the six points that cost least, kept props included
 *     chain PATH         one level, mip chains and squares on the same base
 *     hierarchy PATH     by number of props
 *     formats            slack and kept props by format and ratio
 *     table1, table2, figure4
 *     left_out           scenes that were not there
 *     known              of maps: what their tables leave in, the culler keeps, and owns a pixel
 *     shadows SCENE      the Pareto line of a scene with shadows, and what is wrong
 *     fill               fragments of volumes, and the paper's
 *     setting NAME       of a setting of the culler or of shadows: time and error by value
 *     settings_machine   as machine, of these
 *     few                few props in view: whether testing pays
 *     image NAME TEXT    a picture of the study
 *
 * PATH is a path through the city, or a scene and its path. Fields of scenes that were not measured
 * say so.
 */
#ifndef StudyDocument_h
#define StudyDocument_h

#include "vtk_jsoncpp.h"

#include <string>

namespace NBufferBench
{

/// `links`: folder of the pictures as seen from the document. Throws std::runtime_error for a
/// field, a line between two @, that it does not know.
std::string FillDocument(
  const std::string& text, const Json::Value& report, const std::string& links);

} // namespace NBufferBench

#endif
