//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Lays an image over the picture, pixel by pixel. Nothing is drawn where the image is transparent.
uniform sampler2D image;

void main()
{
  vec4 color = texelFetch(image, ivec2(gl_FragCoord.xy), 0);
  if (color.a == 0.0)
  {
    discard;
  }
  gl_FragData[0] = color;
}
