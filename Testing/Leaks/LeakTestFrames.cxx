// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Ten thousand frames of props, renderers and cullers that come and go, of windows that change size
// and samples, on both back-ends: memory and OpenGL objects stay as they are.
//
// The frames repeat in cycles that end as they began, so that the same point of each cycle can be
// compared. VTKNBUFFER_LEAK_FRAMES in the environment sets another number of frames.
#include "GLObjects.h"
#include "LeakScene.h"
#include "Memory.h"
#include "OffscreenFixture.h"
#include "Tune.h"

#include "vtkNBufferCuller.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace
{
constexpr int FramesPerCycle = 250;
constexpr int WarmUpCycles = 2;

int GetNumberOfCycles()
{
  const char* frames = std::getenv("VTKNBUFFER_LEAK_FRAMES");
  return std::max((frames ? std::atoi(frames) : 10000) / FramesPerCycle, 2);
}

/// What is compared from cycle to cycle.
struct Sample
{
  long long Heap = 0;
  long long ModuleBlocks = 0;
  long long ModuleBytes = 0;
  GLObjects::Counts Objects;
};

/// Props, renderers and cullers that come and go, with the culler or (the control) without it.
class Traffic
{
public:
  explicit Traffic(bool culled)
    : Window(OffscreenFixture::NewWindow(Sizes[0][0], Sizes[0][1]))
    , Culled(culled)
  {
    LeakScene::Build(this->Renderer);
    this->Window->AddRenderer(this->Renderer);
    this->ReplaceCuller();
  }

  void RunCycle()
  {
    std::minstd_rand random(1);
    for (int frame = 0; frame < FramesPerCycle; ++frame)
    {
      this->Change(frame, random);
      LeakScene::SetCamera(this->Renderer, frame);
      this->Window->Render();
      ++this->Frames;
      this->FramesWithHidden += this->Culler && this->Culler->GetNumberOfHiddenProps() > 0 ? 1 : 0;
    }
  }

  Sample Take()
  {
    this->Window->MakeCurrent();
    Sample sample;
    sample.Objects = GLObjects::Count();
    sample.ModuleBlocks = Memory::GetModuleBlocks();
    sample.ModuleBytes = Memory::GetModuleBytes();
    sample.Heap = Memory::GetHeapBytes();
    return sample;
  }

  int Frames = 0;
  int FramesWithHidden = 0;
  int Removed = 0;
  int Undead = 0; ///< Removed props that were not deleted at once.

private:
  static constexpr int Sizes[4][2] = { { 96, 64 }, { 120, 80 }, { 33, 77 }, { 64, 48 } };

  void Change(int frame, std::minstd_rand& random)
  {
    if (frame % 3 == 0)
    {
      this->ReplaceProps(random);
    }
    if (frame % 25 == 0 && this->Culler)
    {
      this->Culler->SetBackend(frame / 25 % 2 ? vtkNBufferCuller::OpenGL : vtkNBufferCuller::CPU);
      Tune(this->Culler, &vtkNBufferTuning::BaseFactor, 1 << frame / 25 % 4);
      Tune(this->Culler, &vtkNBufferTuning::TestPixels, frame / 25 % 3 > 0);
      this->Culler->SetEnabled(frame != 175);
    }
    if (frame % 40 == 0)
    {
      const int* size = Sizes[frame / 40 % 4];
      this->Window->SetSize(size[0], size[1]);
    }
    if (frame % 100 == 60 || frame % 100 == 80)
    {
      this->Window->SetMultiSamples(frame % 100 == 60 ? 4 : 0);
    }
    if (frame % 50 == 10)
    {
      this->Second = vtkSmartPointer<vtkRenderer>::New();
      this->Second->SetViewport(0.5, 0.0, 1.0, 1.0);
      LeakScene::Build(this->Second);
      if (this->Culler)
      {
        this->Second->AddCuller(this->Culler);
      }
      this->Window->AddRenderer(this->Second);
    }
    if (frame % 50 == 15)
    {
      this->Window->RemoveRenderer(this->Second);
      this->Second = nullptr;
    }
    if (frame == 130)
    {
      this->ReplaceCuller();
    }
  }

  void ReplaceProps(std::minstd_rand& random)
  {
    vtkPropCollection* props = this->Renderer->GetViewProps();
    for (int i = 0; i < 4; ++i)
    {
      // Not the wall, which comes first.
      const int count = props->GetNumberOfItems();
      const vtkWeakPointer<vtkObject> prop =
        props->GetItemAsObject(1 + static_cast<int>(random() % (count - 1)));
      this->Renderer->RemoveViewProp(static_cast<vtkProp*>(prop.Get()));
      ++this->Removed;
      this->Undead += prop ? 1 : 0;
      const auto uniform = [&random](double a, double b)
      { return a + (b - a) * static_cast<double>(random() % 1000) / 1000.0; };
      const double x = uniform(-4.0, 4.0);
      const double y = uniform(-2.0, 2.0);
      this->Renderer->AddActor(LeakScene::MakeLeakBox(x, y, uniform(-9.0, -2.0), 0.5, i % 3));
    }
  }

  void ReplaceCuller()
  {
    if (this->Culler)
    {
      this->Renderer->RemoveCuller(this->Culler);
    }
    if (this->Culled)
    {
      this->Culler = vtkSmartPointer<vtkNBufferCuller>::New();
      Tune(this->Culler, &vtkNBufferTuning::BackOff, false);
      Tune(this->Culler, &vtkNBufferTuning::RoundSize, 12);
      this->Renderer->AddCuller(this->Culler);
    }
  }

  vtkSmartPointer<vtkOpenGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderer> Second;
  vtkSmartPointer<vtkNBufferCuller> Culler;
  bool Culled;
};

/// llvmpipe's threads free what they drew with when they come to it, megabytes of it; with none the
/// heap is the same to some kilobytes after each cycle. Set before any context exists.
const bool DrawsWithoutThreads = setenv("LP_NUM_THREADS", "0", 0) == 0;

/// Growth of the heap that passes, in bytes: what VTK and Mesa were seen to vary by from cycle to
/// cycle, with the culler or without (20 kB), with some room. malloc's smallest block has 32 bytes:
/// one lost in every fifth of 10,000 frames is found.
constexpr long long HeapTolerance = 64 * 1024;

/// What VTK 9.1 loses on X in each cycle, in bytes, with the culler or without. The control shows
/// it in some runs and in others not: 4 kB or 22 kB in a quarter of the cycles.
constexpr long long LostOnX = 2000;

using LeaksOverManyFrames = OffscreenFixture;

/// What each cycle ended with, once the first ones have allocated what lasts.
std::vector<Sample> RunCycles(Traffic& traffic, int cycles)
{
  for (int i = 0; i < WarmUpCycles; ++i)
  {
    traffic.RunCycle();
  }
  std::vector<Sample> samples = { traffic.Take() };
  for (int i = 0; i < cycles; ++i)
  {
    traffic.RunCycle();
    samples.push_back(traffic.Take());
  }
  return samples;
}

long long GetHeapGrowth(const std::vector<Sample>& samples)
{
  return samples.back().Heap - samples.front().Heap;
}
}

TEST_F(LeaksOverManyFrames, MemoryAndGLObjectsStayFlat)
{
  ASSERT_TRUE(DrawsWithoutThreads);
  const int cycles = GetNumberOfCycles();
  // What VTK and the driver lose by themselves is not ours; a quarter of the frames tells.
  const int controlCycles = std::max(cycles / 4, 2);
  std::vector<Sample> without;
  {
    Traffic control(false);
    without = RunCycles(control, controlCycles);
  }
  Traffic traffic(true);
  const std::vector<Sample> with = RunCycles(traffic, cycles);
  std::cout << traffic.Frames << " frames, " << traffic.FramesWithHidden << " with hidden props, "
            << traffic.Removed << " props removed; the heap grew by " << GetHeapGrowth(with)
            << " bytes (without the culler: " << GetHeapGrowth(without)
            << " in a quarter of that); "
            << "the module holds " << with.back().ModuleBytes << " bytes in "
            << with.back().ModuleBlocks << " blocks\n";

  EXPECT_GE(traffic.FramesWithHidden, traffic.Frames * 3 / 4) << "the culler is to be at work";
  EXPECT_EQ(traffic.Undead, 0) << "removed props that something kept alive";
  for (const Sample& sample : with)
  {
    SCOPED_TRACE("after cycle " + std::to_string(WarmUpCycles + (&sample - with.data())));
    EXPECT_EQ(sample.Objects, with.front().Objects);
    EXPECT_EQ(sample.ModuleBlocks, with.front().ModuleBlocks);
    EXPECT_EQ(sample.ModuleBytes, with.front().ModuleBytes);
  }
  for (const Sample& sample : without)
  {
    EXPECT_EQ(sample.Objects, without.front().Objects) << "VTK's own";
  }
  if (with.front().Heap >= 0)
  {
    const bool isOnX = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0) &&
      vtkNew<vtkRenderWindow>()->IsA("vtkXOpenGLRenderWindow");
    const long long expected =
      std::max(std::max(GetHeapGrowth(without), 0LL) * cycles / controlCycles,
        isOnX ? cycles * LostOnX : 0LL);
    EXPECT_LE(GetHeapGrowth(with), expected + HeapTolerance);
  }
}
