//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// A corner of a shadow volume in world coordinates, each the sum of a high and a low part
// (vtkShadowVolumeBuffer.h). high.w is 1 for a point and 0 for a direction (a point at infinity).
// All triangles that share a corner get the same bits for it, so volumes have no gaps.
in vec4 high;
in vec3 low;
uniform vec3 eyeHigh;
uniform vec3 eyeLow;
uniform mat4 eyeToClip;
uniform float push; // of the points' depth, times w (vtkShadowCounter.h)

void main()
{
  // The differences come first, so that large coordinates cancel without rounding errors.
  vec3 relative = high.w != 0.0 ? (high.xyz - eyeHigh) + (low - eyeLow) : high.xyz;
  gl_Position = eyeToClip * vec4(relative, high.w);
  gl_Position.z += high.w * push;
  // For z-fail, what lies before the near plane is clipped (vtkShadowCounter.h).
  gl_ClipDistance[0] = gl_Position.z + gl_Position.w;
}
