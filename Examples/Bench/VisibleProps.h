// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisibleProps.h
 * @brief The props that own a pixel, found by drawing every prop in a colour of its own, and a
 * culler that draws only these.
 */
#ifndef VisibleProps_h
#define VisibleProps_h

#include "Session.h"

#include "vtkCuller.h"

#include <vector>

class vtkProp;

namespace NBufferBench
{

/**
 * Returns, for every pose, the props that own at least one pixel (without multisampling), in the
 * order of the renderer's list. vtkHardwareSelector draws them with their own mappers, so that
 * every pixel is covered as in the image.
 *
 * All shaders are left ready for selection, and the next frame rebuilds them: call this before
 * anything is timed, and render something in between.
 */
std::vector<std::vector<vtkProp*>> FindVisibleProps(
  Session& session, const NBufferExamples::CameraPath& path);

/// Returns, for every pose, the visible props that VTK's default culler draws, in the same order.
std::vector<std::vector<vtkProp*>> FindPropsInView(
  Session& session, const NBufferExamples::CameraPath& path);

/// Returns, for every pixel, row 0 at the bottom, the place of its prop in the renderer's list, or
/// -1 for the background. Shaders are left ready for selection, too.
std::vector<int> FindPixelOwners(Session& session, const NBufferExamples::CameraPose& pose);

/**
 * Draws the given props and no others. With the props that own a pixel its time is a lower bound
 * that no culler can beat: it only copies the pointers of the frame over the list, so that its own
 * cost depends on the number of props that it draws, not on those in the scene.
 */
class OracleCuller : public vtkCuller
{
public:
  static OracleCuller* New();
  vtkTypeMacro(OracleCuller, vtkCuller);

  /// The props must be visible props of the renderer, in the order of its list. They are not
  /// copied: they must live until the frame is drawn.
  void SetProps(const std::vector<vtkProp*>* props) { this->Props = props; }

  double Cull(
    vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized) override;

private:
  const std::vector<vtkProp*>* Props = nullptr;
};

/// Renders the given props, and no others, as OracleCuller does. Leaves the renderer without
/// cullers.
void RenderOnly(Session& session, const std::vector<vtkProp*>& props);

} // namespace NBufferBench

#endif
