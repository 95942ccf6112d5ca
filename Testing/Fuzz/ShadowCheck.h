// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCheck.h
 * @brief Compares masks of shadows with each other, and with rays in double precision.
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
/// Sums over all frames that were checked, over all lights.
struct ShadowTally
{
  long long Samples = 0;      ///< Receivers whose masks were compared.
  long long Shadowed = 0;     ///< Those of them that are in shadow.
  long long ClampedFlips = 0; ///< Samples at edges in which Clamped differs from Unclamped.
  long long ClampedFlipsElsewhere = 0; ///< Other samples in which Clamped differs from Unclamped.
  long long Strays = 0;           ///< Samples in which the mask of whole volumes contradicts rays.
  long long UnseenStrays = 0;     ///< See `ShadowStrays::Unseen`.
  long long StraysInPortions = 0; ///< See `ShadowStrays::InPortions`.
  long long Rays = 0;             ///< Samples that were compared with rays.
  long long RaysAmbiguous = 0;    ///< Those of them that differ and are ambiguous.
};

/// The receivers of one renderer and their masks. All images have the size of its viewport, row by
/// row, the lowest first.
struct ShadowFrame
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Depth;
  /// For each light: not 0 in pixels that show something opaque in the reach of the light.
  std::vector<std::vector<unsigned char>> Receivers;
  /// For each light: not 0 in pixels that show a surface which faces the light.
  std::vector<std::vector<unsigned char>> Facing;
  std::vector<std::vector<unsigned char>> Masks; ///< For each light: all 0 if it casts no shadow.
};

/// Casts rays to a light of the stage's scene, in the state in which the scene is when it is
/// called.
using RayJudge = std::function<OracleImage(int light)>;
RayJudge MakeRayJudge(const Player& stage);

/// Returns whether the window's depth is that of the receivers: there is one renderer, with a
/// shadow pass, and no multisampling, stereo, text or volume.
bool HasReadableReceivers(const Player& stage);

/// Returns the receivers and masks of the last frame, of a stage with HasReadableReceivers().
ShadowFrame CaptureShadows(const Player& stage);

/**
 * Returns what is wrong with the masks of `tested`, in comparison with those of Unclamped
 * (`expected`); "" if nothing is. In every mode masks must be 0 where nothing is seen.
 *
 * In all modes except Clamped, every receiver must have the same mask. In the mode Clamped,
 * receivers that face the light may differ
 *
 *  - at edges of surfaces, where the 3 x 3 pixels around a sample do not lie in a plane: an edge of
 * a shadow may come from behind such an edge;
 *  - at edges of shadows, where these pixels have both values in `expected`: in GetClampedFlips(N)
 *    of N receivers at such edges;
 *  - elsewhere, where sides of volumes are seen edge-on: in MaximumFlipsElsewhere samples.
 *
 * A straight edge along a column or row of samples flips all of them at once, and so does a surface
 * seen edge-on in a depth buffer of coarse steps. If more samples differ than are allowed, those do
 * not count which `judge` finds ambiguous, or right in `tested`.
 */
std::string CompareMasks(const ShadowFrame& expected, const ShadowFrame& tested, ShadowMode mode,
  ShadowTally& tally, const RayJudge& judge);
long long GetClampedFlips(long long receiversAtEdges);
constexpr long long MaximumFlipsElsewhere = 2;

/// The numbers of receivers in which Scissored differs from Unclamped although nothing is wrong.
struct ShadowStrays
{
  long long Seen = 0;       ///< Receivers for which rays say that Scissored is right.
  long long Unseen = 0;     ///< Receivers that make no difference to the image.
  long long InPortions = 0; ///< Ambiguous receivers, if volumes were counted in portions.
};

/**
 * Returns where Scissored (`tested`) differs from Unclamped (`expected`). Rasterisers may draw
 * slivers of whole volumes, and surfaces seen edge-on, far off their planes (docs/shadows.md),
 * where Scissored does not draw them. Returns nothing if something is wrong, which means that for
 * one light neither of these conditions holds:
 *
 *  - Rays contradict Scissored in none of the receivers, and at most MaximumFlipsElsewhere of the
 *    receivers face the light. Receivers that face away from it are Unseen.
 *  - All receivers are ambiguous, or face away from the light. They are Unseen: the caller has to
 *    check that the images are equal.
 *
 * `inPortions` says that counts were too high for one stencil, so that volumes were counted in
 * portions. The portions of Scissored, which leaves out some volumes, are others. At the very edge
 * of a surface, rasterisers may miss one of the two sides of a volume; whether another volume makes
 * up for the wrong count depends on its being in the same portion. Then samples that rays find
 * ambiguous may differ.
 */
std::optional<ShadowStrays> FindStrays(
  const ShadowFrame& expected, const ShadowFrame& tested, const RayJudge& judge, bool inPortions);

/// Returns whether a pass of one of the two stages has counted the volumes of a light in portions.
bool CountsInPortions(const Player& expected, const Player& tested);

/// Compares the masks with rays, and returns for which lights more than MaximumFlipsElsewhere
/// samples are wrong; "" if there are none. All wrong samples are added to the tally's Strays.
std::string CompareWithRays(const Player& stage, const ShadowFrame& frame, ShadowTally& tally);

/// Returns which shadow passes of a stage have failed or have inconsistent statistics; "" if none.
std::string CheckShadowStatistics(const Player& stage);

/// Returns a line of JSON for each renderer with a shadow pass.
std::string GetShadowStatistics(const Player& stage);

/// Returns whether the shadow passes of two stages have different lights or casters, as text; "" if
/// they have not, or if there are several renderers.
std::string CompareShadowStatistics(const Player& expected, const Player& tested);
}

#endif
