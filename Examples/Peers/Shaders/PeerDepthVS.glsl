//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// A corner of a triangle with its number (DepthPainter.h).
in vec3 place; // relative to the eye
in float number;
uniform mat4 eyeToClip;
flat out float shown;

void main()
{
  shown = number;
  gl_Position = eyeToClip * vec4(place, 1.0);
}
