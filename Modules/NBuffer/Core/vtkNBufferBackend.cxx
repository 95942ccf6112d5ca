// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBackend.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthConvention.h"
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
  this->HasDepth = false;
  this->IsMerged = false;
  // Either path waits until earlier draws have finished. A trial must not count that time.
  if (wanted == Auto && this->Chosen == Auto)
  {
    glFinish();
  }
  const vtkNBufferClock clock;
  vtkNBufferDecision failure =
    this->InUse == OpenGL ? this->BuildOnDevice(job, why) : this->BuildOnHost(job, why);
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

void vtkNBufferBackend::Merge(const std::function<bool(vtkNBufferLevels&)>& merge, const Job& job)
{
  const vtkNBufferClock clock;
  vtkNBufferLevels& levels = job.Levels;
  // Levels above 0 are dropped, because they may have been built before the merge.
  levels.Allocate(
    job.Source.Viewport[2], job.Source.Viewport[3], job.Factor, 1, vtkNBufferExtremum::Maximum);
  this->IsMerged = merge(levels);
  const int built = levels.BuildLevels(job.NumberOfLevels);
  job.Statistics.Levels += built;
  job.Statistics.Texels += static_cast<long long>(built) * levels.GetWidth() * levels.GetHeight();
  job.Statistics.BuildTime += clock.GetMilliseconds();
}

bool vtkNBufferBackend::CountFailure(vtkNBufferDecision failure)
{
  ++this->FailedFrames;
  return this->WarnedOf.insert(failure).second;
}

bool vtkNBufferBackend::DrawsKnownDepth(const vtkNBufferDepthSource& source)
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
  return glIsEnabled(GL_DEPTH_TEST) && mask && wholeViewport &&
    !glIsEnabled(GL_POLYGON_OFFSET_FILL) && !glIsEnabled(GL_DEPTH_CLAMP) &&
    source.Stored != vtkNBufferStoredDepth::Other;
}

vtkNBufferDecision vtkNBufferBackend::Reduce(
  vtkNBufferTexture* texture, const Job& job, int factor, std::string& why, int levels)
{
  const vtkNBufferClock clock;
  const int* viewport = job.Source.Viewport;
  if (!texture->Build(job.Window, job.Source, viewport[0], viewport[1], viewport[2], viewport[3],
        factor, levels, vtkNBufferDepthConvention::GetFarthest(job.Source.Stored)))
  {
    why = texture->GetError();
    return texture->LacksFloatTextures() ? vtkNBufferDecision::NoFloatTextures
                                         : vtkNBufferDecision::NoDepth;
  }
  job.Statistics.BuildTime += clock.GetMilliseconds();
  job.Statistics.DeviceBuildTime = texture->GetDeviceTime();
  return vtkNBufferDecision::None;
}

vtkNBufferDecision vtkNBufferBackend::ReadBack(vtkNBufferTexture* texture, const Job& job,
  const std::vector<vtkNBufferRectangle>& rectangles, float* base, std::string& why)
{
  const vtkNBufferClock clock;
  if (!texture->Download(job.Window, rectangles, base))
  {
    why = texture->GetError();
    return vtkNBufferDecision::NoDepth;
  }
  job.Statistics.ReadTime += clock.GetMilliseconds();
  ++job.Statistics.ReadBacks;
  for (const vtkNBufferRectangle& rectangle : rectangles)
  {
    job.Statistics.BytesRead +=
      static_cast<long long>(sizeof(float)) * rectangle.GetWidth() * rectangle.GetHeight();
    for (int y = rectangle.Y0; y < rectangle.Y1; ++y)
    {
      vtkNBufferDepthConvention::ToOrders(job.Source.Stored,
        base + static_cast<std::size_t>(y) * texture->GetWidth() + rectangle.X0,
        rectangle.GetWidth());
    }
  }
  return vtkNBufferDecision::None;
}

vtkNBufferDecision vtkNBufferBackend::BuildOnDevice(const Job& job, std::string& why)
{
  vtkNBufferDecision failure = Reduce(this->Texture, job, job.Factor, why);
  if (failure != vtkNBufferDecision::None)
  {
    return failure;
  }
  vtkNBufferLevels& levels = job.Levels;
  levels.Allocate(
    job.Source.Viewport[2], job.Source.Viewport[3], job.Factor, 1, vtkNBufferExtremum::Maximum);
  failure = ReadBack(this->Texture, job, { { 0, 0, levels.GetWidth(), levels.GetHeight() } },
    levels.GetLevelData(0), why);
  if (failure == vtkNBufferDecision::None)
  {
    const vtkNBufferClock clock;
    levels.BuildLevels(job.NumberOfLevels);
    job.Statistics.BuildTime += clock.GetMilliseconds();
  }
  return failure;
}

vtkNBufferDecision vtkNBufferBackend::ReadDepth(const Job& job, std::string& why)
{
  const vtkNBufferClock clock;
  const int* viewport = job.Source.Viewport;
  const std::size_t width = viewport[2];
  const std::size_t first = width * job.Rows.Begin;
  const std::size_t end = width * job.Rows.End;
  this->ClearDepth(width * viewport[3], first, end);
  if (first == end)
  {
    return vtkNBufferDecision::None;
  }
  if (job.Source.Samples > 1)
  {
    // OpenGL cannot read samples: the device reduces them to the farthest one of each pixel.
    const vtkNBufferDecision failure = Reduce(this->FarthestTexture, job, 1, why);
    return failure != vtkNBufferDecision::None
      ? failure
      : ReadBack(this->FarthestTexture, job, { { 0, job.Rows.Begin, viewport[2], job.Rows.End } },
          this->Depth.data(), why);
  }
  float* const depth = this->Depth.data() + first;
  if (!job.Source.Read(job.Window, viewport[0], viewport[1] + job.Rows.Begin, viewport[2],
        job.Rows.End - job.Rows.Begin, depth, why,
        vtkNBufferDepthConvention::GetFarthest(job.Source.Stored)))
  {
    return vtkNBufferDecision::NoDepth;
  }
  vtkNBufferDepthConvention::ToOrders(job.Source.Stored, depth, end - first);
  job.Statistics.ReadTime += clock.GetMilliseconds();
  ++job.Statistics.ReadBacks;
  job.Statistics.BytesRead += static_cast<long long>(sizeof(float) * (end - first));
  return vtkNBufferDecision::None;
}

void vtkNBufferBackend::ClearDepth(std::size_t size, std::size_t first, std::size_t end)
{
  this->Depth.resize(size, vtkNBufferDepthConvention::Background);
  const std::size_t endRead = std::min(this->EndRead, size);
  float* const depth = this->Depth.data();
  const auto clear = [depth](std::size_t from, std::size_t to)
  { std::fill(depth + std::min(from, to), depth + to, vtkNBufferDepthConvention::Background); };
  clear(this->FirstRead, std::min(endRead, first));
  clear(std::max(this->FirstRead, end), endRead);
  this->FirstRead = first;
  this->EndRead = end;
}

const float* vtkNBufferBackend::GetDepth(
  const Job& job, const std::vector<vtkNBufferRectangle>& rectangles)
{
  if (this->InUse == CPU)
  {
    return this->HasDepth ? this->Depth.data() : nullptr;
  }
  const int* viewport = job.Source.Viewport;
  std::string why;
  if (!this->HasDepth)
  {
    if (Reduce(this->FarthestTexture, job, 1, why) != vtkNBufferDecision::None)
    {
      return nullptr;
    }
    const std::size_t size = static_cast<std::size_t>(viewport[2]) * viewport[3];
    this->ClearDepth(size, 0, size);
    this->Tiles.Begin(viewport[2], viewport[3]);
    this->HasDepth = true;
  }
  const std::vector<vtkNBufferRectangle> unread = this->Tiles.Add(rectangles);
  if (!unread.empty())
  {
    this->HasDepth = ReadBack(this->FarthestTexture, job, unread, this->Depth.data(), why) ==
      vtkNBufferDecision::None;
  }
  return this->HasDepth ? this->Depth.data() : nullptr;
}

const vtkNBufferTexture* vtkNBufferBackend::GetTexture(const Job& job)
{
  if (this->InUse != OpenGL || this->IsMerged ||
    job.Source.Stored != vtkNBufferStoredDepth::Ordinary)
  {
    return nullptr;
  }
  // Build() has made only level 0 of it.
  std::string why;
  const bool isBuilt = this->Texture->GetNumberOfLevels() == job.NumberOfLevels ||
    Reduce(this->Texture, job, job.Factor, why, job.NumberOfLevels) == vtkNBufferDecision::None;
  return isBuilt ? this->Texture.Get() : nullptr;
}

vtkNBufferDecision vtkNBufferBackend::BuildOnHost(const Job& job, std::string& why)
{
  const vtkNBufferDecision failure = this->ReadDepth(job, why);
  if (failure != vtkNBufferDecision::None)
  {
    return failure;
  }
  this->HasDepth = true;
  const vtkNBufferClock clock;
  job.Levels.BuildBase(this->Depth.data(), job.Source.Viewport[2], job.Source.Viewport[3],
    job.Factor, vtkNBufferExtremum::Maximum, job.Rows);
  job.Levels.BuildLevels(job.NumberOfLevels);
  job.Statistics.BuildTime += clock.GetMilliseconds();
  return vtkNBufferDecision::None;
}
VTK_ABI_NAMESPACE_END
