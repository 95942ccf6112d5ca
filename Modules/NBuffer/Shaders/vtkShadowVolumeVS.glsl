//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// A corner of a shadow volume: w = 1 for a point, relative to the volume's origin, w = 0 for a
// direction. The same corner gives the same bits in every triangle that shares it.
in vec4 corner;
uniform mat4 volumeToClip;

void main()
{
  gl_Position = volumeToClip * corner;
  // The near plane, where it cuts (vtkShadowPlan.h).
  gl_ClipDistance[0] = gl_Position.z + gl_Position.w;
}
