// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSharedDepth.h"

#include "vtkNBufferCamera.h"
#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferLevels.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// What the ranks have in common of a view. These are the numbers that are sent from rank to rank,
/// and not matrices, because processors of different kinds may round these differently.
std::vector<double> GetSharedView(vtkRenderer* renderer)
{
  std::vector<double> view(26);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->GetPosition(&view[0]);
  camera->GetFocalPoint(&view[3]);
  camera->GetViewUp(&view[6]);
  camera->GetClippingRange(&view[9]);
  camera->GetWindowCenter(&view[11]);
  view[13] = camera->GetViewAngle();
  view[14] = camera->GetParallelScale();
  view[15] = camera->GetParallelProjection();
  view[16] = camera->GetLeftEye();
  renderer->GetViewport(&view[17]);
  int* const size = renderer->GetVTKWindow()->GetSize();
  std::copy(size, size + 2, &view[21]);
  camera->GetViewShear(&view[23]);
  return view;
}
}

void vtkNBufferSharedDepth::BeginFrame(vtkRenderer* renderer, const Layout& layout)
{
  if (this->HasBegun)
  {
    return;
  }
  this->HasBegun = true;
  this->HasShared = false;
  this->Joined = 0;
  this->AssumedStep = this->Step;
  this->Frame = Counts();
  this->Current = layout;
  this->Report = vtkNBufferRankReport();
  this->Plan.BeginFrame(GetSharedView(renderer), layout.BackOff);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (int i = 0; i < 2; ++i)
  {
    this->Size[i] = vtkNBufferMath::GetBaseSize(std::max(size[i], 0), layout.TileSize);
  }
  if (this->IsShared() && vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  {
    const vtkNBufferViewKey key = vtkNBufferViewKey::Make(renderer);
    auto end = std::transform(key.WorldToClip.begin(), key.WorldToClip.end(),
      this->Report.View.begin(), [](double value) { return static_cast<float>(value); });
    std::copy(key.Viewport.begin(), key.Viewport.end(), end);
  }
}

bool vtkNBufferSharedDepth::Agree()
{
  const std::vector<float> wanted = { static_cast<float>(this->Size[0]),
    static_cast<float>(this->Size[1]), static_cast<float>(this->Current.TileSize),
    this->Current.BackOff ? 1.0F : 0.0F };
  if (wanted == this->Agreed)
  {
    return true;
  }
  // All ranks come here: they have changed their sizes together, or have not agreed before.
  this->Agreed.clear();
  std::vector<float> values = wanted;
  std::transform(
    wanted.begin(), wanted.end(), std::back_inserter(values), [](float value) { return -value; });
  std::vector<float> minima(values.size());
  if (!this->Reduce(values.data(), minima.data(), static_cast<int>(values.size())))
  {
    this->WarnOnce("the exchange failed. Each rank culls by its own depth");
    return false;
  }
  if (!std::equal(wanted.begin(), wanted.end(), minima.begin() + wanted.size(),
        [](float value, float negative) { return value == -negative; }) ||
    !std::equal(wanted.begin(), wanted.end(), minima.begin()))
  {
    this->WarnOnce("the ranks have renderers of different sizes, or exchanges with different "
                   "settings. Make them the same on all ranks; until then each rank culls by its "
                   "own depth");
    return false;
  }
  this->Agreed = wanted;
  return true;
}

void vtkNBufferSharedDepth::Join(const float* texels)
{
  const vtkNBufferClock clock;
  const int number = this->Joined++;
  if (!this->Agree())
  {
    this->Frame.Time += clock.GetMilliseconds();
    return;
  }
  vtkNBufferExchangeMessage message(static_cast<std::size_t>(this->Size[0]) * this->Size[1],
    this->Current.Ranks, this->Current.Rank);
  if (texels)
  {
    std::copy(texels, texels + static_cast<std::size_t>(this->Size[0]) * this->Size[1],
      message.GetTexels());
  }
  this->Report.Gain = number == 0 ? std::exchange(this->Gain, 0) : 0;
  message.SetReport(this->Report);
  const std::vector<float>& values = message.GetValues();
  this->Minima.resize(values.size());
  this->HasShared = false;
  if (this->Reduce(values.data(), this->Minima.data(), static_cast<int>(values.size())))
  {
    const vtkNBufferRankReply reply = message.GetReply(this->Minima);
    this->Plan.Learn(reply, number);
    this->HasShared =
      reply.SameView && reply.Step <= std::max(this->AssumedStep, this->Report.Step);
    this->Step = reply.Step;
    this->OtherCandidates = reply.Candidates - this->Report.Candidates;
    if (!reply.SameView)
    {
      this->WarnOnce("the ranks draw different views. Synchronize their cameras, as "
                     "vtkSynchronizedRenderers does; until then each rank culls by its own depth");
    }
  }
  else
  {
    this->WarnOnce("the exchange failed. Each rank culls by its own depth");
  }
  ++this->Frame.Exchanges;
  this->Frame.Bytes += static_cast<long long>(values.size() * sizeof(float));
  this->Frame.Time += clock.GetMilliseconds();
}

bool vtkNBufferSharedDepth::Merge(vtkNBufferLevels& base)
{
  if (base.GetWidth() != this->Size[0] || base.GetHeight() != this->Size[1])
  {
    return false;
  }
  float* texels = base.GetLevelData(0);
  if (this->Joined < this->Plan.GetNumberOfExchanges())
  {
    this->Join(texels);
  }
  bool isNearer = false;
  const std::size_t size = static_cast<std::size_t>(this->Size[0]) * this->Size[1];
  for (std::size_t i = 0; i < size && this->HasShared; ++i)
  {
    isNearer = isNearer || this->Minima[i] < texels[i];
    texels[i] = std::min(texels[i], this->Minima[i]);
  }
  return isNearer;
}

bool vtkNBufferSharedDepth::ReadDepth(vtkRenderer* renderer, std::vector<float>& texels)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::string why;
  vtkNBufferDepthSource source;
  if (!window || window->GetContextCreationTime() == 0 || !vtkNBufferGL::CheckVersion(why) ||
    !vtkNBufferGL::KeepsColorsWhenRead() || !source.Inspect(window, why))
  {
    return false;
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  std::vector<float> depth;
  if (source.Samples > 1 ||
    !source.Read(window, origin[0], origin[1], size[0], size[1], depth, why))
  {
    return false;
  }
  vtkNBufferLevels levels;
  levels.BuildBase(
    depth.data(), size[0], size[1], this->Current.TileSize, vtkNBufferDepthConvention::Farthest);
  const float* base = levels.GetLevelData(0);
  texels.assign(base, base + static_cast<std::size_t>(levels.GetWidth()) * levels.GetHeight());
  this->Report.Step = source.GetStep();
  return true;
}

void vtkNBufferSharedDepth::EndFrame(vtkRenderer* renderer, const Layout& layout)
{
  this->BeginFrame(renderer, layout);
  if (this->Joined < this->Plan.GetNumberOfExchanges())
  {
    std::vector<float> texels;
    const bool hasDepth = this->ReadDepth(renderer, texels);
    while (this->Joined < this->Plan.GetNumberOfExchanges())
    {
      this->Join(hasDepth ? texels.data() : nullptr);
    }
  }
  this->HasBegun = false;
  this->LastCounts = this->Frame;
}

void vtkNBufferSharedDepth::WarnOnce(const char* text)
{
  if (!this->HasWarned)
  {
    vtkGenericWarningMacro(<< "vtkNBufferDepthExchange: " << text << ".");
  }
  this->HasWarned = true;
}
VTK_ABI_NAMESPACE_END
