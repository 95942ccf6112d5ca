// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSharedDepth.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferLevels.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <iterator>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferSharedDepth::BeginFrame(vtkRenderer* renderer, const Layout& layout)
{
  if (this->HasBegun)
  {
    return;
  }
  this->HasBegun = true;
  this->FrameTime.Modified();
  this->HasShared = false;
  this->HasPolled = false;
  this->Joined = 0;
  this->AssumedStep = this->Step;
  this->Frame = Counts();
  this->Current = layout;
  this->Report = vtkNBufferRankReport();
  this->Plan.BeginFrame(!this->Agreed.empty() && this->Agreed.back() > 0.0F);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (int i = 0; i < 2; ++i)
  {
    this->Size[i] = vtkNBufferMath::GetBaseSize(std::max(size[i], 0), layout.TileSize);
  }
  if (vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  {
    const vtkNBufferViewKey last = std::exchange(this->View, vtkNBufferViewKey::Make(renderer));
    this->HasMoved = !this->View.HasSameView(last);
    const auto& toClip = this->View.WorldToClip;
    auto end = std::transform(toClip.begin(), toClip.end(), this->Report.View.begin(),
      [](double value) { return static_cast<float>(value); });
    std::copy(this->View.Viewport.begin(), this->View.Viewport.end(), end);
  }
}

void vtkNBufferSharedDepth::SetTrial(int hiddenByOwn, int hiddenByAll)
{
  this->Gain = std::max(hiddenByAll - hiddenByOwn, 0);
  this->Unhidden = std::max(this->Report.Candidates - hiddenByOwn, 0);
}

bool vtkNBufferSharedDepth::Poll(bool changed, bool pictureChanged)
{
  this->HasPolled = true;
  this->Report.Changed = changed || this->HasMoved || this->GetWanted() != this->Agreed ||
    (pictureChanged && this->HasGiven && this->GivesPicture);
  if (this->Plan.HasPoll())
  {
    const vtkNBufferClock clock;
    const float mine = this->Report.Changed ? -1.0F : 0.0F;
    float minimum = mine;
    const bool isDone = this->Reduce(&mine, &minimum, 1);
    this->Plan.LearnPoll(!isDone || minimum < 0.0F);
    this->Frame.Bytes += sizeof(float);
    this->Frame.Time += clock.GetMilliseconds();
  }
  return !this->IsShared();
}

std::vector<float> vtkNBufferSharedDepth::GetWanted() const
{
  return { static_cast<float>(this->Size[0]), static_cast<float>(this->Size[1]),
    static_cast<float>(this->Current.TileSize), this->Current.BackOff ? 1.0F : 0.0F };
}

bool vtkNBufferSharedDepth::Agree()
{
  if (!this->Agreed.empty())
  {
    return true;
  }
  const std::vector<float> wanted = this->GetWanted();
  std::vector<float> values = wanted;
  std::transform(
    wanted.begin(), wanted.end(), std::back_inserter(values), [](float value) { return -value; });
  std::vector<float> minima;
  if (!this->Send(values, minima))
  {
    return false;
  }
  if (minima != values)
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
  this->ExchangeTime = this->GetFrameTime();
  this->HasShared = false;
  // If a layout has changed, the loop runs once more: all ranks agree on the new layout and
  // exchange, or find that they do not agree and end here.
  while (this->Agree() && !this->Exchange(texels, number))
  {
    this->Agreed.clear();
  }
  this->Frame.Time += clock.GetMilliseconds();
}

bool vtkNBufferSharedDepth::Exchange(const float* texels, int number)
{
  const auto size =
    static_cast<std::size_t>(this->Agreed[0]) * static_cast<std::size_t>(this->Agreed[1]);
  vtkNBufferExchangeMessage message(size, this->Current.Ranks, this->Current.Rank);
  this->Report.Misfit = this->GetWanted() != this->Agreed;
  this->HasGiven = false;
  if (texels && !this->Report.Misfit)
  {
    std::copy(texels, texels + size, message.GetTexels());
    this->HasGiven = std::any_of(texels, texels + size,
      [](float texel) { return texel != vtkNBufferDepthConvention::Background; });
  }
  if (number == 0) // What the trial of this frame finds is reported in the next one.
  {
    this->Report.Gain = std::exchange(this->Gain, 0);
    this->Report.Unhidden = std::exchange(this->Unhidden, 0);
  }
  message.SetReport(this->Report);
  ++this->Frame.Exchanges;
  if (!this->Send(message.GetValues(), this->Minima))
  {
    return true;
  }
  const vtkNBufferRankReply reply = message.GetReply(this->Minima);
  if (reply.Misfit)
  {
    return false;
  }
  this->Plan.Learn(reply, number);
  this->HasShared = reply.SameView && reply.Step <= std::max(this->AssumedStep, this->Report.Step);
  this->Step = reply.Step;
  this->OtherCandidates = reply.Candidates - this->Report.Candidates;
  if (!reply.SameView)
  {
    this->WarnOnce("the ranks draw different views. Synchronize their cameras, as "
                   "vtkSynchronizedRenderers does; until then each rank culls by its own depth");
  }
  return true;
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
    this->GivesPicture = false;
    this->Join(texels);
  }
  if (!this->HasShared)
  {
    return false;
  }
  bool isNearer = false;
  const float* minima = this->Minima.data();
  const std::size_t size = static_cast<std::size_t>(this->Size[0]) * this->Size[1];
  for (std::size_t i = 0; i < size; ++i) // Compilers vectorise this loop.
  {
    isNearer |= minima[i] < texels[i];
    texels[i] = std::min(texels[i], minima[i]);
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
  if (source.Samples > 1 || source.Stored != vtkNBufferStoredDepth::Ordinary ||
    !source.Read(window, origin[0], origin[1], size[0], size[1], depth, why))
  {
    return false;
  }
  vtkNBufferLevels levels;
  levels.BuildBase(
    depth.data(), size[0], size[1], this->Current.TileSize, vtkNBufferExtremum::Maximum);
  const float* base = levels.GetLevelData(0);
  texels.assign(base, base + static_cast<std::size_t>(levels.GetWidth()) * levels.GetHeight());
  this->Report.Step = source.GetStep();
  return true;
}

void vtkNBufferSharedDepth::EndFrame(vtkRenderer* renderer, const Layout& layout)
{
  this->BeginFrame(renderer, layout);
  if (!this->HasPolled)
  {
    // Nobody knows whether this rank draws the same as in the last frame.
    this->Poll(this->HasGiven, true);
  }
  if (this->Joined < this->Plan.GetNumberOfExchanges())
  {
    this->GivesPicture = true;
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

bool vtkNBufferSharedDepth::Send(const std::vector<float>& values, std::vector<float>& minima)
{
  minima.resize(values.size());
  this->Frame.Bytes += static_cast<long long>(values.size() * sizeof(float));
  const bool isDone = this->Reduce(values.data(), minima.data(), static_cast<int>(values.size()));
  if (!isDone)
  {
    this->WarnOnce("the exchange failed. Each rank culls by its own depth");
  }
  return isDone;
}

void vtkNBufferSharedDepth::WarnOnce(const std::string& text)
{
  if (this->Warnings.insert(text).second)
  {
    vtkGenericWarningMacro(<< "vtkNBufferDepthExchange: " << text << ".");
  }
}
VTK_ABI_NAMESPACE_END
