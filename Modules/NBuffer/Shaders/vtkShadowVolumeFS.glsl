//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec
//VTK::NBuffer::Dec

// Writes no colour: shadow volumes change only the stencil buffer. With NBUFFER_SHADOW_OFFSET it
// does what glPolygonOffset() should do (vtkNBufferGL::OffsetsBeyondFarPlane).
#if NBUFFER_SHADOW_OFFSET
uniform float factor; // times the slope of the depth
uniform float bias;   // of the window depth

void main()
{
  float depth = gl_FragCoord.z;
  gl_FragDepth = depth + factor * max(abs(dFdx(depth)), abs(dFdy(depth))) + bias;
}
#else
void main()
{
}
#endif
