// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBackend.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"

#include VTKNBUFFER_GL_HEADER

VTK_ABI_NAMESPACE_BEGIN
constexpr bool FarIsLarge = vtkNBufferDepthConvention::Sign > 0.0;
static_assert(vtkNBufferDepthConvention::PassIfNearer == (FarIsLarge ? GL_LESS : GL_GREATER) &&
  vtkNBufferDepthConvention::PassIfNearerOrEqual == (FarIsLarge ? GL_LEQUAL : GL_GEQUAL) &&
  vtkNBufferDepthConvention::PassIfFarther == (FarIsLarge ? GL_GREATER : GL_LESS));

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
  // Three builds: warm the device up, measure the device, measure the host.
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
  // Either path waits until earlier draws have finished. A trial must not count that time.
  if (wanted == Auto && this->Chosen == Auto)
  {
    glFinish();
  }
  const vtkNBufferClock clock;
  vtkNBufferDecision failure =
    this->InUse == OpenGL ? BuildOnDevice(this->Texture, job, why) : this->BuildOnHost(job, why);
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

vtkNBufferDecision vtkNBufferBackend::BuildOnDevice(
  vtkNBufferTexture* texture, const Job& job, std::string& why)
{
  vtkNBufferClock clock;
  const int* viewport = job.Source.Viewport;
  vtkNBufferStatistics& statistics = job.Statistics;
  if (!texture->Build(job.Window, job.Source, viewport[0], viewport[1], viewport[2], viewport[3],
        job.Factor, job.NumberOfLevels, vtkNBufferDepthConvention::Farthest))
  {
    why = texture->GetError();
    return texture->LacksFloatTextures() ? vtkNBufferDecision::NoFloatTextures
                                         : vtkNBufferDecision::NoDepth;
  }
  statistics.BuildTime += clock.Restart();
  if (!texture->Download(job.Window, job.Levels))
  {
    why = texture->GetError();
    return vtkNBufferDecision::NoDepth;
  }
  statistics.ReadTime += clock.GetMilliseconds();
  ++statistics.ReadBacks;
  statistics.BytesRead += static_cast<long long>(sizeof(float)) * job.Levels.GetNumberOfLevels() *
    job.Levels.GetWidth() * job.Levels.GetHeight();
  statistics.DeviceBuildTime = texture->GetDeviceTime();
  return vtkNBufferDecision::None;
}

vtkNBufferDecision vtkNBufferBackend::ReadDepth(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, vtkNBufferStatistics& statistics, std::string& why)
{
  const int* viewport = source.Viewport;
  if (source.Samples > 1)
  {
    // OpenGL cannot read samples: the device reduces them to the farthest one of each pixel.
    const Job job = { window, source, 1, 1, this->FarthestSamples, statistics };
    const vtkNBufferDecision failure = BuildOnDevice(this->FarthestTexture, job, why);
    if (failure == vtkNBufferDecision::None)
    {
      const float* texels = this->FarthestSamples.GetLevelData(0);
      this->Depth.assign(texels, texels + static_cast<std::size_t>(viewport[2]) * viewport[3]);
    }
    return failure;
  }
  const vtkNBufferClock clock;
  if (!source.Read(window, viewport[0], viewport[1], viewport[2], viewport[3], this->Depth, why,
        vtkNBufferDepthConvention::Farthest))
  {
    this->Depth.clear();
    return vtkNBufferDecision::NoDepth;
  }
  statistics.ReadTime += clock.GetMilliseconds();
  ++statistics.ReadBacks;
  statistics.BytesRead += static_cast<long long>(sizeof(float)) * viewport[2] * viewport[3];
  return vtkNBufferDecision::None;
}

const float* vtkNBufferBackend::GetDepth(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, vtkNBufferStatistics& statistics)
{
  std::string why;
  const bool known = !this->Depth.empty() ||
    this->ReadDepth(window, source, statistics, why) == vtkNBufferDecision::None;
  return known ? this->Depth.data() : nullptr;
}

vtkNBufferDecision vtkNBufferBackend::BuildOnHost(const Job& job, std::string& why)
{
  const vtkNBufferDecision failure = this->ReadDepth(job.Window, job.Source, job.Statistics, why);
  if (failure != vtkNBufferDecision::None)
  {
    return failure;
  }
  const vtkNBufferClock clock;
  job.Levels.BuildBase(this->Depth.data(), job.Source.Viewport[2], job.Source.Viewport[3],
    job.Factor, vtkNBufferDepthConvention::Farthest);
  job.Levels.BuildLevels(job.NumberOfLevels);
  job.Statistics.BuildTime += clock.GetMilliseconds();
  return vtkNBufferDecision::None;
}
VTK_ABI_NAMESPACE_END
