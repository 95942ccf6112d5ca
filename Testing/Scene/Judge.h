// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Judge.h
 * @brief Decides for every rendering test whether two frames are the same: the bytes of the image,
 * the bits of the depth, the counts, and that neither VTK nor OpenGL reports an error.
 *
 * All functions return what is wrong as text, empty if nothing is, so that GoogleTest fails by
 * EXPECT_EQ(..., "") and the fuzzer can write the text into its report.
 */
#ifndef Judge_h
#define Judge_h

#include "Stage.h"

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
  std::vector<float> Depths;         ///< Of each pixel; empty if depth was not read.

  const unsigned char* GetColor(std::size_t pixel) const { return &this->Colors[4 * pixel]; }
};

enum class PictureSource
{
  Shown,   ///< The copy that VTK makes of what it rendered to show it.
  Rendered ///< What was rendered. Where formats of depth differ VTK fails to make the copy.
};

Picture TakePicture(
  vtkRenderWindow* window, bool withDepth = false, PictureSource source = PictureSource::Shown);

/// In how many pixels the pictures differ, the first of them, and its values in both. `region`: x,
/// y, width and height of the only part to compare. Depth is compared if both have it. Values of
/// colours (0 to 255) may differ by `tolerance`.
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

/// The props by their indices in the stage; -1 for others.
using Selection = std::map<int, Selected>;

/// Selects in an area of the first renderer: its first and last column and row. `field`: of
/// vtkDataObject, cells or points.
Selection Select(const Stage& stage, const int area[4], int field);

/// What came with a frame in addition to its image.
struct FrameErrors
{
  std::string GL;         ///< Errors of OpenGL, by glGetError() and by debug output.
  bool IsPending = false; ///< VTK left one of them for glGetError() after the frame.
  std::string VTK;        ///< Errors and warnings of VTK.
};

/// Render a frame of the stage, with its draws counted anew.
FrameErrors RenderFrame(Stage& stage);

/// Contradictions in the statistics of the stage's cullers.
std::string FindInconsistency(const Stage& stage);

/// Which props must have been drawn as often as in the reference.
enum class MustBeDrawn
{
  None,     ///< A culler that was there before decides as well.
  Tested,   ///< Those that the culler found visible, or cut by the near plane.
  NotCulled ///< All that the culler did not find hidden or outside.
};

/// Props that were drawn against their verdict, and draws beyond those of the reference that the
/// statistics do not count. `exactly`: where the draws of all props are known, all that the
/// statistics count must have happened.
std::string FindWrongDraws(
  const Stage& reference, const Stage& tested, MustBeDrawn which, bool exactly);
}

#endif
