// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Constants that C++ and GLSL share: C++ includes this file, and its text is substituted into
// shaders. It may contain only preprocessor definitions and // comments.
#ifndef vtkNBufferShared_h
#define vtkNBufferShared_h

// How vtkNBufferBaseFS.glsl reads depth: by a sampler, as integers, or from multisampled textures.
#define NBUFFER_SOURCE_DEPTH 0
#define NBUFFER_SOURCE_INTEGER 1
#define NBUFFER_SOURCE_MULTISAMPLE 2

// Normalised depth of 32 bits does not fit a float. Its last 8 bits are dropped, so that it becomes
// a multiple of 1 / 2^24; it is rounded up for the maximum and down for the minimum.
#define NBUFFER_DEPTH32_DROPPED_BITS 8
#define NBUFFER_DEPTH32_DROPPED_MASK 255
#define NBUFFER_DEPTH32_SCALE 16777216.0

// Normalised depth of 24 bits: the largest integer, which means 1.
#define NBUFFER_DEPTH24_LARGEST 16777215.0

// Samplers may round depth of 32 bits; Mesa's software samplers keep 23 bits. Multisampled depth
// can only be sampled, so its error is bounded by 2^-23.
#define NBUFFER_DEPTH32_SAMPLER_ERROR 1.1920928955078125e-7

// A shadow mask has four channels, one for each light.
#define NBUFFER_SHADOW_LIGHTS_PER_MASK 4

// A fragment is visible in a sample if the depth that is stored for the sample is that of the
// fragment. The two depths may come from different framebuffers. The tolerances are 1/64 of a pixel
// for the place of the sample, and eight steps of 24-bit depth for the depth.
#define NBUFFER_SHADOW_PLACE_TOLERANCE 0.015625
#define NBUFFER_SHADOW_DEPTH_TOLERANCE 4.76837158203125e-7

// What a compute shader finds out about a node of units (vtkNBufferUnitAnswers.h), as bits.
#define NBUFFER_ANSWER_NONE 0u
#define NBUFFER_ANSWER_OUTSIDE 1u
#define NBUFFER_ANSWER_HIDDEN 2u
#define NBUFFER_ANSWER_VISIBLE 3u
#define NBUFFER_ANSWER_BITS 2u
#define NBUFFER_ANSWER_MASK 3u

// The invocations of a work group of the compute shaders, and how many primitives each of them has
// in vtkNBufferListCS.glsl.
#define NBUFFER_GROUP 256
#define NBUFFER_OF_EACH 8u

// The largest number of children of a node of units (vtkNBufferUnits.h).
#define NBUFFER_FANOUT 8u

#endif
