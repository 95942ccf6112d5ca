//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// What the camera sees of a receiver widens the extent of its lexel, by blending with the maximum
// (RerenderedLitmap.h).
in vec3 place; // relative to the eye
uniform mat4 eyeToClip;
uniform vec3 axis; // of the light
uniform sampler2D cameraDepth;
uniform float depthBias;
uniform int rows; // 0: depths and columns of pixels; 1: rows of pixels and distance

void main()
{
  vec4 clip = eyeToClip * vec4(place, 1.0);
  ivec2 size = textureSize(cameraDepth, 0);
  vec3 window = 0.5 * clip.xyz / clip.w + 0.5;
  ivec2 pixel = ivec2(floor(window.xy * vec2(size)));
  if (clip.w <= 0.0 || any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size)) ||
    window.z > texelFetch(cameraDepth, pixel, 0).r + depthBias)
  {
    discard;
  }
  float depth = dot(axis, place);
  vec2 xy = vec2(pixel);
  gl_FragData[0] =
    rows == 0 ? vec4(-depth, depth, -xy.x, xy.x) : vec4(-xy.y, xy.y, length(place), 0.0);
}
