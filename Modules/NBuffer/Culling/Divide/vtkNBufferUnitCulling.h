// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferUnitCulling
 * @brief Which units of one large prop (vtkNBufferUnits) may be seen, have been drawn, and are to
 * be drawn next. No OpenGL. vtkNBufferDividedProp says in which order its functions are called.
 */
#ifndef vtkNBufferUnitCulling_h
#define vtkNBufferUnitCulling_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"
#include "vtkNBufferStatistics.h" // For the verdict
#include "vtkNBufferUnitAnswers.h"
#include "vtkNBufferUnitChoice.h"
#include "vtkNBufferUnits.h"

#include <cstddef>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferLevels;
class vtkNBufferTexture;

class VTKNBUFFER_EXPORT vtkNBufferUnitCulling
{
public:
  /// What a test of units compares them with.
  struct Depth
  {
    const vtkNBufferLevels& Levels;
    const float* Pixels = nullptr; ///< The depth image, or nullptr if it is not in host memory.
    double SampleDistance = 0.5;   ///< See vtkNBufferOcclusionTest.
    /// Returns the same levels on the device, or nullptr. Empty if the device does not have them.
    std::function<const vtkNBufferTexture*()> GetTexture = {};
  };

  /// How many units there are in this frame: all, those outside of the frustum, those that are
  /// drawn first (kept), and the fresh ones.
  struct Counts
  {
    int Units = 0;
    int Outside = 0;
    int Kept = 0;
    int Fresh = 0;
  };

  /// What bounds the rounding of vertices, in the coordinates of the mesh; see vtkNBufferBox.
  struct Rounding
  {
    glm::dvec3 Origin = glm::dvec3(0.0);
    glm::dvec3 Magnitude = glm::dvec3(0.0);
    double Margin = 0.0;
  };

  /// Begin with new units, of which nothing is known.
  void SetUnits(vtkNBufferUnits units);
  const vtkNBufferUnits& GetUnits() const { return this->Units; }

  void SetRounding(const Rounding& rounding) { this->Errors = rounding; }

  /// The box of bounds in the coordinates of the mesh, with what bounds the rounding of vertices.
  vtkNBufferBox MakeBox(const vtkNBufferUnits::Box& bounds) const;

  /// Test the frustum, and let the units that are drawn first count as drawn: those that the last
  /// test found visible, some that come and go, and, in a new view, those that probably hide the
  /// others. If any unit is in the frustum, at least one is drawn.
  void FindKept(const vtkNBufferProjection& projection);

  /// Let no unit count as drawn. To be called before Test() if the prop has not been drawn.
  void ClearDrawn();

  /// Test the units in the frustum. Those that are visible and not drawn are fresh. Returns their
  /// number. If `answers` is not nullptr, a graphics device has made the tests for which it has an
  /// answer.
  int Test(const vtkNBufferProjection& projection, const Depth& depth,
    const vtkNBufferUnitAnswers* answers = nullptr);

  /// If many units are fresh (vtkNBufferUnitChoice::AreMany()), let only those stay fresh that
  /// probably hide the others, which have to be tested again once these are drawn. Returns whether
  /// there are such others.
  bool PostponeFar(const vtkNBufferProjection& projection);

  /// How many units are left if only nodes of the highest level that Test() tests are compared with
  /// the levels.
  std::size_t CountInDoubt(const vtkNBufferProjection& projection, const Depth& depth) const;

  /// Whether all answers of a device are those of the host.
  bool AreRight(const vtkNBufferUnitAnswers& answers, const vtkNBufferProjection& projection,
    const Depth& depth) const;

  /// How many units in the frustum are behind what the levels hold. Changes nothing.
  int CountHidden(const vtkNBufferProjection& projection, const Depth& depth) const;

  /// Let the fresh units count as drawn.
  void AddFreshToDrawn();

  ///@{
  /// For each unit, 1 if it has been drawn in this frame (GetDrawn()) or is fresh (GetFresh()),
  /// otherwise 0.
  const std::vector<unsigned char>& GetDrawn() const { return this->DrawnUnits; }
  const std::vector<unsigned char>& GetFresh() const { return this->FreshUnits; }
  ///@}

  /// How many units the tests of this frame have found hidden after they were drawn.
  int CountKeptInVain() const { return this->KeptInVain; }

  /// How many units GetFresh() marks.
  int CountFresh() const { return this->Number.Fresh - this->FreshBefore; }

  /// How many units have been drawn in this frame.
  int CountDrawn() const;

  const Counts& GetCounts() const { return this->Number; }

  /// The verdict of the unit of a primitive; Unknown if there is no such primitive.
  vtkNBufferVerdict GetVerdict(std::size_t primitive);

private:
  /// What is known of a unit.
  enum Mark : unsigned char
  {
    Kept = 1,    ///< It is drawn first, unless it is outside.
    Outside = 2, ///< It is outside of the view in this frame.
    Dropped = 4  ///< It was kept until the last test.
  };

  void MarkOutside(std::size_t level, std::size_t n, const vtkNBufferProjection& projection);
  /// Project a unit. Returns whether it is inside of the frustum.
  bool Project(
    const vtkNBufferProjection& projection, std::size_t unit, vtkNBufferScreenBox& screen) const;
  void Keep(std::size_t unit);
  void SetHidden(std::size_t unit);
  void SetVisible(std::size_t unit);
  struct Tests;
  void TestNode(std::size_t level, std::size_t n, Tests& tests);
  vtkNBufferUnitAnswers::Answer TestBox(std::size_t level, std::size_t n, Tests& tests) const;
  template <typename Function>
  void RunInThreads(const Function& function);

  vtkNBufferUnits Units;
  Rounding Errors;
  std::vector<unsigned char> Marks;      ///< One element for each unit.
  std::vector<unsigned char> Patience;   ///< How many tests may find it hidden until it is dropped.
  std::vector<unsigned char> DrawnUnits; ///< Whether it has been drawn.
  std::vector<unsigned char> FreshUnits; ///< Whether it is to be drawn next.
  Counts Number;
  int FreshBefore = 0; ///< How many fresh units of this frame have been drawn.
  int KeptInVain = 0;
  vtkNBufferUnitChoice Choice;
  unsigned int Turn = 0; ///< Which of the drawn units are compared with pixels.
};

VTK_ABI_NAMESPACE_END
#endif
