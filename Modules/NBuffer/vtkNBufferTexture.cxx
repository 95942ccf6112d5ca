// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTexture.h"

#include "Shaders/vtkNBufferShared.h"
#include "vtkNBufferBaseFS.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferLevelFS.h"
#include "vtkNBufferResourceCallback.h"
#include "vtkNBufferTextureStorage.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <optional>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferTexture);

namespace
{
constexpr const char* Failure =
  "A shader of the N-buffer does not compile on this driver. Use the CPU back-end and report the "
  "driver's message.";

std::string Define(const char* name, int value)
{
  return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}
}

class vtkNBufferTexture::Internals
{
public:
  using Callback = vtkOpenGLResourceFreeCallback<vtkNBufferTexture>;

  explicit Internals(vtkNBufferTexture* self)
    : ResourceCallback(new Callback(self, &vtkNBufferTexture::ReleaseGraphicsResources))
  {
  }

  bool CheckArguments(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source, int x,
    int y, int width, int height, int factor, int levels);
  void UseContext(vtkOpenGLRenderWindow* window);
  bool DrawBase(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source,
    const vtkNBufferTextureStorage::SampledDepth& depth);
  bool DrawLevel(vtkOpenGLRenderWindow* window, int level);
  bool Read(vtkOpenGLRenderWindow* window, const std::vector<vtkNBufferRectangle>& rectangles,
    int levels, float* texels);
  bool IsBuilt(int level) const { return level >= 0 && level < this->NumberOfLevels; }
  void Delete(vtkNBufferGL::Context context);

  int PixelWidth = 0;
  int PixelHeight = 0;
  int Factor = 1;
  int Width = 0;
  int Height = 0;
  int NumberOfLevels = 0;
  vtkNBufferExtremum Extremum = vtkNBufferExtremum::Maximum;
  int Draws = 0;
  int Downloads = 0;
  bool HasBoth = false;
  bool LacksFloatTextures = false;
  std::string Error;
  vtkNBufferTextureStorage Storage;
  vtkOpenGLRenderWindow* Window = nullptr; ///< The window whose context holds the objects.
  std::unique_ptr<Callback> ResourceCallback;
  std::unique_ptr<vtkOpenGLRenderTimer> Timer;

private:
  void Draw(vtkNBufferGL::FullScreenPass& pass, int level);
  std::string DefineExtrema() const
  {
    return Define("NBUFFER_MAXIMUM", this->Extremum == vtkNBufferExtremum::Maximum) +
      Define("NBUFFER_BOTH", this->HasBoth);
  }

  vtkMTimeType ContextTime = 0;
  vtkNBufferGL::FullScreenPass BasePass = { vtkNBufferBaseFS, Failure };
  vtkNBufferGL::FullScreenPass LevelPass = { vtkNBufferLevelFS, Failure };
};

bool vtkNBufferTexture::Internals::CheckArguments(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, int x, int y, int width, int height, int factor, int levels)
{
  this->Error.clear();
  if (!window)
  {
    this->Error = "There is no render window. Pass the one that is drawn.";
  }
  else if (!source.Holds(x, y, width, height, this->Error))
  {
    return false;
  }
  else if (factor != 1 && factor != 2 && factor != 4 && factor != 8)
  {
    this->Error = "The base factor is " + std::to_string(factor) + ". It must be 1, 2, 4 or 8.";
  }
  else if (levels < 1)
  {
    this->Error = "No level was requested. Request at least one.";
  }
  else if (source.Samples > 1 && !source.Texture)
  {
    this->Error = "Multisampled depth in a renderbuffer or in the window's own framebuffer cannot "
                  "be sampled. Attach a multisampled depth texture or call SetMultiSamples(0) on "
                  "the render window.";
  }
  return this->Error.empty();
}

void vtkNBufferTexture::Internals::UseContext(vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    // This releases the objects of another window. Most window classes then leave that window's
    // context current.
    this->ResourceCallback->RegisterGraphicsResources(window);
    this->Window = window;
    window->MakeCurrent();
  }
  if (this->ContextTime == window->GetContextCreationTime())
  {
    return;
  }
  // The window has another context now, and the objects are gone with the old one.
  if (this->ContextTime != 0)
  {
    this->Delete(vtkNBufferGL::Context::Gone);
  }
  this->ContextTime = window->GetContextCreationTime();
  if (vtkNBufferGL::HasFeature(3, 3, "GL_ARB_timer_query") && vtkOpenGLRenderTimer::IsSupported())
  {
    this->Timer = std::make_unique<vtkOpenGLRenderTimer>();
  }
}

void vtkNBufferTexture::Internals::Draw(vtkNBufferGL::FullScreenPass& pass, int level)
{
  pass.Draw(this->Storage.GetFramebuffer(level), 0, 0, this->Width, this->Height);
  ++this->Draws;
}

bool vtkNBufferTexture::Internals::DrawBase(vtkOpenGLRenderWindow* window,
  const vtkNBufferDepthSource& source, const vtkNBufferTextureStorage::SampledDepth& depth)
{
  vtkShaderProgram* program = this->BasePass.Begin(window, this->Error,
    this->DefineExtrema() + Define("NBUFFER_SOURCE", depth.Kind) +
      Define("NBUFFER_FACTOR", this->Factor) +
      Define("NBUFFER_SAMPLES", std::max(source.Samples, 1)) +
      Define("NBUFFER_INEXACT", source.Samples > 1 && source.ExceedsFloats()));
  if (!program)
  {
    return false;
  }
  const int last[2] = { this->PixelWidth - 1, this->PixelHeight - 1 };
  program->SetUniformi("depth", 0);
  program->SetUniform2i("origin", depth.Origin);
  program->SetUniform2i("last", last);
  std::optional<vtkNBufferGL::ScopedDepthSampling> sampling;
  if (depth.Foreign)
  {
    sampling.emplace(depth.Target, depth.Level);
  }
  this->Draw(this->BasePass, 0);
  return true;
}

bool vtkNBufferTexture::Internals::DrawLevel(vtkOpenGLRenderWindow* window, int level)
{
  vtkShaderProgram* program = this->LevelPass.Begin(window, this->Error, this->DefineExtrema());
  if (!program)
  {
    return false;
  }
  const int last[2] = { this->Width - 1, this->Height - 1 };
  program->SetUniformi("below", 0);
  program->SetUniformi("layer", vtkNBufferTextureStorage::GetLayer(level - 1));
  program->SetUniformi("side", 1 << (level - 1));
  program->SetUniform2i("last", last);
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Storage.GetArray(level - 1));
  this->Draw(this->LevelPass, level);
  return true;
}

bool vtkNBufferTexture::Internals::Read(vtkOpenGLRenderWindow* window,
  const std::vector<vtkNBufferRectangle>& rectangles, int levels, float* texels)
{
  if (this->NumberOfLevels == 0 || this->Window != window)
  {
    this->Error = "There are no levels to read back in this window. Build them first.";
    return false;
  }
  vtkNBufferGL::ClearErrors();
  this->Error.clear();
  ++this->Downloads;
  return this->Storage.Read(rectangles, levels, this->Width, this->Height, texels, this->Error);
}

void vtkNBufferTexture::Internals::Delete(vtkNBufferGL::Context context)
{
  this->Storage.Delete(context);
  this->BasePass.Delete(context);
  this->LevelPass.Delete(context);
  if (context == vtkNBufferGL::Context::Gone)
  {
    // The queries of a destroyed context cannot be deleted, so their names are given up.
    this->Timer.release();
  }
  this->Timer.reset();
  this->ContextTime = 0;
  this->NumberOfLevels = 0;
}

vtkNBufferTexture::vtkNBufferTexture()
  : Implementation(new Internals(this))
{
}

vtkNBufferTexture::~vtkNBufferTexture()
{
  this->Implementation->ResourceCallback->Release();
}

bool vtkNBufferTexture::Build(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source,
  int x, int y, int width, int height, int factor, int levels, vtkNBufferExtremum extremum)
{
  Internals& self = *this->Implementation;
  self.NumberOfLevels = 0;
  self.Draws = 0;
  self.LacksFloatTextures = !this->AllowFloatTextures;
  if (!self.CheckArguments(window, source, x, y, width, height, factor, levels))
  {
    return false;
  }
  if (!this->AllowFloatTextures)
  {
    self.Error = "Float textures are switched off (AllowFloatTextures). Switch them on, or use the "
                 "CPU back-end without multisampling.";
    return false;
  }
  self.UseContext(window);
  self.PixelWidth = width;
  self.PixelHeight = height;
  self.Factor = factor;
  self.Extremum = extremum;
  self.HasBoth = this->BothExtrema;
  self.Width = vtkNBufferMath::GetBaseSize(width, factor);
  self.Height = vtkNBufferMath::GetBaseSize(height, factor);
  const int count = std::min(levels, vtkNBufferMath::GetNumberOfLevels(self.Width, self.Height));

  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  const int channels = self.HasBoth ? 2 : 1;
  if (!self.Storage.ReserveLevels(self.Width, self.Height, count, channels, self.Error))
  {
    self.LacksFloatTextures = true;
    return false;
  }
  // The timer starts again only after the time that it measured last has been read.
  this->GetDeviceTime();
  if (self.Timer)
  {
    self.Timer->ReusableStart();
  }
  vtkNBufferTextureStorage::SampledDepth depth;
  bool drawn = self.Storage.BindDepth(source, x, y, width, height, depth, self.Error) &&
    self.DrawBase(window, source, depth);
  for (int level = 1; drawn && level < count; ++level)
  {
    drawn = self.DrawLevel(window, level);
  }
  if (self.Timer)
  {
    self.Timer->ReusableStop();
  }
  if (!drawn || !vtkNBufferGL::CheckErrors("Building the levels", self.Error))
  {
    return false;
  }
  self.NumberOfLevels = count;
  return true;
}

bool vtkNBufferTexture::Build(
  vtkOpenGLRenderWindow* window, int factor, int levels, vtkNBufferExtremum extremum)
{
  vtkNBufferDepthSource source;
  this->Implementation->NumberOfLevels = 0;
  const int(&r)[4] = source.Viewport;
  return (!window || source.Inspect(window, this->Implementation->Error)) &&
    this->Build(window, source, r[0], r[1], r[2], r[3], factor, levels, extremum);
}

bool vtkNBufferTexture::Download(vtkOpenGLRenderWindow* window, vtkNBufferLevels& levels)
{
  Internals& self = *this->Implementation;
  levels.Allocate(
    self.PixelWidth, self.PixelHeight, self.Factor, self.NumberOfLevels, self.Extremum);
  const bool done = self.Read(
    window, { { 0, 0, self.Width, self.Height } }, self.NumberOfLevels, levels.GetLevelData(0));
  if (!done)
  {
    levels.Clear();
  }
  return done;
}

bool vtkNBufferTexture::Download(
  vtkOpenGLRenderWindow* window, const std::vector<vtkNBufferRectangle>& rectangles, float* base)
{
  return rectangles.empty() || this->Implementation->Read(window, rectangles, 1, base);
}

bool vtkNBufferTexture::LacksFloatTextures() const
{
  return this->Implementation->LacksFloatTextures;
}

int vtkNBufferTexture::GetWidth() const
{
  return this->Implementation->NumberOfLevels > 0 ? this->Implementation->Width : 0;
}

int vtkNBufferTexture::GetHeight() const
{
  return this->Implementation->NumberOfLevels > 0 ? this->Implementation->Height : 0;
}

int vtkNBufferTexture::GetNumberOfLevels() const
{
  return this->Implementation->NumberOfLevels;
}

unsigned int vtkNBufferTexture::GetHandle(int level) const
{
  return this->Implementation->IsBuilt(level) ? this->Implementation->Storage.GetArray(level) : 0;
}

int vtkNBufferTexture::GetLayer(int level) const
{
  return this->Implementation->IsBuilt(level) ? vtkNBufferTextureStorage::GetLayer(level) : 0;
}

int vtkNBufferTexture::GetNumberOfDraws() const
{
  return this->Implementation->Draws;
}

int vtkNBufferTexture::GetNumberOfAllocations() const
{
  return this->Implementation->Storage.GetNumberOfAllocations();
}

int vtkNBufferTexture::GetNumberOfDownloads() const
{
  return this->Implementation->Downloads;
}

const std::string& vtkNBufferTexture::GetError() const
{
  return this->Implementation->Error;
}

double vtkNBufferTexture::GetDeviceTime()
{
  // The timer returns 0 until its first query has finished, then the time of the last one.
  const auto& timer = this->Implementation->Timer;
  return timer ? 1e3 * timer->GetReusableElapsedSeconds() : 0.0;
}

void vtkNBufferTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& self = *this->Implementation;
  if (!self.ResourceCallback->IsReleasing())
  {
    // This calls back with the context current, or does nothing where there are no objects.
    self.ResourceCallback->Release();
    return;
  }
  self.Delete(vtkNBufferGL::Context::Current);
  self.Window = nullptr;
}

void vtkNBufferTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AllowFloatTextures: " << (this->AllowFloatTextures ? "On" : "Off") << "\n";
  os << indent << "BothExtrema: " << (this->BothExtrema ? "On" : "Off") << "\n";
  os << indent << "Width: " << this->GetWidth() << "\n";
  os << indent << "Height: " << this->GetHeight() << "\n";
  os << indent << "NumberOfLevels: " << this->GetNumberOfLevels() << "\n";
  os << indent << "NumberOfDraws: " << this->GetNumberOfDraws() << "\n";
  os << indent << "NumberOfAllocations: " << this->GetNumberOfAllocations() << "\n";
  os << indent << "NumberOfDownloads: " << this->GetNumberOfDownloads() << "\n";
  os << indent << "Error: " << (this->GetError().empty() ? "(none)" : this->GetError()) << "\n";
}
VTK_ABI_NAMESPACE_END
