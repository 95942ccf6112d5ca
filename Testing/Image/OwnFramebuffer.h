// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OwnFramebuffer.h
 * @brief A prop that stands for an application with a framebuffer of its own.
 */
#ifndef OwnFramebuffer_h
#define OwnFramebuffer_h

#include "vtkNBufferVTKVersion.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"

#include <gtest/gtest.h>

#include VTKNBUFFER_GL_HEADER

/// An application that draws the opaque props into a framebuffer of its own: binds it when it is
/// drawn in the opaque stage, and copies the colours to where they belong in the overlay stage.
class OwnFramebuffer : public vtkProp
{
public:
  static OwnFramebuffer* New() { VTK_STANDARD_NEW_BODY(OwnFramebuffer); }
  vtkTypeMacro(OwnFramebuffer, vtkProp);

  int Samples = 0;
  bool WithDepth = true;

  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    const int* size = viewport->GetVTKWindow()->GetSize();
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->Before);
    glGenFramebuffers(1, &this->Name);
    glGenRenderbuffers(2, this->Buffers);
    this->State(viewport)->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Name);
    this->Attach(0, GL_COLOR_ATTACHMENT0, GL_RGBA8, size);
    if (this->WithDepth)
    {
      this->Attach(1, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, size);
    }
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
    this->State(viewport)->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    this->State(viewport)->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return 1;
  }
  int RenderOverlay(vtkViewport* viewport) override
  {
    const int* size = viewport->GetVTKWindow()->GetSize();
    this->State(viewport)->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Before);
    glBlitFramebuffer(
      0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
    this->State(viewport)->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Before);
    glDeleteFramebuffers(1, &this->Name);
    glDeleteRenderbuffers(2, this->Buffers);
    return 1;
  }

protected:
  OwnFramebuffer() = default;

private:
  static vtkOpenGLState* State(vtkViewport* viewport)
  {
    return static_cast<vtkOpenGLRenderWindow*>(viewport->GetVTKWindow())->GetState();
  }
  void Attach(int index, GLenum attachment, GLenum format, const int size[2])
  {
    glBindRenderbuffer(GL_RENDERBUFFER, this->Buffers[index]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, this->Samples, format, size[0], size[1]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, this->Buffers[index]);
  }

  GLint Before = 0;
  GLuint Name = 0;
  GLuint Buffers[2] = { 0, 0 };
};

#endif
