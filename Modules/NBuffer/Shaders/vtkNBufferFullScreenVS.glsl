//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// One triangle over the whole viewport, without vertex buffers:
//
//     (-1, 3)
//        |\.
//        |  \.
//        |----\ (1, 1)
//        |    | \.
//        +----+---\ (3, -1)

void main()
{
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
  gl_Position = vec4(corner, 0.0, 1.0);
}
