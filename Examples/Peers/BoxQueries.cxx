// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoxQueries.h"

#include "PeerBoxFS.h"
#include "PeerBoxVS.h"

#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferResourceCallback.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace NBufferPeers
{
namespace
{
constexpr int StripVertices = 14;

unsigned int GetGLTarget(QueryTarget target)
{
  return target == QueryTarget::Any          ? GL_ANY_SAMPLES_PASSED
    : target == QueryTarget::AnyConservative ? GL_ANY_SAMPLES_PASSED_CONSERVATIVE
                                             : GL_SAMPLES_PASSED;
}
}

BoxQueries::BoxQueries()
  : ResourceCallback(std::make_unique<vtkOpenGLResourceFreeCallback<BoxQueries>>(
      this, &BoxQueries::ReleaseGraphicsResources))
{
}

BoxQueries::~BoxQueries()
{
  this->ResourceCallback->Release();
}

std::string BoxQueries::WhyNot(QueryTarget target)
{
  if (target == QueryTarget::AnyConservative && !vtkNBufferGL::HasVersion(4, 3))
  {
    return "GL_ANY_SAMPLES_PASSED_CONSERVATIVE needs OpenGL 4.3";
  }
  if (target == QueryTarget::Any && !vtkNBufferGL::HasVersion(3, 3))
  {
    return "GL_ANY_SAMPLES_PASSED needs OpenGL 3.3";
  }
  return "";
}

bool BoxQueries::Begin(vtkOpenGLRenderWindow* window, QueryTarget target, std::string& why)
{
  if (this->Window != window)
  {
    this->ResourceCallback->RegisterGraphicsResources(window);
    this->Window = window;
    window->MakeCurrent();
  }
  why = WhyNot(target);
  if (!why.empty())
  {
    return false;
  }
  this->Target = GetGLTarget(target);
  this->Count = 0;
  return vtkNBufferGL::UseProgram(window, this->Program, PeerBoxVS, PeerBoxFS,
           "the shader of the boxes does not compile on this driver", why) != nullptr;
}

int BoxQueries::Query(const ClipBox& box)
{
  const int query = this->Count++;
  if (query == static_cast<int>(this->Queries.size()))
  {
    this->Queries.emplace_back();
  }
  vtkOpenGLState* state = this->Window->GetState();
  const vtkOpenGLState::ScopedglColorMask colorMask(state);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  const vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  this->Window->GetShaderCache()->ReadyShaderProgram(this->Program);
  this->Program->SetUniform4fv("corners", 8, box.Corners);
  glBindVertexArray(this->Empty.Create());
  glBeginQuery(this->Target, this->Queries[query].Create());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, StripVertices);
  glEndQuery(this->Target);
  glBindVertexArray(0);
  return query;
}

bool BoxQueries::HasAnswer(int query) const
{
  GLuint available = 0;
  glGetQueryObjectuiv(this->Queries[query].GetName(), GL_QUERY_RESULT_AVAILABLE, &available);
  return available != 0;
}

bool BoxQueries::IsVisible(int query) const
{
  GLuint samples = 0;
  glGetQueryObjectuiv(this->Queries[query].GetName(), GL_QUERY_RESULT, &samples);
  return samples != 0;
}

void BoxQueries::ReleaseGraphicsResources(vtkWindow*)
{
  if (!this->ResourceCallback->IsReleasing())
  {
    this->ResourceCallback->Release();
    return;
  }
  this->Queries.clear();
  this->Empty.Delete();
  this->Program = nullptr;
  this->Window = nullptr;
}

} // namespace NBufferPeers
