//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// A corner of a receiver, relative to the eye, as the light sees it: x and y of the litmap, no
// depth, so that nothing but the light's plane cuts it off (RerenderedLitmap.h).
in vec3 corner;
uniform mat4 eyeToLight;
out vec3 place;

void main()
{
  place = corner;
  gl_Position = eyeToLight * vec4(corner, 1.0);
}
