// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Declares the shadow masks in the fragment shaders of VTK's mappers. A mask has one channel for
// each of four lights: 0 where the light shines, 1 where it does not (vtkShadowTarget.h).

//VTK::NBuffer::Shared
//VTK::NBuffer::Dec

#if NBUFFER_SHADOW_SAMPLES > 1
uniform sampler2DMS shadowMasks[NBUFFER_SHADOW_MASKS];
uniform sampler2DMS shadowDepth; // the depth of the receivers
uniform vec2 shadowSamples[NBUFFER_SHADOW_SAMPLES]; // places relative to the pixel's centre

// The mean of the mask over the samples that the fragment covers and in which it is visible, which
// means that the receiver's depth is that of the fragment. It is exactly 0 if the light shines on
// all of them. If there is no such sample (a shader may write a depth of its own), the mean is over
// all samples that the fragment covers.
float NBufferShadow(sampler2DMS mask, int channel)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
  float tolerance = (abs(slope.x) + abs(slope.y)) * NBUFFER_SHADOW_PLACE_TOLERANCE +
    NBUFFER_SHADOW_DEPTH_TOLERANCE;
  vec2 seen = vec2(0.0); // sum of the mask over visible samples, and their number
  vec2 covered = vec2(0.0); // the same over covered samples
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
// How much VTK's offsets of coincident topology count: 1, or 0 where the depth of receivers is drawn.
uniform float shadowOffsets;
uniform float shadowAttenuations[NBUFFER_SHADOW_LIGHTS];

// The share of a light that arrives: exactly 1 where it shines.
#define NBUFFER_SHADOW_SHARE(light) \
  (1.0 - shadowAttenuations[light] * \
    NBufferShadow(shadowMasks[light / NBUFFER_SHADOW_LIGHTS_PER_MASK], \
      light % NBUFFER_SHADOW_LIGHTS_PER_MASK))
