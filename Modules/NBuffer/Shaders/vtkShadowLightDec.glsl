// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadow masks, declared in the fragment shaders of VTK's mappers. A mask has one channel for each
// of four lights: 0 where it shines, 1 where it does not (vtkShadowTarget.h).
#if NBUFFER_SHADOW_SAMPLES > 1
uniform sampler2DMS shadowMasks[NBUFFER_SHADOW_MASKS];
uniform sampler2DMS shadowDepth; // of the receivers
uniform vec2 shadowSamples[NBUFFER_SHADOW_SAMPLES]; // places in a pixel, from its centre

// The mean over the samples that the fragment covers and whose receiver has its depth, so that no
// nearer surface hides it there: exactly 0 where the light shines on all of them. Where there is
// none (what is drawn with a depth of its own), over all that it covers.
float NBufferShadow(sampler2DMS mask, int channel)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
  // 1/64 of a pixel, and eight units of 24 bits.
  float tolerance = (abs(slope.x) + abs(slope.y)) / 64.0 + 1.0 / 2097152.0;
  vec2 seen = vec2(0.0); // sum and number
  vec2 covered = vec2(0.0);
  for (int i = 0; i < NBUFFER_SHADOW_SAMPLES; ++i)
  {
#if __VERSION__ >= 400 || defined(GL_ARB_gpu_shader5)
    if ((gl_SampleMaskIn[0] >> i & 1) == 0)
    {
      continue;
    }
#endif
    vec2 term = vec2(texelFetch(mask, pixel, i)[channel], 1.0);
    covered += term;
    float off = gl_FragCoord.z + dot(slope, shadowSamples[i]) - texelFetch(shadowDepth, pixel, i).r;
    seen += abs(off) <= tolerance ? term : vec2(0.0);
  }
  seen = seen.y > 0.0 ? seen : covered;
  return seen.x / max(seen.y, 1.0);
}
#else
uniform sampler2D shadowMasks[NBUFFER_SHADOW_MASKS];

float NBufferShadow(sampler2D mask, int channel)
{
  return texelFetch(mask, ivec2(gl_FragCoord.xy), 0)[channel];
}
#endif
uniform float shadowAttenuations[NBUFFER_SHADOW_LIGHTS];

// The share of a light that arrives: exactly 1 where it shines.
#define NBUFFER_SHADOW_SHARE(light, mask, channel) \
  (1.0 - shadowAttenuations[light] * NBufferShadow(shadowMasks[mask], channel))
