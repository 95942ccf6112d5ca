//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Copies one channel of one sample of each texel of a rectangle.
uniform sampler2DMS samples; // the texture to read
uniform int index;           // of the sample
uniform int channel;
uniform ivec2 origin; // of the rectangle that is read, in texels

void main()
{
  gl_FragData[0] = vec4(texelFetch(samples, origin + ivec2(gl_FragCoord.xy), index)[channel]);
}
