// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Constants of both languages: included by C++, substituted into the shaders. Only preprocessor
// definitions and // comments may stand here.
#ifndef vtkNBufferShared_h
#define vtkNBufferShared_h

// Where the base pass finds depth.
#define NBUFFER_SOURCE_DEPTH 0
#define NBUFFER_SOURCE_INTEGER 1
#define NBUFFER_SOURCE_MULTISAMPLE 2

// Normalised depth of 32 bits does not fit a float: its last 8 bits are rounded away, up for the
// maximum, down for the minimum, to multiples of 1 / 2^24.
#define NBUFFER_DEPTH32_DROPPED_BITS 8
#define NBUFFER_DEPTH32_DROPPED_MASK 255
#define NBUFFER_DEPTH32_SCALE 16777216.0

// Normalised depth of 24 bits: the largest integer, which stands for 1.
#define NBUFFER_DEPTH24_LARGEST 16777215.0

// Samplers round depth of 32 bits as they like; Mesa's software samplers keep 23 bits. Multisampled
// depth can only be sampled, and a level must not claim more than it knows: 2^-23.
#define NBUFFER_DEPTH32_SAMPLER_ERROR 1.1920928955078125e-7

#endif
