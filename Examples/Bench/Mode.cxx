// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mode.h"

#include "ModeSettings.h"

#include "vtkNBufferRenderPassTraits.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferPeers::QueryMethod;
using NBufferPeers::QueryTarget;

/**
 * Draws opaque props twice: their depth alone, then their colours where they are seen.
 *
 * In the second drawing only what is nearest passes the depth test (VTK's is "not farther"), so
 * that a device that tests before it shades does so about once for each pixel. VTK has no shaders
 * for depth alone: the first drawing differs by masked colours only. The image is the same to the
 * bit, because the last of equal depths wins as before, and the same shader gives the same depth
 * again. To be used as the opaque pass of a vtkRenderStepsPass.
 */
class EarlyDepthPass
  : public vtkRenderPass
  , public vtkNBufferRenderPassTraits
{
public:
  static EarlyDepthPass* New() { VTK_STANDARD_NEW_BODY(EarlyDepthPass); }
  vtkTypeMacro(EarlyDepthPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    {
      vtkOpenGLState* openGL =
        static_cast<vtkOpenGLRenderWindow*>(state->GetRenderer()->GetRenderWindow())->GetState();
      const vtkOpenGLState::ScopedglColorMask mask(openGL);
      openGL->vtkglColorMask(false, false, false, false);
      this->Opaque->Render(state);
    }
    this->Opaque->Render(state);
    this->NumberOfRenderedProps = this->Opaque->GetNumberOfRenderedProps();
  }

  ///@{
  /// What the culler wants to know.
  std::vector<vtkRenderPass*> GetDelegatePasses() override { return { this->Opaque }; }
  bool DrawsOpaquePropsTwice() const override { return true; }
  ///@}

private:
  vtkNew<vtkOpaquePass> Opaque;
};

struct QueryMode
{
  const char* Name;
  QueryMethod Method;
  QueryTarget Target;
};
constexpr QueryMode QueryModes[] = { { "queries", QueryMethod::Flat, QueryTarget::Any },
  { "queries-conservative", QueryMethod::Flat, QueryTarget::AnyConservative },
  { "queries-count", QueryMethod::Flat, QueryTarget::Samples },
  { "chc", QueryMethod::Coherent, QueryTarget::Any } };

/// Returns the names of all modes, without settings.
std::vector<std::string> GetModeNames()
{
  std::vector<std::string> names = { "stock", "none", "nbuffer", "oracle", "in-view", "same-list",
    "early-depth", "early-depth-nbuffer" };
  for (const QueryMode& mode : QueryModes)
  {
    names.emplace_back(mode.Name);
  }
  return names;
}
}

std::string Mode::WhyNot(const std::string& name)
{
  const QueryMode* mode = FindNamed(QueryModes, name);
  return mode ? NBufferPeers::BoxQueries::WhyNot(mode->Target) : "";
}

Mode::Mode(const std::string& name, const std::string& backend)
  : Name(name)
{
  const std::string kind = GetModeKind(name);
  const std::vector<std::string> names = GetModeNames();
  if (std::find(names.begin(), names.end(), kind) == names.end())
  {
    std::string message = "no mode " + name + "; there are";
    for (const std::string& other : names)
    {
      message += " " + other;
    }
    throw std::runtime_error(message);
  }
  const bool isEarly = kind == "early-depth" || kind == "early-depth-nbuffer";
  const bool isNBuffer = kind == "nbuffer" || kind == "early-depth-nbuffer";
  if (kind != name && !isNBuffer)
  {
    throw std::runtime_error("mode " + kind + " has no settings, nbuffer has");
  }
  if (isEarly)
  {
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetOpaquePass(vtkNew<EarlyDepthPass>());
    this->Pass = steps;
  }
  if (kind == "stock" || isEarly || isNBuffer)
  {
    this->Cullers.push_back(vtkSmartPointer<vtkFrustumCoverageCuller>::New());
  }
  if (isNBuffer)
  {
    this->NBuffer = vtkSmartPointer<vtkNBufferCuller>::New();
    this->NBuffer->SetBackend(backend == "cpu" ? vtkNBufferCuller::CPU
        : backend == "opengl"                  ? vtkNBufferCuller::OpenGL
                                               : vtkNBufferCuller::Auto);
    ApplySettings(name, this->NBuffer.Get());
    this->Cullers.push_back(this->NBuffer);
  }
  if (name == "oracle" || name == "in-view" || name == "same-list")
  {
    this->Oracle = vtkSmartPointer<OracleCuller>::New();
    this->Cullers.push_back(this->Oracle);
  }
  if (const QueryMode* mode = FindNamed(QueryModes, name))
  {
    this->Queries = vtkSmartPointer<NBufferPeers::QueryCuller>::New();
    this->Queries->SetMethod(mode->Method);
    this->Queries->SetTarget(mode->Target);
    this->Cullers.push_back(this->Queries);
  }
}

int Mode::CountDrawn(vtkRenderer* renderer) const
{
  return this->Pass ? this->Pass->GetNumberOfRenderedProps() : renderer->GetNumberOfPropsRendered();
}

void Mode::Enter(vtkRenderer* renderer)
{
  renderer->GetCullers()->RemoveAllItems();
  for (vtkCuller* culler : this->Cullers)
  {
    renderer->AddCuller(culler);
  }
  renderer->SetPass(this->Pass);
}

void Mode::Leave(vtkRenderer* renderer)
{
  renderer->SetPass(nullptr);
  this->Cullers.clear();
  vtkCullerCollection* cullers = renderer->GetCullers();
  vtkCollectionSimpleIterator iterator;
  cullers->InitTraversal(iterator);
  while (vtkCuller* culler = cullers->GetNextCuller(iterator))
  {
    this->Cullers.emplace_back(culler);
  }
  cullers->RemoveAllItems();
}

} // namespace NBufferBench
