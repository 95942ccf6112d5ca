//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Draws volumes in one colour, for debug views.
uniform vec4 tint;

void main()
{
  gl_FragData[0] = tint;
}
