// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDebugView.h"

#include "vtkNBufferGL.h"
#include "vtkShadowCounter.h"

#include "vtkShadowDebugFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkShadowDebugView::vtkShadowDebugView()
  : Pass(vtkShadowDebugFS,
      "The shader for debug views does not compile on this driver. Switch them off, and report its "
      "message.")
{
}

bool vtkShadowDebugView::Make(vtkOpenGLRenderWindow* window, vtkShadowPicture picture,
  const Subject& subject, vtkShadowCounter& counter, vtkShadowStatistics& statistics,
  std::string& why)
{
  std::copy_n(subject.View.Viewport, 4, this->Viewport);
  this->Image.clear();
  if (picture == vtkShadowPicture::Litmaps)
  {
    this->Image = vtkShadowDebugImage::PaintLitmaps(
      subject.Litmaps, subject.NumberOfLitmaps, this->GetWidth(), this->GetHeight());
  }
  else if (picture == vtkShadowPicture::Extents)
  {
    this->Image =
      vtkShadowDebugImage::PaintExtents(subject.Draws, this->GetWidth(), this->GetHeight());
  }
  else if (picture != vtkShadowPicture::None &&
    !this->DrawVolumes(window, picture, subject, counter, statistics, why))
  {
    this->Image.clear();
    return false;
  }
  return true;
}

bool vtkShadowDebugView::Reserve(std::string& why)
{
  return this->Texture.ReserveTarget(
    GL_RGBA8, this->Viewport[0] + this->Viewport[2], this->Viewport[1] + this->Viewport[3], why);
}

bool vtkShadowDebugView::DrawVolumes(vtkOpenGLRenderWindow* window, vtkShadowPicture picture,
  const Subject& subject, vtkShadowCounter& counter, vtkShadowStatistics& statistics,
  std::string& why)
{
  const int* viewport = this->Viewport;
  this->Image.assign(4 * static_cast<std::size_t>(viewport[2]) * viewport[3], 0);
  if (subject.Draws.empty())
  {
    return true;
  }
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  if (!this->Reserve(why))
  {
    return false;
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Texture.GetFramebuffer());
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
  if (!counter.Show(window, subject.Volume, subject.View, subject.Draws,
        picture == vtkShadowPicture::Volumes, why))
  {
    return false;
  }
  ++statistics.DebugDraws;
  const vtkNBufferGL::ScopedReadback readback(this->Texture.GetFramebuffer());
  glReadPixels(viewport[0], viewport[1], viewport[2], viewport[3], GL_RGBA, GL_UNSIGNED_BYTE,
    this->Image.data());
  if (picture == vtkShadowPicture::Counts)
  {
    vtkShadowDebugImage::PaintCounts(this->Image);
  }
  return vtkNBufferGL::CheckErrors("Drawing volumes for a debug view", why);
}

bool vtkShadowDebugView::Show(
  vtkOpenGLRenderWindow* window, vtkShadowStatistics& statistics, std::string& why)
{
  if (this->Image.empty())
  {
    return true;
  }
  const int* viewport = this->Viewport;
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  vtkShaderProgram* program = this->Reserve(why) ? this->Pass.Begin(window, why) : nullptr;
  if (!program)
  {
    return false;
  }
  glBindTexture(GL_TEXTURE_2D, this->Texture.GetName());
  {
    const vtkNBufferGL::ScopedUpload upload(0);
    glTexSubImage2D(GL_TEXTURE_2D, 0, viewport[0], viewport[1], viewport[2], viewport[3], GL_RGBA,
      GL_UNSIGNED_BYTE, this->Image.data());
  }
  program->SetUniformi("image", 0);
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  const vtkNBufferGL::ScopedBlend blend(GL_FUNC_ADD, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  this->Pass.Draw();
  ++statistics.DebugDraws;
  return vtkNBufferGL::CheckErrors("Showing a debug view", why);
}

void vtkShadowDebugView::Release()
{
  this->Texture.Delete();
  this->Pass.Delete();
}
VTK_ABI_NAMESPACE_END
