// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReceivers.h"

#include "vtkNBufferDepthConvention.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// What the depth image holds where nothing is drawn; receivers are nearer.
const float Background = vtkNBufferMath::GetBackgroundDepth(vtkNBufferDepthConvention::Forward);

/// Half the side of a cube's face around a point light, a little widened.
constexpr double FaceLimit = 1.0 + 0x1p-8;

/// Of a depth, by the transformation to clip coordinates in float, for a narrow view.
constexpr double DepthRounding = 0x1p-22;

/// Of a position, in units of its distance from the eye; of world coordinates in double.
constexpr double PositionRounding = 0x1p-20;
constexpr double WorldRounding = 0x1p-48;

/// Of a coordinate that a shader transforms in float: products, sums and what goes into them.
constexpr double ShaderRounding = 5.0 * 0x1p-24;

/// How far along a surface the centre of a pixel may be from a sample, in widths of a pixel there:
/// so far where it is seen at an angle of one degree.
constexpr double GrazingPixels = 64.0;

/// Of the cosine between a line of sight and a cone's axis, generously.
constexpr double LineRounding = 1e-3;

/// The range of a litmap is taken from every fourth row and column: what lies outside is not lost
/// (vtkShadowLitmap::Begin), and it need not be exact.
constexpr int RangeStride = 4;

/// Of a pixel: how far beside its place the side of a volume may be drawn. Devices snap corners to
/// 1/256 of a pixel or better; the rest is for their rounding where they clip long triangles.
constexpr double Guard = 0.25;

double GetLength1(const double v[3])
{
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

/// How far the corners of the image are from the eye, in units of the distance of its centre.
double GetCornerDistance(const vtkShadowView& view)
{
  const double* m = view.ClipToWorld;
  const auto getDistance = [m](double x, double y)
  {
    double point[4];
    for (int i = 0; i < 4; ++i)
    {
      point[i] = m[4 * i] * x + m[4 * i + 1] * y + m[4 * i + 3];
    }
    return vtkMath::Norm(point) / point[3];
  };
  return std::max(std::max(getDistance(-1.0, -1.0), getDistance(1.0, -1.0)),
           std::max(getDistance(-1.0, 1.0), getDistance(1.0, 1.0))) /
    getDistance(0.0, 0.0);
}

/// What vtkShadowLitmap::Add and vtkShadowTiles::Add take.
struct Receiver
{
  double A[3];
  double B[3];
  double Radius; ///< In p and q.
  double Angle;  ///< Radians from a spot's axis, at most, if it lies outside of its cone; else 0.
};

/// From (pixel x, pixel y, depth) to light coordinates.
class Projector
{
public:
  Projector(
    const vtkShadowView& view, const vtkShadowLight& light, const vtkShadowLightSpace& frame);

  /// Begin with a row of pixels of one sample.
  void SetRow(const std::array<double, 2>& sample, int y);

  /// False if the light cannot reach it.
  bool Project(int x, double depth, Receiver& receiver) const;

  /// Bound of |p| and |q|.
  double GetLimit() const { return this->Limit; }

private:
  bool MayReach(const double a[3], const double b[3], double radius) const;
  void SetShaderError(const vtkShadowView& view);
  double GetAngle(const double a[3], const double b[3], double radius) const;
  /// Whether the line of sight through the centre of a pixel meets the cone, widened by an angle.
  bool MayCentreReach(int x, double widening) const;
  /// How far from its place VTK's shader may see what is at this distance from the eye.
  double GetShaderError(double distance) const;

  vtkShadowLightKind Kind;
  double DepthError;
  double Limit = std::numeric_limits<double>::infinity();
  double ReachCosine;
  double Direction[3]; ///< The light's, along u, v and the axis.
  double Eye[3];       ///< Relative to the apex, along u, v and the axis.
  double WorldError;
  double ShaderOffset = 0.0;  ///< What is added to the distance for S.
  double PlaceFactor = 0.0;   ///< By what E is multiplied in a place,
  double InverseFactor = 0.0; ///< and in 1 / w.
  double GuardAtW1;           ///< Guard in world units, for w = 1.
  /// Rows: places along u, v and the axis relative to the apex, and w. Columns: pixel x, pixel y,
  /// depth, 1.
  double Matrix[4][4];
  double Row[4] = {};    ///< Matrix * (sample, y, 0, 1).
  bool ByCentre = false; ///< Fragments ask for the cone where the pixel's centre is.
  double CentreRow[4] = {};
};

Projector::Projector(
  const vtkShadowView& view, const vtkShadowLight& light, const vtkShadowLightSpace& frame)
  : Kind(light.Kind)
  , DepthError(2.0 * view.DepthQuantum + DepthRounding * (1.0 + GetCornerDistance(view)))
  , ReachCosine(light.GetConeCosine())
  , WorldError(WorldRounding * (GetLength1(view.Origin) + GetLength1(frame.GetApex())))
{
  double eye[3];
  vtkMath::Subtract(view.Origin, frame.GetApex(), eye);
  const double* axes[3] = { frame.GetU(), frame.GetV(), frame.GetAxis() };
  double ndc[4][4];
  for (int j = 0; j < 4; ++j)
  {
    ndc[3][j] = view.ClipToWorld[12 + j];
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Eye[i] = vtkMath::Dot(eye, axes[i]);
    this->Direction[i] = vtkMath::Dot(light.Direction, axes[i]);
    for (int j = 0; j < 4; ++j)
    {
      ndc[i][j] = axes[i][0] * view.ClipToWorld[j] + axes[i][1] * view.ClipToWorld[4 + j] +
        axes[i][2] * view.ClipToWorld[8 + j] + this->Eye[i] * ndc[3][j];
    }
  }
  // NDC are 2 x / width - 1, 2 y / height - 1 and 2 depth - 1.
  for (int i = 0; i < 4; ++i)
  {
    this->Matrix[i][0] = 2.0 * ndc[i][0] / view.Width;
    this->Matrix[i][1] = 2.0 * ndc[i][1] / view.Height;
    this->Matrix[i][2] = 2.0 * ndc[i][2];
    this->Matrix[i][3] = ndc[i][3] - ndc[i][0] - ndc[i][1] - ndc[i][2];
  }
  double pixel[2];
  for (int j = 0; j < 2; ++j)
  {
    const double step[3] = { this->Matrix[0][j], this->Matrix[1][j], this->Matrix[2][j] };
    pixel[j] = vtkMath::Norm(step);
  }
  this->GuardAtW1 = Guard * std::max(pixel[0], pixel[1]);
  if (this->Kind == vtkShadowLightKind::Point)
  {
    this->Limit = FaceLimit;
  }
  if (this->Kind == vtkShadowLightKind::Spot)
  {
    const double widest =
      std::acos(std::clamp(this->Direction[2], -1.0, 1.0)) + std::acos(this->ReachCosine);
    this->Limit = widest < 0.5 * vtkMath::Pi() ? std::tan(widest) : this->Limit;
    this->SetShaderError(view);
    this->ByCentre = view.Samples.size() > 1;
  }
}

void Projector::SetShaderError(const vtkShadowView& view)
{
  this->ShaderOffset = 2.0 * GetLength1(view.Origin) + GetLength1(this->Eye);
  double worldToClip[16];
  vtkMatrix4x4::Invert(view.ClipToWorld, worldToClip);
  double factors[4] = {};
  for (int i = 0; i < 4; ++i)
  {
    const double error = vtkMath::Norm(worldToClip + 4 * i);
    for (int k = 0; k < 4; ++k)
    {
      factors[k] += std::abs(view.ClipToWorld[4 * k + i]) * error;
    }
  }
  const double viewCoordinates = std::sqrt(3.0);
  this->PlaceFactor = viewCoordinates + vtkMath::Norm(factors);
  this->InverseFactor = factors[3];
}

double Projector::GetShaderError(double distance) const
{
  const double error = ShaderRounding * (this->ShaderOffset + distance);
  const double left = 1.0 - error * this->InverseFactor;
  return left > 0.0 ? error * (this->PlaceFactor + distance * this->InverseFactor) / left
                    : std::numeric_limits<double>::infinity();
}

void Projector::SetRow(const std::array<double, 2>& sample, int y)
{
  for (int i = 0; i < 4; ++i)
  {
    this->Row[i] =
      this->Matrix[i][0] * sample[0] + this->Matrix[i][1] * (y + sample[1]) + this->Matrix[i][3];
    this->CentreRow[i] =
      this->Matrix[i][0] * 0.5 + this->Matrix[i][1] * (y + 0.5) + this->Matrix[i][3];
  }
}

double Projector::GetAngle(const double a[3], const double b[3], double radius) const
{
  double middle[3];
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = 0.5 * (a[i] + b[i]);
  }
  const double distance = vtkMath::Norm(middle);
  return distance > radius
    ? std::acos(std::clamp(vtkMath::Dot(middle, this->Direction) / distance, -1.0, 1.0)) +
      std::asin(radius / distance)
    : vtkMath::Pi();
}

bool Projector::MayCentreReach(int x, double widening) const
{
  double near[4];
  double far[4];
  for (int i = 0; i < 4; ++i)
  {
    near[i] = this->CentreRow[i] + this->Matrix[i][0] * x;
    far[i] = near[i] + this->Matrix[i][2];
  }
  double along[3];
  double across[3];
  for (int i = 0; i < 3; ++i)
  {
    near[i] /= near[3];
    along[i] = far[i] / far[3] - near[i];
    across[i] = near[i];
  }
  // Directions from the light to the line's points are half a great circle.
  vtkMath::Normalize(along);
  const double offset = vtkMath::Dot(across, along);
  for (int i = 0; i < 3; ++i)
  {
    across[i] -= offset * along[i];
  }
  vtkMath::Normalize(across);
  const double c = vtkMath::Dot(along, this->Direction);
  const double s = std::max(vtkMath::Dot(across, this->Direction), 0.0);
  return std::max(std::abs(c), std::hypot(c, s)) >= this->ReachCosine - widening;
}

bool Projector::MayReach(const double a[3], const double b[3], double radius) const
{
  const double x = 0.5 * (a[0] + b[0]);
  const double y = 0.5 * (a[1] + b[1]);
  const double s = 0.5 * (a[2] + b[2]);
  if (std::isinf(radius))
  {
    return true;
  }
  if (s + radius <= 0.0)
  {
    return false;
  }
  if (this->Kind == vtkShadowLightKind::Point)
  {
    return std::max(std::abs(x), std::abs(y)) - radius <= this->Limit * (s + radius);
  }
  const double along = x * this->Direction[0] + y * this->Direction[1] + s * this->Direction[2];
  return along + radius >=
    this->ReachCosine * std::sqrt(x * x + y * y + s * s) - std::abs(this->ReachCosine) * radius;
}

bool Projector::Project(int x, double depth, Receiver& receiver) const
{
  double start[4];
  for (int i = 0; i < 4; ++i)
  {
    start[i] = this->Row[i] + this->Matrix[i][0] * x;
  }
  const double nearest = std::max(depth - this->DepthError, 0.0);
  const double farthest = std::min(depth + this->DepthError, 1.0);
  const double scaleA = 1.0 / (start[3] + this->Matrix[3][2] * nearest);
  const double scaleB = 1.0 / (start[3] + this->Matrix[3][2] * farthest);
  double* a = receiver.A;
  double* b = receiver.B;
  double length = 0.0;
  double distance = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    a[i] = (start[i] + this->Matrix[i][2] * nearest) * scaleA;
    b[i] = (start[i] + this->Matrix[i][2] * farthest) * scaleB;
    length += std::abs(b[i] - a[i]);
    distance += std::abs(b[i] - this->Eye[i]);
  }
  const double rounding = PositionRounding * (distance + length) + this->WorldError;
  const double guard = this->GuardAtW1 * std::max(std::abs(scaleA), std::abs(scaleB));
  const double around = rounding + guard;
  receiver.Radius = around;
  receiver.Angle = 0.0;
  if (this->Kind != vtkShadowLightKind::Directional)
  {
    const double radius = 0.5 * length + rounding;
    if (this->Kind == vtkShadowLightKind::Point)
    {
      if (!this->MayReach(a, b, radius + guard))
      {
        return false;
      }
    }
    else if (!this->MayReach(a, b, radius))
    {
      const double error = radius + this->GetShaderError(distance + length);
      const double pixels = GrazingPixels / Guard * guard;
      if (!this->MayReach(a, b, error) &&
        !(this->ByCentre && this->MayReach(a, b, error + pixels) &&
          this->MayCentreReach(x, LineRounding + error / vtkMath::Norm(b))))
      {
        return false;
      }
      receiver.Angle = this->GetAngle(a, b, radius);
    }
    const double nearestS = std::min(a[2], b[2]) - around;
    if (nearestS > 0.0)
    {
      for (double* end : { a, b })
      {
        const double scale = 1.0 / end[2];
        end[0] *= scale;
        end[1] *= scale;
      }
      const double largest = std::max(
        std::max(std::abs(a[0]), std::abs(a[1])), std::max(std::abs(b[0]), std::abs(b[1])));
      receiver.Radius = around * (1.0 + largest) / nearestS;
    }
    else
    {
      a[0] = a[1] = b[0] = b[1] = 0.0;
      receiver.Radius = std::numeric_limits<double>::infinity();
    }
  }
  const double sign = a[2] <= b[2] ? 1.0 : -1.0;
  a[2] -= sign * around;
  b[2] += sign * around;
  return true;
}

/// Which pixels to look at.
struct Lattice
{
  int Stride = 1; ///< Every so many rows and columns,
  int Band = 0;   ///< and of the rows of tiles
  int Bands = 1;  ///< every so many, from this one on.
};

/// functor(receiver, x, y, depth) for each receiver in these rows.
template <typename Functor>
void ForEachReceiver(const float* depth, const vtkShadowView& view, Projector& projector,
  const Lattice& lattice, Functor&& functor)
{
  Receiver receiver;
  std::size_t image = 0;
  for (const std::array<double, 2>& sample : view.Samples)
  {
    for (int y = 0; y < view.Height; y += lattice.Stride)
    {
      if (y / vtkShadowTiles::Size % lattice.Bands != lattice.Band)
      {
        continue;
      }
      projector.SetRow(sample, y);
      const std::size_t row = image + static_cast<std::size_t>(y) * view.Width;
      for (int x = 0; x < view.Width; x += lattice.Stride)
      {
        const std::size_t i = row + x;
        if (depth[i] < Background && projector.Project(x, depth[i], receiver))
        {
          functor(receiver, x, y, depth[i]);
        }
      }
    }
    image += static_cast<std::size_t>(view.Width) * view.Height;
  }
}

/// The depth halfway between two, in distances from the eye.
float GetMiddle(const vtkShadowView& view, float nearest, float farthest)
{
  // 1 / w is a linear function of depth, and constant for parallel projections.
  const double slope = 2.0 * view.ClipToWorld[14];
  const double start = view.ClipToWorld[15] - view.ClipToWorld[14];
  const double nearW = 1.0 / (start + slope * nearest);
  const double farW = 1.0 / (start + slope * farthest);
  const double middle = slope != 0.0 ? (2.0 / (nearW + farW) - start) / slope
                                     : 0.5 * (static_cast<double>(nearest) + farthest);
  return static_cast<float>(middle);
}

/// Part the layers of all tiles, by the depth of what may be receivers.
void SplitLayers(const float* depth, const vtkShadowView& view, vtkShadowTiles& tiles)
{
  constexpr int size = vtkShadowTiles::Size;
  const std::size_t image = static_cast<std::size_t>(view.Width) * view.Height;
  const auto splitRow = [&](int row, std::vector<std::array<float, 2>>& ranges)
  {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    ranges.assign(static_cast<std::size_t>(tiles.GetNumberOfColumns()), { infinity, -infinity });
    for (int y = row * size; y < std::min((row + 1) * size, view.Height); ++y)
    {
      for (std::size_t sample = 0; sample < view.Samples.size(); ++sample)
      {
        const std::size_t first = sample * image + static_cast<std::size_t>(y) * view.Width;
        for (std::size_t x = 0; x < static_cast<std::size_t>(view.Width); ++x)
        {
          const float z = depth[first + x];
          if (z < Background)
          {
            std::array<float, 2>& range = ranges[x / size];
            range = { std::min(range[0], z), std::max(range[1], z) };
          }
        }
      }
    }
    for (int column = 0; column < tiles.GetNumberOfColumns(); ++column)
    {
      const auto [nearest, farthest] = ranges[static_cast<std::size_t>(column)];
      if (nearest < farthest)
      {
        tiles.SetSplit(column, row, GetMiddle(view, nearest, farthest));
      }
    }
  };
  vtkSMPTools::For(0, tiles.GetNumberOfRows(),
    [&splitRow](vtkIdType begin, vtkIdType end)
    {
      std::vector<std::array<float, 2>> ranges;
      for (vtkIdType row = begin; row < end; ++row)
      {
        splitRow(static_cast<int>(row), ranges);
      }
    });
}

/// How many threads shall scatter. Clearing and merging the lexels of one more costs about as much
/// as a third as many samples.
int GetNumberOfBands(const vtkShadowView& view, int resolution)
{
  const double samples = static_cast<double>(view.Samples.size()) * view.Width * view.Height;
  const double lexels = static_cast<double>(resolution) * resolution;
  const int threads = std::min(vtkSMPTools::GetEstimatedNumberOfThreads(), view.Height);
  int bands = 1;
  while (bands < threads && 3.0 * samples > lexels * bands * (bands + 1))
  {
    ++bands;
  }
  return bands;
}
}

namespace vtkShadowReceivers
{
void GetRange(const float* depth, const vtkShadowView& view, const vtkShadowLight& light,
  const vtkShadowLightSpace& frame, double range[4], double depths[2])
{
  Projector projector(view, light, frame);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[3] = { infinity, infinity, infinity };
  double high[3] = { -infinity, -infinity, -infinity };
  for (int stride : { RangeStride, 1 })
  {
    ForEachReceiver(depth, view, projector, { stride },
      [&](const Receiver& receiver, int, int, float)
      {
        const double radius[3] = { receiver.Radius, receiver.Radius, 0.0 };
        for (int i = 0; i < 3; ++i)
        {
          low[i] = std::min(low[i], std::min(receiver.A[i], receiver.B[i]) - radius[i]);
          high[i] = std::max(high[i], std::max(receiver.A[i], receiver.B[i]) + radius[i]);
        }
      });
    if (low[2] <= high[2])
    {
      break;
    }
  }
  const double limit = projector.GetLimit();
  for (int i = 0; i < 2; ++i)
  {
    range[2 * i] = std::max(low[i], -limit);
    range[2 * i + 1] = std::min(high[i], limit);
  }
  depths[0] = low[2];
  depths[1] = high[2];
}

vtkIdType Scatter(const float* depth, const vtkShadowView& view, const vtkShadowLight& light,
  const vtkShadowLightSpace& frame, int resolution, vtkShadowLitmap& litmap)
{
  double range[4];
  double depths[2];
  GetRange(depth, view, light, frame, range, depths);
  litmap.Begin(resolution, range, depths);
  litmap.GetTiles().Begin(view.Width, view.Height);
  SplitLayers(depth, view, litmap.GetTiles());
  const int bands = GetNumberOfBands(view, litmap.GetResolution());
  litmap.Split(bands);
  const auto addBand = [&](int band)
  {
    vtkShadowLitmap& part = litmap.GetPart(band);
    Projector projector(view, light, frame);
    ForEachReceiver(depth, view, projector, { 1, band, bands },
      [&part](const Receiver& receiver, int x, int y, float windowDepth)
      {
        if (part.Add(receiver.A, receiver.B, receiver.Radius, x, y))
        {
          const double radius[3] = { receiver.Radius, receiver.Radius, 0.0 };
          part.GetTiles().Add(receiver.A, receiver.B, radius, x, y, windowDepth);
          part.WidenAngle(receiver.Angle);
        }
      });
  };
  vtkSMPTools::For(0, bands, 1,
    [&addBand](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType band = begin; band < end; ++band)
      {
        addBand(static_cast<int>(band));
      }
    });
  litmap.Join();
  return litmap.GetNumberOfReceivers();
}
}
VTK_ABI_NAMESPACE_END
