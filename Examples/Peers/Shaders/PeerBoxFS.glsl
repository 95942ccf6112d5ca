//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Only whether a sample passes the depth test matters; colour is masked.

void main()
{
  gl_FragData[0] = vec4(0.0);
}
