// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBackend.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"

#include VTKNBUFFER_GL_HEADER

VTK_ABI_NAMESPACE_BEGIN
static_assert(vtkNBufferDepthConvention::PassIfNearer == GL_LESS &&
  vtkNBufferDepthConvention::PassIfNearerOrEqual == GL_LEQUAL &&
  vtkNBufferDepthConvention::PassIfFarther == GL_GREATER);

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
    this->Settle(Auto, "trying both");
    this->Trial = 0;
    if (const char* software = vtkNBufferGL::GetSoftwareRenderer())
    {
      this->Settle(CPU,
        std::string("software renderer (") + software +
          "): building on the host costs a tenth of the passes or less");
    }
  }
  this->Reason = this->ReasonOfChoice;
  if (this->Chosen != Auto)
  {
    return this->Chosen;
  }
  // Warm up, time the device, time the host.
  return this->Trial < 2 ? OpenGL : CPU;
}

void vtkNBufferBackend::Settle(Kind kind, const std::string& reason)
{
  this->Chosen = kind;
  this->Reason = this->ReasonOfChoice = reason;
}

void vtkNBufferBackend::RecordTrial(double milliseconds)
{
  ++this->Trial;
  if (this->Trial == 2)
  {
    this->DeviceTime = milliseconds;
  }
  else if (this->Trial == 3)
  {
    this->Settle(this->DeviceTime <= milliseconds ? OpenGL : CPU,
      "measured: OpenGL " + std::to_string(this->DeviceTime) + " ms, CPU " +
        std::to_string(milliseconds) + " ms");
  }
}

vtkNBufferDecision vtkNBufferBackend::Build(Kind wanted, const Job& job, std::string& why)
{
  this->InUse = this->Choose(wanted, job.Window);
  this->Depth.clear();
  // Either path waits for what is still being drawn. That time must not count in a trial.
  if (wanted == Auto && this->Chosen == Auto)
  {
    glFinish();
  }
  const vtkNBufferClock clock;
  vtkNBufferDecision failure = this->InUse == OpenGL
    ? this->BuildOnDevice(job, job.NumberOfLevels, why)
    : this->BuildOnHost(job, why);
  if (failure != vtkNBufferDecision::None && this->InUse == OpenGL && wanted == Auto)
  {
    this->InUse = CPU;
    this->Settle(CPU, "the device cannot build: " + why);
    failure = this->BuildOnHost(job, why);
  }
  if (failure != vtkNBufferDecision::None)
  {
    job.Levels.Clear();
    return failure;
  }
  if (wanted == Auto && this->Chosen == Auto)
  {
    this->RecordTrial(clock.GetMilliseconds());
  }
  const vtkNBufferLevels& levels = job.Levels;
  job.Statistics.Levels += levels.GetNumberOfLevels();
  job.Statistics.Texels +=
    static_cast<long long>(levels.GetNumberOfLevels()) * levels.GetWidth() * levels.GetHeight();
  return vtkNBufferDecision::None;
}

bool vtkNBufferBackend::CountFailure(vtkNBufferDecision failure)
{
  ++this->FailedFrames;
  return this->WarnedOf.insert(failure).second;
}

bool vtkNBufferBackend::DrawsOrdinaryDepth(const vtkNBufferDepthSource& source)
{
  GLint scissor[4] = { 0, 0, 0, 0 };
  GLboolean mask = GL_FALSE;
  glGetIntegerv(GL_SCISSOR_BOX, scissor);
  glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
  const int* viewport = source.Viewport;
  const bool wholeViewport = !glIsEnabled(GL_SCISSOR_TEST) ||
    (scissor[0] <= viewport[0] && scissor[1] <= viewport[1] &&
      scissor[0] + scissor[2] >= viewport[0] + viewport[2] &&
      scissor[1] + scissor[3] >= viewport[1] + viewport[3]);
  const auto passes = static_cast<unsigned int>(vtkNBufferGL::GetInteger(GL_DEPTH_FUNC));
  const bool passesIfNearer = passes == vtkNBufferDepthConvention::PassIfNearerOrEqual ||
    passes == vtkNBufferDepthConvention::PassIfNearer;
  return glIsEnabled(GL_DEPTH_TEST) && passesIfNearer && mask && wholeViewport &&
    source.DefaultDepthRange;
}

vtkNBufferDecision vtkNBufferBackend::BuildOnDevice(const Job& job, int levels, std::string& why)
{
  vtkNBufferClock clock;
  const int* viewport = job.Source.Viewport;
  vtkNBufferStatistics& statistics = job.Statistics;
  if (!this->Texture->Build(job.Window, job.Source, viewport[0], viewport[1], viewport[2],
        viewport[3], job.Factor, levels, vtkNBufferDepthConvention::Farthest))
  {
    why = this->Texture->GetError();
    return this->Texture->LacksFloatTextures() ? vtkNBufferDecision::NoFloatTextures
                                               : vtkNBufferDecision::NoDepth;
  }
  statistics.BuildTime += clock.Restart();
  if (!this->Texture->Download(job.Window, job.Levels))
  {
    why = this->Texture->GetError();
    return vtkNBufferDecision::NoDepth;
  }
  statistics.ReadTime += clock.GetMilliseconds();
  ++statistics.ReadBacks;
  statistics.BytesRead += static_cast<long long>(sizeof(float)) * job.Levels.GetNumberOfLevels() *
    job.Levels.GetWidth() * job.Levels.GetHeight();
  statistics.DeviceBuildTime = this->Texture->GetDeviceTime();
  return vtkNBufferDecision::None;
}

bool vtkNBufferBackend::ReadDepth(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, vtkNBufferStatistics& statistics, std::string& why)
{
  const vtkNBufferClock clock;
  const int* viewport = source.Viewport;
  if (!source.Read(window, viewport[0], viewport[1], viewport[2], viewport[3], this->Depth, why,
        vtkNBufferDepthConvention::Farthest))
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

vtkNBufferDecision vtkNBufferBackend::BuildOnHost(const Job& job, std::string& why)
{
  if (job.Source.Samples > 1)
  {
    // Samples cannot be read; the device reduces them to level 0.
    const vtkNBufferDecision failure = this->BuildOnDevice(job, 1, why);
    if (failure != vtkNBufferDecision::None)
    {
      return failure;
    }
  }
  else
  {
    if (!this->ReadDepth(job.Window, job.Source, job.Statistics, why))
    {
      return vtkNBufferDecision::NoDepth;
    }
    const vtkNBufferClock clock;
    job.Levels.BuildBase(this->Depth.data(), job.Source.Viewport[2], job.Source.Viewport[3],
      job.Factor, vtkNBufferDepthConvention::Farthest);
    job.Statistics.BuildTime += clock.GetMilliseconds();
  }
  const vtkNBufferClock clock;
  job.Levels.BuildLevels(job.NumberOfLevels);
  job.Statistics.BuildTime += clock.GetMilliseconds();
  return vtkNBufferDecision::None;
}
VTK_ABI_NAMESPACE_END
