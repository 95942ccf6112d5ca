// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Judge.h
 * @brief Decides for every rendering test whether two frames are the same: the bytes of the image,
 * the bits of the depth, the counts, and that neither VTK nor OpenGL reports an error.
 *
 * Functions that return a std::string return what is wrong, or "" if nothing is, so that tests can
 * use EXPECT_EQ(..., "") and the fuzzer can write the text into its report.
 */
#ifndef Judge_h
#define Judge_h

#include "Stage.h"

#include <array>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace TestScene
{
/// A copy of what a window shows, row by row, the lowest first.
struct Picture
{
  int Size[2] = { 0, 0 };
  std::vector<unsigned char> Colors; ///< RGBA of each pixel.
  std::vector<float> Depths;         ///< The depth of each pixel; empty if it was not read.

  const unsigned char* GetColor(std::size_t pixel) const { return &this->Colors[4 * pixel]; }
};

enum class PictureSource
{
  Shown,   ///< The copy of the rendered image that VTK makes to show it.
  Rendered ///< The rendered image itself. Where formats of depth differ, VTK fails to copy it.
};

/// Reads the last frame of a window.
Picture TakePicture(
  vtkRenderWindow* window, bool withDepth = false, PictureSource source = PictureSource::Shown);

/// Returns the places of the samples in a pixel of a window that has rendered, in [0, 1] from the
/// lower left corner. Without multisampling there is one sample, the centre.
std::vector<std::array<double, 2>> GetSamplePlaces(vtkRenderWindow* window);

/// Returns in how many pixels the pictures differ, which is the first of them, and its values in
/// both. Depth is compared if both pictures have it. `region`, if given, is the x, y, width and
/// height of the part to compare. Channels of colours (0 to 255) may differ by `tolerance`.
std::string FindDifference(
  const Picture& expected, const Picture& actual, const int region[4] = nullptr, int tolerance = 0);

/// What a hardware selection finds of a prop.
struct Selected
{
  int Pixels = 0;
  std::vector<vtkIdType> Elements; ///< The numbers of the cells or points.
  bool operator==(const Selected& other) const
  {
    return this->Pixels == other.Pixels && this->Elements == other.Elements;
  }
};
void PrintTo(const Selected& selected, std::ostream* os);

/// What a selection finds of each prop, by the index of the prop in the stage, or by -1 if the prop
/// is not in the stage.
using Selection = std::map<int, Selected>;

/// Makes a hardware selection in the first renderer. `area` is the lower left and the upper right
/// pixel, both inside. `field` is vtkDataObject::FIELD_ASSOCIATION_CELLS or _POINTS.
Selection Select(const Stage& stage, const int area[4], int field);

/// The errors and warnings of a frame.
struct FrameErrors
{
  std::string GL;         ///< Errors of OpenGL, by glGetError() and by debug output.
  bool IsPending = false; ///< Whether glGetError() returned one of them after the frame.
  std::string VTK;        ///< Errors and warnings of VTK.
};

/// Renders a frame of the stage. The counts of its draws begin at 0.
FrameErrors RenderFrame(Stage& stage);

/// Returns the contradictions in the statistics of the stage's cullers.
std::string FindInconsistency(const Stage& stage);

/// Which props must have been drawn at least as often as in the reference.
enum class MustBeDrawn
{
  None,     ///< None, because another culler may have removed any of them.
  Tested,   ///< Those with the verdict Visible or NearPlane.
  NotCulled ///< All except those with the verdict Hidden or Outside.
};

/// Returns which props were drawn although they are culled, or were not drawn although they must
/// be, and whether there are more additional draws, in comparison with the reference, than the
/// statistics count. With `exactly` there may not be fewer either, if the draws of all props are
/// counted.
std::string FindWrongDraws(
  const Stage& reference, const Stage& tested, MustBeDrawn which, bool exactly);
}

#endif
