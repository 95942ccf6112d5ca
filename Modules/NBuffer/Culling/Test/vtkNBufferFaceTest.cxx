// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferFaceTest.h"

#include <algorithm>
#include <cmath>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A bound of the length of a vector that takes no root.
double GetSize(const glm::dvec3& vector)
{
  return std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z);
}
}

vtkNBufferFaceTest::vtkNBufferFaceTest(
  const vtkNBufferProjection& projection, vtkNBufferSamples samples)
  : Projection(projection)
  , Samples(std::move(samples))
  , Errors(projection.GetError().GetTriangleErrors(0.0, 0.0, 0.0))
  , Half(0.5 * projection.GetWidth(), 0.5 * projection.GetHeight())
{
  const vtkNBufferProjection::Rows& toClip = projection.GetWorldToClip();
  const glm::dmat4 rows(toClip[0] * this->Half.x, toClip[1] * this->Half.y, toClip[2], toClip[3]);
  this->ToView = glm::transpose(rows);
  for (int i = 0; i < 4; ++i)
  {
    this->Sizes[i] = vtkNBufferGLM::Abs(this->ToView[i]);
  }
  const glm::dmat3 ofPlace(rows[0], rows[1], rows[3]);
  this->ToRows = glm::inverse(ofPlace);
  this->RowProducts = glm::transpose(ofPlace) * ofPlace;
  for (int i = 0; i < 3; ++i)
  {
    this->RowProducts[i] = vtkNBufferGLM::Abs(this->RowProducts[i]);
  }
  // The product of three vectors in four dimensions: its component i is, with alternating sign, the
  // determinant of the other components.
  for (int i = 0; i < 4; ++i)
  {
    const auto getRest = [i](const glm::dvec4& row)
    { return glm::dvec3(row[i == 0 ? 1 : 0], row[i <= 1 ? 2 : 1], row[i <= 2 ? 3 : 2]); };
    this->Eye[i] = (i % 2 == 0 ? 1.0 : -1.0) *
      glm::dot(getRest(rows[0]), glm::cross(getRest(rows[1]), getRest(rows[3])));
  }
  this->OfEye = 1.0 / this->Eye.w;
  this->SizeOfW = glm::length(glm::dvec3(rows[3]));
}

double vtkNBufferFaceTest::GetStretch(const glm::dvec2& aside) const
{
  // The norm of a matrix J of two rows is at most the root of the largest sum of a row of the
  // absolute values of J times its transpose. The rows of J are those of x - aside.x w and of
  // y - aside.y w.
  const double ww = this->RowProducts[2][2];
  const glm::dvec2 ofW(this->RowProducts[2]);
  const double xx = this->RowProducts[0][0] + aside.x * (2.0 * ofW.x + aside.x * ww);
  const double yy = this->RowProducts[1][1] + aside.y * (2.0 * ofW.y + aside.y * ww);
  const double xy =
    this->RowProducts[0][1] + aside.x * ofW.y + aside.y * ofW.x + aside.x * aside.y * ww;
  return std::sqrt(std::max(xx, yy) + xy);
}

/// What the faces of one box have in common.
struct vtkNBufferFaceTest::View
{
  double OfNearest;  ///< 1 / w for the smallest w,
  double OfFarthest; ///< and for the largest one.
  glm::dvec2 Middle; ///< The place of the center on the screen,
  glm::dvec2 Reach;  ///< and how far the box reaches from there, in pixels.
  glm::dvec2 Error;  ///< E'
  double Tolerance;  ///< How far a corner may be from the plane of its face.
  double Stretch;    ///< k / w_min
  double Lowest;     ///< How high a triangle must be, without the errors of its corners.
  glm::dvec4 Eye;    ///< (e, g) relative to the center of the box.
  double OfFaces;    ///< How much too large the product of a face and the eye may be.
};

bool vtkNBufferFaceTest::MayBeInFront(
  const vtkNBufferFaces& faces, const vtkNBufferFaces::Piece& piece, double clearance) const
{
  // A quotient v / w differs from its value q at the center by (dv - q dw) / w.
  const glm::dvec4 center = vtkNBufferGLM::Multiply(this->ToView, glm::dvec4(piece.Center, 1.0));
  const double ofCenter = 1.0 / center.w;
  const glm::dvec4 quotient(glm::dvec3(center) * ofCenter, 0.0);
  glm::dvec4 reach(0.0);
  for (int j = 0; j < 3; ++j)
  {
    reach += vtkNBufferGLM::Abs(this->ToView[j] - quotient * this->ToView[j].w) *
      static_cast<double>(piece.HalfSize[j]);
  }
  const glm::dvec4 error = vtkNBufferBoxError::GetVertexErrors(this->Sizes, piece.Magnitude,
    center + vtkNBufferGLM::Multiply(this->ToView, glm::dvec4(glm::dvec3(piece.Origin), 0.0)));
  const double nearest = center.w - reach.w - error.w;
  const double farthest = center.w + reach.w + error.w;
  if (!(nearest > 0.0))
  {
    return true;
  }

  View view;
  view.OfNearest = 1.0 / nearest;
  view.OfFarthest = 1.0 / farthest;
  reach *= view.OfNearest;
  view.Middle = quotient;
  view.Reach = reach;
  const glm::dvec2 aside(std::abs(quotient.x) + reach.x, std::abs(quotient.y) + reach.y);
  // A device cuts what reaches before the near plane, after which it may be lower.
  if (quotient.z - reach.z < -1.0)
  {
    return true;
  }
  view.Error = this->Errors.GetPlaceError(error, error.w, view.OfNearest, aside, this->Half);
  view.Stretch = this->GetStretch(aside) * view.OfNearest;
  const double diagonal = 2.0 * GetSize(piece.HalfSize);
  view.Tolerance = vtkNBufferFaces::Flatness * diagonal;

  const vtkNBufferBoxError& ofBox = this->Projection.GetError();
  const vtkNBufferDepthFormat& format = ofBox.GetFormat();
  const double range = 2.0 * format.Scale * reach.z;
  const double ofDepth =
    format.Slack + format.RelativeSlack + format.Scale * (error.z + error.w) * view.OfNearest;
  view.Lowest = this->Errors.LowestRelativeHeight * view.Stretch * diagonal +
    (this->Errors.DepthErrorPerSlope + this->Errors.SlopeRounding) * (range + 2.0 * ofDepth) /
      (ofBox.GetInterpolationSlack(range) + clearance);

  // Each corner may be away from its plane, which changes the determinant by at most Flatness
  // times L^2 (|e| + g diagonal); the plane is rounded to float; and coordinates may be large
  // compared with the box.
  view.Eye = glm::dvec4(glm::dvec3(this->Eye) - this->Eye.w * piece.Center, this->Eye.w);
  view.OfFaces = 4.0 * view.Tolerance * (GetSize(view.Eye) + std::abs(view.Eye.w) * diagonal) +
    0x1p-40 * diagonal * (GetSize(this->Eye) + std::abs(this->Eye.w) * GetSize(piece.Center));

  const double cube = farthest * farthest * farthest;
  const double least =
    view.OfFaces + cube * view.Stretch * (view.Lowest + 2.0 * (view.Error.x + view.Error.y));
  const auto items = faces.GetFaces().begin();
  return std::any_of(items + piece.Begin, items + piece.End,
    [&](const vtkNBufferFaces::Face& face)
    {
      return !(std::abs(glm::dot(glm::dvec4(face), view.Eye)) >= least) &&
        this->MayBeInFront(face, view);
    });
}

bool vtkNBufferFaceTest::MayBeInFront(const vtkNBufferFaces::Face& face, const View& view) const
{
  // All quantities of the plane are h times as large as in the header. On the screen its points
  // have trace.x x + trace.y y + trace.z + distance / w = 0.
  const double product = glm::dot(glm::dvec4(face), view.Eye);
  const double distance = product * this->OfEye;
  const glm::dvec3 trace = this->ToRows * glm::dvec3(face);
  const glm::dvec2 steps(std::abs(trace.x), std::abs(trace.y));
  const double gradient = glm::length(steps);
  const double tolerance = GetSize(face) * view.Tolerance;

  // First, the errors across this line, and along it for what two corners differ across it.
  const double ofAcross = view.Error.x * steps.x + view.Error.y * steps.y;
  const double drift = ((std::abs(distance) + tolerance) * this->SizeOfW * view.OfNearest +
                         4.0 * vtkNBufferFaces::Flatness * GetSize(face)) *
    view.OfNearest;
  const double ofCube = view.OfFarthest * view.OfFarthest * view.OfFarthest;
  if ((std::abs(product) - view.OfFaces) * ofCube * gradient >=
    view.Stretch * (view.Lowest * gradient + 2.0 * ofAcross) +
      2.0 * drift * (view.Error.x + view.Error.y))
  {
    return false;
  }

  // Second, whether the face comes near a sample in the direction across.
  const int axis = steps.y >= steps.x ? 1 : 0;
  const int other = 1 - axis;
  const double near = distance * view.OfNearest;
  const double far = distance * view.OfFarthest;
  const double ofAxis = 1.0 / trace[axis];
  const double place =
    this->Half[axis] - (trace.z + 0.5 * (near + far) + trace[other] * view.Middle[other]) * ofAxis;
  const double reach = (0.5 * std::abs(near - far) + steps[other] * view.Reach[other] +
                         2.0 * tolerance * view.OfNearest) *
      std::abs(ofAxis) +
    view.Error[axis] + 0.5 * vtkNBufferBoxError::GridStep + this->Samples.Distance;
  return std::any_of(this->Samples.Places.begin(), this->Samples.Places.end(),
    [&](const glm::dvec2& sample)
    {
      const double fromSample = place - sample[axis];
      return !(std::ceil(fromSample - reach) > fromSample + reach);
    });
}
VTK_ABI_NAMESPACE_END
