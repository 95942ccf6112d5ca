//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

flat in vec4 found; // a colour, or what is reported of a particle

void main()
{
  gl_FragData[0] = found;
}
