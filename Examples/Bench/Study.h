// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Study.h
 * @brief The parts of the study of what accuracy costs in time. Each is a function in a file of its
 * own and returns figures as SCHEMA.md describes them; StudyCommand.cxx runs all of them.
 */
#ifndef Study_h
#define Study_h

#include "Session.h"

#include "Contender.h"
#include "DepthFrame.h"

#include "vtk_jsoncpp.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace NBufferBench
{

/// More levels than any image has.
constexpr int AllLevels = 64;

/// Throws std::runtime_error, which says what has failed and why, if `done` is false.
inline void Check(bool done, const char* what, const std::string& why)
{
  if (!done)
  {
    throw std::runtime_error(what + why);
  }
}

/// Measures what runs on the graphics device, by size of the image: drawing, reading depth back,
/// building all levels or one, and reading those back. Leaves the window at another size, and
/// leaves out images of more than `mostPixels`.
Json::Value MeasureDevice(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions, int mostPixels);

/// Measures levels in two arrays, as the module has them, against levels side by side in one
/// texture (PackedLevels.h), and both extrema at once. Leaves the window at another size, and
/// leaves out images of more than `mostPixels`. Throws std::runtime_error if any answer differs.
Json::Value MeasurePacked(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions, int mostPixels);

/// Measures what a depth buffer of each format and encoding (DepthFormats.h) distinguishes, by
/// drawing triangles at 1 m to 10 km: resolution, z-fighting, at `steps` distances for each power
/// of ten and around each of these at as many; and polygon offset.
Json::Value MeasureDepth(Session& session, int steps);

/// Draws the scene in each format, with ratios of far to near plane from that of the pose to the
/// largest one: what the format costs culling, litmaps and shadows.
Json::Value MeasureFormats(
  Session& session, const NBufferExamples::CameraPose& pose, double largestRatio);

///@{
/**
 * The fragments that the draws of a frame leave in the framebuffer: the samples that pass the depth
 * test when their prop is drawn (GL_SAMPLES_PASSED around each draw of a prop, in the order and as
 * often as the mode draws them, the smallest of three counts; boxes of queries are not counted).
 * Those of draws without colours are counted apart from the others.
 *
 * They are measured in `frames` frames spread over the path, each after the one before it on the
 * path. GetFragmentsObstacle() returns why that is impossible, or an empty text: draws are
 * distinguished by events of the mappers, which props must not share.
 */
std::string GetFragmentsObstacle(Session& session);
Json::Value MeasureFragments(Session& session, const NBufferExamples::CameraPath& path,
  const std::vector<std::string>& modes, int frames);
///@}

/// Measures testing props one by one and over a hierarchy, by their number up to `most`. `boxes`
/// are all props of the scene; beyond their number, copies of the scene stand side by side. Copies
/// are tested and not drawn, so that those that the scene does not hide count as visible.
Json::Value MeasureHierarchy(const NBufferStudy::DepthFrame& frame,
  const std::vector<vtkNBufferBox>& boxes, const glm::dvec3& eye, int most, int repetitions);

///@{
/**
 * A scene's own table of visibility, as a structure of the study and as a witness that no image may
 * contradict.
 *
 * From an eye that the table knows, a prop that it leaves out owns no pixel, unless the straight
 * line from the eye to that pixel's surface passes through what the table takes for opaque: then
 * something opaque is not drawn there (solids that the game never draws because no player gets to
 * see them), and the table says nothing. Props that the table does not know, doors and lifts, are
 * not checked. The reverse does not hold: what the table leaves in may be hidden.
 *
 * The frames are those of the contest, rendered from the poses.
 */
constexpr const char* KnownName = "table of the map";
NBufferStudy::ContenderPointer MakeKnownContender(
  const NBufferExamples::PotentiallyVisibleSet& known,
  const std::vector<NBufferStudy::DepthFrame>& frames, const NBufferExamples::CameraPath& path);
Json::Value CheckKnown(Session& session, const NBufferExamples::PotentiallyVisibleSet& known,
  const std::vector<NBufferStudy::DepthFrame>& frames, const NBufferExamples::CameraPath& path);
///@}

///@{
/// Measure table 2 and figure 4 of the paper (Decoret 2005); its table 1 follows from
/// MeasureDevice(). Figure 4 has rectangles up to size x size.
Json::Value MeasureTable2(const std::vector<NBufferStudy::DepthFrame>& frames);
Json::Value MeasureFigure4(int size);
///@}

/// Measures particles as the paper draws them, in the vertex stage (ParticleCloud.h): behind what a
/// frame shows, and behind nothing; `most` particles at most.
Json::Value MeasureParticles(
  Session& session, const NBufferExamples::CameraPose& pose, int most, int repetitions);

/// Measures building the levels again where a round has changed the depth (section 4.2 of the
/// paper): a frame draws what was visible `step` poses of the path ago, builds the levels, and then
/// draws what is missing. Looks at `pairs` frames.
Json::Value MeasureRebuild(
  Session& session, const NBufferExamples::CameraPath& path, int step, int pairs, int repetitions);

/// Measures drawing by the verdicts of an earlier frame: picks `pairs` pairs of poses, `step` poses
/// of the path apart. The worst frame is written to `fileName`, wrong pixels in red; no picture is
/// written if there are none.
Json::Value MeasureLatent(Session& session, const NBufferExamples::CameraPath& path, int step,
  int pairs, const std::string& fileName);

} // namespace NBufferBench

#endif
