//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Draws query i at pixel i of a row, and answers it in the vertex or in the fragment stage.
//VTK::NBuffer::Query

uniform int count; // of queries
flat out int number;
#if NBUFFER_IN_VERTEX_STAGE
flat out vec4 answer;
//VTK::NBuffer::Answer
#endif

void main()
{
  number = gl_VertexID;
#if NBUFFER_IN_VERTEX_STAGE
  answer = GetAnswer(gl_VertexID);
#endif
  gl_Position = vec4((2.0 * float(gl_VertexID) + 1.0) / float(count) - 1.0, 0.0, 0.0, 1.0);
}
