// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferClipExtent
 * @brief The extent in normalised device coordinates, slack included, of points of a box that are
 * added one by one in clip space. No OpenGL.
 *
 * vtkNBufferBoxError.h derives the slack.
 */
#ifndef vtkNBufferClipExtent_h
#define vtkNBufferClipExtent_h

#include "vtkNBufferBoxError.h"

#include <algorithm>
#include <array>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

class vtkNBufferClipExtent
{
public:
  /// An empty extent for points of `box`. `worldToClip` are the rows of the matrix that gives their
  /// clip coordinates.
  vtkNBufferClipExtent(const std::array<glm::dvec4, 4>& worldToClip, const vtkNBufferBox& box)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->Error[i] = vtkNBufferBoxError::GetVertexError(worldToClip[i], box);
    }
  }

  /// How far the clip coordinates that a device computes may be from the exact ones.
  const glm::dvec4& GetErrors() const { return this->Error; }

  /// Add a point in clip space. Returns false for a point before the near plane, behind the eye, or
  /// too near to the eye for its error to be bounded, and for NaN.
  bool Add(const glm::dvec4& clip)
  {
    const double w = clip.w - this->Error.w;
    // A comparison with NaN is false, which has to end here.
    if (!(w > this->Error.w && clip.z + clip.w > this->Error.z + this->Error.w))
    {
      return false;
    }
    const double inverse = 1.0 / w;
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    const glm::dvec3 slack =
      (glm::dvec3(this->Error) + vtkNBufferGLM::Abs(ndc) * this->Error.w) * inverse;
    this->Low = glm::min(this->Low, ndc - slack);
    this->High = glm::max(this->High, ndc + slack);
    this->Slack = glm::max(this->Slack, slack);
    this->MaximumW = std::max(this->MaximumW, clip.w);
    return true;
  }

  ///@{
  /// The extent of what a device may draw of the points.
  glm::dvec3 Low = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 High = glm::dvec3(-std::numeric_limits<double>::infinity());
  ///@}
  /// The largest slack of any point along x, y and z.
  glm::dvec3 Slack = glm::dvec3(0.0);
  /// The largest clip coordinate w of any point.
  double MaximumW = 0.0;

private:
  glm::dvec4 Error;
};

VTK_ABI_NAMESPACE_END
#endif
