// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The position as VTK's mappers compute it.
#version 150
in vec4 vertexMC;
uniform mat4 MCDCMatrix;
void main()
{
  gl_Position = MCDCMatrix * vertexMC;
}
