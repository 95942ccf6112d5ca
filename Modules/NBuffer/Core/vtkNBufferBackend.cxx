// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBackend.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"

#include VTKNBUFFER_GL_HEADER

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferBackend::Kind vtkNBufferBackend::Choose(Kind wanted, vtkOpenGLRenderWindow* window)
{
  if (wanted != Auto)
  {
    this->Reason = "set by the application";
    return wanted;
  }
  if (this->ContextTime != window->GetContextCreationTime())
  {
    this->ContextTime = window->GetContextCreationTime();
    this->Chosen = Auto;
    this->Trial = 0;
  }
  if (this->Chosen == Auto && this->Trial == 0)
  {
    if (const char* software = vtkNBufferGL::GetSoftwareRenderer())
    {
      this->Chosen = CPU;
      this->Reason = std::string("software renderer (") + software +
        "): building on the host costs a tenth of the passes or less";
    }
  }
  if (this->Chosen != Auto)
  {
    return this->Chosen;
  }
  // Warm up, time the device, time the host.
  this->Reason = "trying both";
  return this->Trial < 2 ? OpenGL : CPU;
}

void vtkNBufferBackend::Judge(Kind used, double milliseconds)
{
  if (this->Chosen != Auto)
  {
    return;
  }
  ++this->Trial;
  if (this->Trial == 1)
  {
    return;
  }
  this->TrialTimes[used == OpenGL ? 0 : 1] = milliseconds;
  if (this->Trial == 3)
  {
    this->Chosen = this->TrialTimes[0] <= this->TrialTimes[1] ? OpenGL : CPU;
    this->Reason = "measured: OpenGL " + std::to_string(this->TrialTimes[0]) + " ms, CPU " +
      std::to_string(this->TrialTimes[1]) + " ms";
  }
}

vtkNBufferDecision vtkNBufferBackend::Build(Kind wanted, vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, int factor, int levelsNeeded, vtkNBufferLevels& levels,
  vtkNBufferStatistics& statistics, std::string& why)
{
  this->InUse = this->Choose(wanted, window);
  this->Depth.clear();
  // What is still being drawn is waited for by either path; it must not count in a trial.
  if (wanted == Auto && this->Chosen == Auto)
  {
    glFinish();
  }
  const vtkNBufferClock clock;
  bool built = this->InUse == OpenGL &&
    this->BuildOnDevice(window, source, factor, levelsNeeded, levels, statistics, why);
  if (!built && this->InUse == OpenGL && wanted == Auto)
  {
    this->InUse = this->Chosen = CPU;
    this->Reason = "the device cannot build: " + why;
  }
  if (!built && this->InUse == CPU)
  {
    built = this->BuildOnHost(window, source, factor, levelsNeeded, levels, statistics, why);
  }
  if (!built)
  {
    levels.Clear();
    return this->Texture->LacksFloatTextures() ? vtkNBufferDecision::NoFloatTextures
                                               : vtkNBufferDecision::NoDepth;
  }
  if (wanted == Auto)
  {
    this->Judge(this->InUse, clock.GetMilliseconds());
  }
  statistics.Levels += levels.GetNumberOfLevels();
  statistics.Texels +=
    static_cast<long long>(levels.GetNumberOfLevels()) * levels.GetWidth() * levels.GetHeight();
  return vtkNBufferDecision::None;
}

bool vtkNBufferBackend::CountFailure(vtkNBufferDecision failure)
{
  ++this->FailedFrames;
  return this->Told.insert(failure).second;
}

bool vtkNBufferBackend::DrawsOrdinaryDepth(const vtkNBufferDepthSource& source)
{
  GLint function = 0;
  GLint scissor[4] = { 0, 0, 0, 0 };
  GLboolean mask = GL_FALSE;
  glGetIntegerv(GL_DEPTH_FUNC, &function);
  glGetIntegerv(GL_SCISSOR_BOX, scissor);
  glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
  const int* viewport = source.Viewport;
  const bool wholeViewport = !glIsEnabled(GL_SCISSOR_TEST) ||
    (scissor[0] <= viewport[0] && scissor[1] <= viewport[1] &&
      scissor[0] + scissor[2] >= viewport[0] + viewport[2] &&
      scissor[1] + scissor[3] >= viewport[1] + viewport[3]);
  return glIsEnabled(GL_DEPTH_TEST) && (function == GL_LEQUAL || function == GL_LESS) && mask &&
    wholeViewport && source.DefaultDepthRange;
}

bool vtkNBufferBackend::BuildOnDevice(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, int factor, int levelsNeeded, vtkNBufferLevels& levels,
  vtkNBufferStatistics& statistics, std::string& why)
{
  vtkNBufferClock clock;
  const int* viewport = source.Viewport;
  if (!this->Texture->Build(window, source, viewport[0], viewport[1], viewport[2], viewport[3],
        factor, levelsNeeded, vtkNBufferExtremum::Maximum))
  {
    why = this->Texture->GetError();
    return false;
  }
  statistics.BuildTime += clock.Restart();
  if (!this->Texture->Download(window, levels))
  {
    why = this->Texture->GetError();
    return false;
  }
  statistics.ReadTime += clock.GetMilliseconds();
  ++statistics.ReadBacks;
  statistics.BytesRead += static_cast<long long>(sizeof(float)) * levels.GetNumberOfLevels() *
    levels.GetWidth() * levels.GetHeight();
  statistics.DeviceBuildTime = this->Texture->GetDeviceTime();
  return true;
}

bool vtkNBufferBackend::ReadDepth(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, vtkNBufferStatistics& statistics, std::string& why)
{
  const vtkNBufferClock clock;
  const int* viewport = source.Viewport;
  if (!source.Read(window, viewport[0], viewport[1], viewport[2], viewport[3], this->Depth, why))
  {
    this->Depth.clear();
    return false;
  }
  statistics.ReadTime += clock.GetMilliseconds();
  ++statistics.ReadBacks;
  statistics.BytesRead += static_cast<long long>(sizeof(float)) * viewport[2] * viewport[3];
  return true;
}

const float* vtkNBufferBackend::GetDepth(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, vtkNBufferStatistics& statistics)
{
  std::string why;
  if (this->Depth.empty() &&
    (source.Samples > 1 || !this->ReadDepth(window, source, statistics, why)))
  {
    return nullptr;
  }
  return this->Depth.data();
}

bool vtkNBufferBackend::BuildOnHost(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, int factor, int levelsNeeded, vtkNBufferLevels& levels,
  vtkNBufferStatistics& statistics, std::string& why)
{
  if (source.Samples > 1)
  {
    // Samples cannot be read; the device reduces them to level 0.
    if (!this->BuildOnDevice(window, source, factor, 1, levels, statistics, why))
    {
      return false;
    }
  }
  else
  {
    if (!this->ReadDepth(window, source, statistics, why))
    {
      return false;
    }
    const vtkNBufferClock clock;
    levels.BuildBase(this->Depth.data(), source.Viewport[2], source.Viewport[3], factor,
      vtkNBufferExtremum::Maximum);
    statistics.BuildTime += clock.GetMilliseconds();
  }
  const vtkNBufferClock clock;
  levels.BuildLevels(levelsNeeded);
  statistics.BuildTime += clock.GetMilliseconds();
  return true;
}
VTK_ABI_NAMESPACE_END
