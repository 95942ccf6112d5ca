// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCheck.h
 * @brief Masks of shadows against each other and against rays in double precision.
 */
#ifndef ShadowCheck_h
#define ShadowCheck_h

#include "Player.h"
#include "RayOracle.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace TestScene
{
/// Sums over frames.
struct ShadowTally
{
  long long Samples = 0;      ///< Receivers whose masks were compared, for each light.
  long long Shadowed = 0;     ///< Of these, in shadow.
  long long ClampedFlips = 0; ///< Samples at edges in which Clamped differs from Unclamped.
  long long ClampedFlipsElsewhere = 0;
  long long Strays = 0;        ///< Samples of whole volumes that rays say are wrong.
  long long UnlitStrays = 0;   ///< Such where the light is behind the surface, see ShadowStrays.
  long long PartedStrays = 0;  ///< Ambiguous ones where volumes were counted in portions.
  long long Rays = 0;          ///< Samples compared with rays.
  long long RaysAmbiguous = 0; ///< Of these, ambiguous ones that differ.
};

/// What the light of one renderer falls on, and where it does not.
struct ShadowFrame
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Depth; ///< Of each pixel, row by row, the lowest first.
  /// For each light and pixel, row by row, the lowest first: not 0 if something opaque is seen
  /// there that the light can reach.
  std::vector<std::vector<unsigned char>> Receivers;
  /// For each light and pixel: not 0 if what is seen there turns towards the light.
  std::vector<std::vector<unsigned char>> Facing;
  std::vector<std::vector<unsigned char>> Masks; ///< All 0 for lights that threw no shadow.
};

/// What rays say of a light of the scene as it is.
using RayJudge = std::function<OracleImage(int light)>;
RayJudge MakeRayJudge(const Player& stage);

/// Whether the depth in the window is that of the one renderer, sample by sample.
bool HasReadableReceivers(const Player& stage);

/// After a frame with shadows, of a stage with HasReadableReceivers().
ShadowFrame CaptureShadows(const Player& stage);

/**
 * What is wrong with the masks of `tested`; "" if nothing is. Where nothing is seen they are 0.
 * Exact: receivers have the same mask.
 * In what follows surfaces that turn away from the light do not count, which are dark anyway.
 * Clamped: they may differ where the 3 x 3 pixels around a sample do not lie in a plane (the edge
 * of a surface, from behind which an edge of a shadow may come), and where they have both values in
 * `expected` (the edge of a shadow) in GetClampedFlips(receivers at such edges) samples.
 * Elsewhere MaximumFlipsElsewhere samples may differ, where sides of volumes are seen edge-on.
 *
 * A straight edge that runs along a column or row of samples flips all of them at once, and so does
 * a surface seen edge-on in a depth buffer of coarse steps: where more differ, those are left out
 * that `judge` says are ambiguous, or right in `tested`.
 */
std::string CompareMasks(const ShadowFrame& expected, const ShadowFrame& tested, ShadowMode mode,
  ShadowTally& tally, const RayJudge& judge);
long long GetClampedFlips(long long receiversAtEdges);
constexpr long long MaximumFlipsElsewhere = 2;

/// Receivers in which Exact differs from Unclamped.
struct ShadowStrays
{
  long long Seen = 0;   ///< The light reaches them, so that the images differ, too.
  long long Unlit = 0;  ///< They look away from the light: no image shows what their masks say.
  long long Parted = 0; ///< Ambiguous ones, where the two have counted in different portions.
};

/**
 * Where Exact (`tested`) differs from Unclamped (`expected`), if rays say for each sample that
 * Exact is right and at most MaximumFlipsElsewhere of a light are seen; else nothing. Rasterisers
 * may draw slivers of whole volumes far off their planes (docs/shadows.md), where Exact leaves them
 * out; an edge along a row of samples flips all of them at once.
 *
 * `parted`: counts were too high for one stencil, so that volumes were counted in portions, which
 * are others where some are left out. At the very edge of a surface rasterisers may miss one of the
 * two sides of a volume, and what that leaves is taken away or not by others in the same portion:
 * samples that rays say are ambiguous may differ then.
 */
std::optional<ShadowStrays> FindStrays(
  const Player& stage, const ShadowFrame& expected, const ShadowFrame& tested, bool parted);

/// Whether one of the two has counted the volumes of a light in portions.
bool HasParted(const Player& expected, const Player& tested);

/// What is wrong with the masks by rays of the scene as it is: more than MaximumFlipsElsewhere
/// samples of a light, the rest being strays.
std::string CompareWithRays(const Player& stage, const ShadowFrame& frame, ShadowTally& tally);

/// Contradictions in the statistics of a stage's passes, and failures.
std::string CheckShadowStatistics(const Player& stage);

/// A line of JSON for each renderer that has such a pass.
std::string GetShadowStatistics(const Player& stage);

/// What statistics of different passes over the same frame have to share.
std::string CompareShadowStatistics(const Player& expected, const Player& tested);
}

#endif
