// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KicadBoard.h"
#include "Messages.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
using NBufferExamples::KicadBoard;
using NBufferExamples::KicadPart;
using NBufferExamples::ReadKicadBoard;

const char* const Board = R"((kicad_pcb (version 20211014)
  (general (thickness 1.5))
  (footprint "lib:R" (layer "F.Cu") (tedit 0)
    (at 10.5 -20 90)
    (pad "1" smd (at 1 2 3))
    (model "${KICAD6_3DMODEL_DIR}/R.3dshapes/R \"big\".wrl"
      (offset (xyz 1 2 3)) (scale (xyz 1 1.5 1)) (rotate (xyz 0 0 -90))))
  (module lib:OLD (layer B.Cu) (at 1 2)
    (model R.wrl (at (xyz 0.1 0 0)) (scale (xyz 1 1 1)) (rotate (xyz 0 0 0))))
  (footprint "hole" (layer "F.Cu") (at 5 5))
  (gr_line (start 0 0) (end 30 0) (layer "Edge.Cuts") (width 0.1))
  (gr_line (start 30 0) (end 30 40) (layer "Edge.Cuts"))
  (gr_line (start -99 0) (end 30 40) (layer "F.SilkS"))
))";

std::string GetBoardError(const std::string& text)
{
  return GetThrownMessage([&text] { ReadKicadBoard(text); });
}
}

TEST(StudyBoard, ReadsPartsAndOutline)
{
  const KicadBoard board = ReadKicadBoard(Board);
  EXPECT_EQ(board.Thickness, 1.5);
  EXPECT_EQ(board.Low[0], 0.0);
  EXPECT_EQ(board.High[0], 30.0);
  EXPECT_EQ(board.High[1], 40.0);
  EXPECT_EQ(board.Bare, 1);
  ASSERT_EQ(board.Parts.size(), 2u);
  const KicadPart& above = board.Parts[0];
  EXPECT_EQ(above.Model, "${KICAD6_3DMODEL_DIR}/R.3dshapes/R \"big\".wrl");
  EXPECT_EQ(above.X, 10.5);
  EXPECT_EQ(above.Y, -20.0);
  EXPECT_EQ(above.Angle, 90.0);
  EXPECT_FALSE(above.IsBelow);
  EXPECT_EQ(above.Offset[2], 3.0);
  EXPECT_EQ(above.Scale[1], 1.5);
  EXPECT_EQ(above.Rotation[2], -90.0);
}

TEST(StudyBoard, ReadsTheFormerFormat)
{
  const KicadPart below = ReadKicadBoard(Board).Parts[1];
  EXPECT_TRUE(below.IsBelow);
  EXPECT_EQ(below.Angle, 0.0);
  EXPECT_DOUBLE_EQ(below.Offset[0], 2.54); // From inches.
}

TEST(StudyBoard, SaysWhatIsWrongWithAFile)
{
  EXPECT_EQ(GetBoardError(""), "no board: no parenthesis opens at byte 0");
  EXPECT_EQ(GetBoardError("(kicad_sch)"), "no board: it does not begin with (kicad_pcb");
  EXPECT_EQ(GetBoardError("(kicad_pcb)"), "no board: it has no outline on Edge.Cuts");
  EXPECT_EQ(
    GetBoardError("(kicad_pcb (general"), "no board: a parenthesis is not closed at byte 19");
  EXPECT_EQ(GetBoardError("(kicad_pcb \"x"), "no board: a quotation is not closed at byte 13");
  EXPECT_EQ(GetBoardError("(kicad_pcb (footprint \"R\"))"), "no board: the part R has no place");
  EXPECT_EQ(GetBoardError("(kicad_pcb (footprint \"R\" (at 1 b)))"),
    "no board: (at ...) lacks its number 2, or it is none");
  EXPECT_EQ(GetBoardError(std::string(200, '(')).substr(0, 47),
    "no board: parentheses are nested too deeply at ");
}

TEST(StudyBoard, EveryFileThatIsCutOffIsAnError)
{
  const std::string text = Board;
  for (std::size_t size = 0; size < text.size(); ++size)
  {
    EXPECT_NE(GetBoardError(text.substr(0, size)), "") << size << " bytes";
  }
}
