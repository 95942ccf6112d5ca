//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Writes shadow where the stencil test passes. The colour mask selects the channel of the light.
void main()
{
  gl_FragData[0] = vec4(1.0);
}
