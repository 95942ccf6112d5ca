// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HazardBuilder.h
 * @brief Makes a named scenario about a hazard of culling: a scene, frame by frame, and what is
 * expected of its frames.
 */
#ifndef HazardBuilder_h
#define HazardBuilder_h

#include "NamedScenarios.h"
#include "SceneBuilder.h"

#include <string>
#include <vector>

namespace TestScene
{
/// In these scenarios the culler tests in every frame, however few props there are.
class HazardBuilder : public SceneBuilder
{
public:
  explicit HazardBuilder(const std::string& name, int width = 301, int height = 173);

  /// Makes every verdict predictable: removes VTK's culler, tests in frames without changes, too,
  /// and makes the texels of level 0 `baseFactor` pixels wide and high.
  void BeExact(int baseFactor = 1);

  /// @name What is expected of the current frame
  /// The first frame draws some candidates untested, as occluders. They are tested in the second
  /// frame, and those that it finds hidden are held back in the third.
  ///@{
  /// From `minimum` to `maximum` props are hidden.
  Expectation& ExpectHidden(
    int minimum, int maximum = Expectation().MaximumHidden, int renderer = 0);
  /// At least `minimum` props are hidden or outside.
  void ExpectCulled(int minimum, int renderer = 0);
  /// Each of the props has one of the allowed verdicts, and at least `minimumHidden` of them are
  /// hidden.
  void ExpectVerdicts(const std::vector<int>& props, const std::vector<vtkNBufferVerdict>& allowed,
    int minimumHidden = 0);
  void ExpectVerdict(const std::vector<int>& props, vtkNBufferVerdict verdict)
  {
    this->ExpectVerdicts(props, { verdict });
  }
  /// None of the props has one of the unwanted verdicts.
  void ExpectNone(const std::vector<int>& props, const std::vector<vtkNBufferVerdict>& unwanted);
  void ExpectNotHidden(const std::vector<int>& props)
  {
    this->ExpectNone(props, { vtkNBufferVerdict::Hidden });
  }
  /// Those of the props that the last frame found hidden are hidden again.
  void ExpectStayHidden(const std::vector<int>& props) { this->Expect().StayHidden = props; }
  void ExpectDecision(vtkNBufferDecision decision, int renderer = 0);
  /// At least `minimum` pixels have exactly this colour.
  void ExpectPixels(const glm::dvec3& color, int minimum);
  ///@}

  /// Adds `times` frames without changes.
  void Settle(int times = 3) { this->Scene.Frames += times; }

  /// Returns the scenario.
  NamedScenario Finish();

private:
  Expectation& Expect(int renderer = 0);

  NamedScenario Result;
};

/// Returns first, first + step and so on, up to the last number below `last`.
std::vector<int> MakeRange(int first, int last, int step = 1);

/// @name Parts of GetCullingHazards()
///@{
std::vector<NamedScenario> GetBoundsHazards(); ///< Bounds that are not a box.
std::vector<NamedScenario> GetScreenHazards(); ///< Pixels, windows and viewports.
std::vector<NamedScenario> GetShapeHazards();  ///< Lines, equal depths, matrices.
std::vector<NamedScenario> GetSharedHazards(); ///< Mappers that actors share.
///@}
}

#endif
