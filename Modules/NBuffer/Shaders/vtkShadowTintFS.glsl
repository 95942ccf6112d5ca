//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Draws in one colour: masks where the stencil test passes, and volumes for debug views.
uniform vec4 tint;

void main()
{
  gl_FragData[0] = tint;
}
