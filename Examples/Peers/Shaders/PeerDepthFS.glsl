//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec
//VTK::NBuffer::Dec

// The number of the triangle that the depth test leaves, and a depth that the matrix cannot have.
// gl_FragCoord.w is 1 / w.
flat in float shown;
uniform float nearest; // the distance of the near plane
uniform float scale; // 1 / far, or 1 / log2(far / near)

void main()
{
  gl_FragData[0] = vec4(shown, 0.0, 0.0, 0.0);
#if NBUFFER_ENCODING == 2 // linear
  gl_FragDepth = scale / gl_FragCoord.w;
#elif NBUFFER_ENCODING == 3 // logarithmic
  gl_FragDepth = -scale * log2(nearest * gl_FragCoord.w);
#endif
}
