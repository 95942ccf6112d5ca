// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mode.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkRenderer.h"

#include <stdexcept>

namespace NBufferBench
{

bool Mode::IsName(const std::string& name)
{
  return name == "stock" || name == "none" || name == "nbuffer" || name == "oracle";
}

Mode::Mode(const std::string& name, const ModeOptions& options)
  : Name(name)
{
  if (!IsName(name))
  {
    throw std::runtime_error("no mode " + name + "; there are stock, none, nbuffer and oracle");
  }
  if (name == "stock" || name == "nbuffer")
  {
    this->Cullers.push_back(vtkSmartPointer<vtkFrustumCoverageCuller>::New());
  }
  if (name == "nbuffer")
  {
    this->NBuffer = vtkSmartPointer<vtkNBufferCuller>::New();
    this->NBuffer->SetBackend(options.Backend == "cpu" ? vtkNBufferCuller::CPU
        : options.Backend == "opengl"                  ? vtkNBufferCuller::OpenGL
                                                       : vtkNBufferCuller::Auto);
    if (options.Base > 0)
    {
      this->NBuffer->SetBaseFactor(options.Base);
    }
    this->Cullers.push_back(this->NBuffer);
  }
  if (name == "oracle")
  {
    this->Oracle = vtkSmartPointer<OracleCuller>::New();
    this->Cullers.push_back(this->Oracle);
  }
}

void Mode::Enter(vtkRenderer* renderer)
{
  renderer->GetCullers()->RemoveAllItems();
  for (vtkCuller* culler : this->Cullers)
  {
    renderer->AddCuller(culler);
  }
}

void Mode::Leave(vtkRenderer* renderer)
{
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
