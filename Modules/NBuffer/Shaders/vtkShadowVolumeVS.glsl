//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// A corner of a shadow volume, in world coordinates relative to the volume's origin: w is 1 for a
// point and 0 for a direction (a point at infinity). All triangles that share a corner get the same
// bits for it, so volumes have no gaps.
in vec4 corner;
uniform mat4 volumeToClip;

void main()
{
  gl_Position = volumeToClip * corner;
  // For z-fail, what lies before the near plane is clipped (vtkShadowCounter.h).
  gl_ClipDistance[0] = gl_Position.z + gl_Position.w;
}
