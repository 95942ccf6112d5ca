// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KicadBoard.h
 * @brief The outline and the places of the parts of a printed board, from KiCad's board files.
 *
 * Lengths are millimetres, angles are degrees, and y points down, as in the file.
 */
#ifndef KicadBoard_h
#define KicadBoard_h

#include <string>
#include <vector>

namespace NBufferExamples
{

struct KicadPart
{
  std::string Model; ///< The file name of its model, with variables like ${KICAD6_3DMODEL_DIR}.
  double X = 0.0;
  double Y = 0.0;
  double Angle = 0.0; ///< Counter-clockwise.
  bool IsBelow = false;
  ///@{
  /// The placement of the model in its part.
  double Offset[3] = { 0.0, 0.0, 0.0 };
  double Scale[3] = { 1.0, 1.0, 1.0 };
  double Rotation[3] = { 0.0, 0.0, 0.0 };
  ///@}
};

struct KicadBoard
{
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 0.0, 0.0 };
  double Thickness = 1.6;
  std::vector<KicadPart> Parts;
  /// The number of parts that name no model.
  int Bare = 0;
};

/// Reads a board. Throws std::runtime_error with the place and the cause if the text is no board
/// with an outline.
KicadBoard ReadKicadBoard(const std::string& text);

} // namespace NBufferExamples

#endif
