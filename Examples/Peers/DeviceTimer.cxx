// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceTimer.h"

#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderTimer.h"

namespace NBufferPeers
{

DeviceTimer::DeviceTimer() = default;
DeviceTimer::~DeviceTimer() = default;

void DeviceTimer::Start()
{
  this->Timer = vtkNBufferGL::HasVersion(3, 3) && vtkOpenGLRenderTimer::IsSupported()
    ? std::make_unique<vtkOpenGLRenderTimer>()
    : nullptr;
  if (this->Timer)
  {
    // Software renderers collect draws before they begin, and would begin to count with the last of
    // them. They dispatch at once, and would begin to count while that runs or after it. So they
    // begin to count before any command is given.
    this->Timer->Start();
    if (vtkNBufferGL::GetSoftwareRenderer())
    {
      glFinish();
    }
  }
}

void DeviceTimer::Stop()
{
  if (this->Timer)
  {
    this->Timer->Stop();
    glFlush();
  }
}

double DeviceTimer::GetMilliseconds()
{
  if (!this->Timer)
  {
    return -1.0;
  }
  glFinish();
  while (!this->Timer->Ready())
  {
  }
  return 1e-6 * static_cast<double>(this->Timer->GetElapsedNanoseconds());
}

} // namespace NBufferPeers
