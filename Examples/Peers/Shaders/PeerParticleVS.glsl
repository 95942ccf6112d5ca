//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Particles as the paper has them (ParticleCloud.h): hidden ones are rejected in the vertex stage.
//VTK::NBuffer::Query

in vec3 center; // relative to the eye
uniform mat4 eyeToClip;
uniform sampler2DArray even;
uniform sampler2DArray odd;
uniform NBufferShape shape;
uniform int spriteLevel; // sprites are 2^spriteLevel pixels wide; -1: particles are boxes
uniform float boxSide;
uniform float slack;     // that the depth of a fragment may be nearer than that of its vertices
uniform int culling;     // 0: nothing is rejected; 1: by maxima; 2: by minima first
uniform int report;      // 0: draw; 1 and 2: draw particle i at pixel i, with what was found
uniform int count;       // of pixels in a row of the report
flat out vec4 found;

vec3 ToWindow(vec4 clip)
{
  return (0.5 * clip.xyz / clip.w + 0.5) * vec3(vec2(shape.size), 1.0);
}

void main()
{
  bool isSprite = spriteLevel >= 0;
  int particle = isSprite ? gl_VertexID : gl_VertexID / 8;
  vec4 clip = eyeToClip * vec4(center, 1.0);
  vec3 low;
  vec3 high;
  bool isKnown = true; // false for what reaches behind the eye
  if (isSprite)
  {
    // A sprite begins where a pixel begins, so that all rasterisers draw the same pixels.
    low = ToWindow(clip);
    float side = float(1 << spriteLevel);
    low.xy = floor(low.xy + 0.5) - 0.5 * side;
    high = vec3(low.xy + side, low.z);
    gl_Position = vec4((low.xy + 0.5 * side) / vec2(shape.size) * 2.0 - 1.0, 2.0 * low.z - 1.0, 1.0);
  }
  else
  {
    low = vec3(3e38);
    high = vec3(-3e38);
    for (int i = 0; i < 8; ++i)
    {
      vec3 corner = vec3(i & 1, i >> 1 & 1, i >> 2) - 0.5;
      vec4 place = eyeToClip * vec4(center + boxSide * corner, 1.0);
      isKnown = isKnown && place.z > -place.w && place.w > 0.0;
      vec3 window = ToWindow(place);
      low = min(low, window);
      high = max(high, window);
    }
    vec3 corner = vec3(gl_VertexID & 1, gl_VertexID >> 1 & 1, gl_VertexID >> 2 & 1) - 0.5;
    gl_Position = eyeToClip * vec4(center + boxSide * corner, 1.0);
    // Rasterisers extrapolate the depth of faces that are seen edge-on (docs/precision.md).
    float range = high.z - low.z;
    low = vec3(floor(low.xy - 0.1), low.z - range);
    high = vec3(ceil(high.xy + 0.1), high.z + range);
  }
  low.z -= slack;
  high.z += slack;
  ivec4 pixels = isKnown ? ivec4(low.xy, high.xy) : ivec4(0, 0, shape.size);
  bool isAccepted = culling == 2 && isKnown &&
    NBufferShows(even, odd, shape, pixels, high.z);
  bool isHidden = false;
  if (culling > 0 && isKnown && !isAccepted)
  {
    isHidden = isSprite
      ? low.z > NBufferFarthestOfSquare(even, odd, shape, pixels.xy, spriteLevel)
      : NBufferHides(even, odd, shape, pixels, low.z);
  }
  if (isHidden)
  {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }
  gl_PointSize = float(1 << max(spriteLevel, 0));
  found = vec4(0.2);
  if (report > 0)
  {
    found = report == 1 ? vec4(pixels) : vec4(isHidden, isAccepted, isKnown, 0.0);
    vec2 place = vec2(particle % count, particle / count);
    gl_Position = vec4((2.0 * place + 1.0) / float(count) - 1.0, 0.0, 1.0);
    gl_PointSize = 1.0;
  }
}
