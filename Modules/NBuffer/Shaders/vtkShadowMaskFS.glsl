//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Where the stencil test passes, the light of the channel that may be written does not shine.
void main()
{
  gl_FragData[0] = vec4(1.0);
}
