//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// A box by its eight corners in clip space, corner i at (low, high) x by bit 0 of i, y by bit 1, z
// by bit 2: all six faces as one strip of 14 vertices, without vertex buffers. Bit n of each number
// is the side of vertex n along one axis.

uniform vec4 corners[8];

void main()
{
  int bit = 1 << gl_VertexID;
  int x = (0x287a & bit) != 0 ? 1 : 0;
  int y = (0x02af & bit) != 0 ? 2 : 0;
  int z = (0x31e3 & bit) != 0 ? 4 : 0;
  gl_Position = corners[x + y + z];
}
