// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyKnown.h
 * @brief A scene's own table of visibility: as a structure of the study, and as a witness that no
 * image may contradict.
 *
 * From an eye that the table knows, a prop that it leaves out owns no pixel, unless the straight
 * way from the eye to that pixel's surface passes through what the table takes for opaque: then
 * something opaque is not drawn there (bulk that the game never draws, because no player gets to
 * see it), and the table has not been asked. Props that the table does not know, doors and lifts,
 * are not looked at. Nothing follows the other way round: what the table leaves in may be hidden.
 */
#ifndef StudyKnown_h
#define StudyKnown_h

#include "CameraPose.h"
#include "PotentiallyVisibleSet.h"
#include "Session.h"

#include "Contender.h"

#include "vtk_jsoncpp.h"

#include <vector>

namespace NBufferBench
{

/// The name of the contender in results.
const char* GetKnownName();

/// Hides what the table leaves out. The frames are those of the contest, rendered from the poses.
NBufferStudy::ContenderPointer MakeKnownContender(
  const NBufferExamples::PotentiallyVisibleSet& known,
  const std::vector<NBufferStudy::DepthFrame>& frames, const NBufferExamples::CameraPath& path);

/**
 *     in_view, table, visible   means over the frames, of the boxes in view: all, those that the
 *                               table leaves in, those that own a pixel
 *     pixels                    checked: owned by props that the table knows
 *     undrawn_pixels            owned by props that it leaves out, seen through undrawn opaque
 *     contradictions            owned by props that it leaves out, and not: has to be 0
 *     places[]                  frame, x, y and prop of the first of these
 */
Json::Value CheckKnown(Session& session, const NBufferExamples::PotentiallyVisibleSet& known,
  const std::vector<NBufferStudy::DepthFrame>& frames, const NBufferExamples::CameraPath& path);

} // namespace NBufferBench

#endif
