// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDepthExchange.h"

#include "vtkNBufferSharedDepth.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Compositing observes the end of the frame, too, with priority 0. All ranks have to join the
/// exchanges before that.
constexpr float BeforeCompositing = 1000.0F;
}

vtkNBufferDepthExchange::vtkNBufferDepthExchange()
  : Shared(std::make_shared<vtkNBufferSharedDepth>(
      [exchange = vtkWeakPointer<vtkNBufferDepthExchange>(this)](const float* values, float* minima,
        int count) { return exchange && exchange->ReduceToMinimum(values, minima, count); }))
{
}

vtkNBufferDepthExchange::~vtkNBufferDepthExchange()
{
  this->SetRenderer(nullptr);
}

void vtkNBufferDepthExchange::SetRenderer(vtkRenderer* renderer)
{
  if (renderer == this->Renderer)
  {
    return;
  }
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(std::exchange(this->Observer, 0));
  }
  this->Renderer = renderer;
  this->Observe();
  this->Modified();
}

bool vtkNBufferDepthExchange::Observe()
{
  if (!this->Renderer || this->Renderer->GetCommand(this->Observer))
  {
    return false;
  }
  this->Observer = this->Renderer->AddObserver(
    vtkCommand::EndEvent, this, &vtkNBufferDepthExchange::EndFrame, BeforeCompositing);
  return true;
}

vtkRenderer* vtkNBufferDepthExchange::GetRenderer() const
{
  return this->Renderer;
}

void vtkNBufferDepthExchange::SetTileSize(int pixels)
{
  if (pixels != 1 && pixels != 2 && pixels != 4 && pixels != 8)
  {
    vtkErrorMacro("TileSize is 1, 2, 4 or 8, and not " << pixels << "; it stays as it was.");
    return;
  }
  if (pixels != this->TileSize)
  {
    this->TileSize = pixels;
    this->Modified();
  }
}

int vtkNBufferDepthExchange::GetNumberOfExchanges() const
{
  return this->Shared->GetCounts().Exchanges;
}

long long vtkNBufferDepthExchange::GetNumberOfBytes() const
{
  return this->Shared->GetCounts().Bytes;
}

double vtkNBufferDepthExchange::GetExchangeTime() const
{
  return this->Shared->GetCounts().Time;
}

bool vtkNBufferDepthExchange::IsOn()
{
  return this->ParallelRendering && this->Renderer && this->Renderer->GetRenderWindow() &&
    this->GetNumberOfRanks() > 1;
}

std::shared_ptr<vtkNBufferSharedDepth> vtkNBufferDepthExchange::GetSharedDepth(
  vtkRenderer* renderer)
{
  if (renderer != this->Renderer || !this->IsOn())
  {
    return nullptr;
  }
  // An application that removes its own observers may remove that of the exchange with them, even
  // in the middle of a frame.
  if (this->Observe())
  {
    this->Shared->AbandonFrame();
  }
  this->Shared->BeginFrame(
    renderer, { this->GetNumberOfRanks(), this->GetRank(), this->TileSize, this->BackOff });
  return this->Shared->IsShared() ? this->Shared : nullptr;
}

void vtkNBufferDepthExchange::EndFrame()
{
  if (this->IsOn())
  {
    this->Shared->EndFrame(
      this->Renderer, { this->GetNumberOfRanks(), this->GetRank(), this->TileSize, this->BackOff });
  }
}

void vtkNBufferDepthExchange::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.GetPointer() << "\n";
  os << indent << "ParallelRendering: " << this->ParallelRendering << "\n";
  os << indent << "TileSize: " << this->TileSize << "\n";
  os << indent << "BackOff: " << this->BackOff << "\n";
  os << indent << "NumberOfExchanges: " << this->GetNumberOfExchanges() << "\n";
  os << indent << "NumberOfBytes: " << this->GetNumberOfBytes() << "\n";
  os << indent << "ExchangeTime: " << this->GetExchangeTime() << "\n";
}
VTK_ABI_NAMESPACE_END
