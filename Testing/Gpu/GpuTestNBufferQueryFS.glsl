//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec
//VTK::NBuffer::Query

flat in int number;
#if NBUFFER_IN_VERTEX_STAGE
flat in vec4 answer;
#else
//VTK::NBuffer::Answer
#endif

void main()
{
#if NBUFFER_IN_VERTEX_STAGE
  gl_FragData[0] = answer;
#else
  gl_FragData[0] = GetAnswer(number);
#endif
}
