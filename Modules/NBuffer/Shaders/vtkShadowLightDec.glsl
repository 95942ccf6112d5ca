// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadow masks, declared in the fragment shaders of VTK's mappers. A mask has one channel for each
// of four lights: 0 where it shines, 1 where it does not (vtkShadowTarget.h).
uniform sampler2D shadowMasks[NBUFFER_SHADOW_MASKS];
uniform float shadowAttenuations[NBUFFER_SHADOW_LIGHTS];

// The share of a light that arrives: exactly 1 where it shines.
#define NBUFFER_SHADOW_SHARE(light, mask, channel) \
  (1.0 - shadowAttenuations[light] * \
    texelFetch(shadowMasks[mask], ivec2(gl_FragCoord.xy), 0)[channel])
