// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HazardBuilder.h
 * @brief Writes a hazard of culling: a scene, frame by frame, and what is expected of its frames.
 */
#ifndef HazardBuilder_h
#define HazardBuilder_h

#include "NamedScenarios.h"
#include "SceneBuilder.h"

#include <string>
#include <vector>

namespace TestScene
{
/// The culler tests in every frame, however few props there are.
class HazardBuilder : public SceneBuilder
{
public:
  explicit HazardBuilder(const std::string& name, int width = 301, int height = 173);

  /// The culler alone, with texels of level 0 of `baseFactor` pixels, so that every verdict is
  /// known.
  void BeExact(int baseFactor = 1);

  /// @name What is expected of this frame
  /// What the first frame has drawn as a guess is tested in the second and held back in the third.
  ///@{
  Expectation& ExpectHidden(
    int minimum, int maximum = Expectation().MaximumHidden, int renderer = 0);
  /// So many are hidden or outside.
  void ExpectCulled(int minimum, int renderer = 0);
  /// Each of the props has one of these verdicts, and so many are hidden at least.
  void ExpectVerdicts(const std::vector<int>& props, const std::vector<vtkNBufferVerdict>& allowed,
    int minimumHidden = 0);
  void ExpectVerdict(const std::vector<int>& props, vtkNBufferVerdict verdict)
  {
    this->ExpectVerdicts(props, { verdict });
  }
  /// None of the props has one of these verdicts.
  void ExpectNone(const std::vector<int>& props, const std::vector<vtkNBufferVerdict>& unwanted);
  void ExpectNotHidden(const std::vector<int>& props)
  {
    this->ExpectNone(props, { vtkNBufferVerdict::Hidden });
  }
  void ExpectStayHidden(const std::vector<int>& props) { this->Expect().StayHidden = props; }
  void ExpectDecision(vtkNBufferDecision decision, int renderer = 0);
  /// The image shows at least so many pixels of exactly this colour.
  void ExpectPixels(const glm::dvec3& color, int minimum);
  ///@}

  /// The frame is drawn again, `times` times.
  void Settle(int times = 3) { this->Scene.Frames += times; }

  NamedScenario Finish();

private:
  Expectation& Expect(int renderer = 0);

  NamedScenario Result;
};

/// first, first + step, ... below last.
std::vector<int> MakeRange(int first, int last, int step = 1);

/// @name Parts of GetCullingHazards()
///@{
std::vector<NamedScenario> GetBoundsHazards(); ///< Boxes that are none.
std::vector<NamedScenario> GetScreenHazards(); ///< Pixels, windows and viewports.
std::vector<NamedScenario> GetShapeHazards();  ///< Lines, equal depths, matrices.
///@}
}

#endif
