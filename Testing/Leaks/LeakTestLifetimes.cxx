// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Nothing of the module outlives what it belongs to, and the module keeps nothing of the user's.
#include "GLObjects.h"
#include "LeakScene.h"
#include "Memory.h"
#include "OffscreenFixture.h"
#include "Stage.h"
#include "Tune.h"

#include "vtkNBufferCuller.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"

#include <array>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <tuple>

namespace
{
enum class Part
{
  Window,
  Renderer,
  Culler
};

using Order = std::array<Part, 3>;

/// A stage with the scene and the culler; each part can be dropped by itself.
class LeakStage : public TestScene::Stage
{
public:
  LeakStage(int backend, int multiSamples = 0)
  {
    this->Window = OffscreenFixture::NewWindow(96, 64, multiSamples);
    auto renderer = vtkSmartPointer<LeakScene::Renderer>::New();
    this->Renderers.emplace_back(renderer);
    this->Foreign = renderer->GetForeignProps();
    LeakScene::Build(renderer);
    this->Window->AddRenderer(renderer);
    this->Culler = vtkSmartPointer<vtkNBufferCuller>::New();
    this->Culler->SetBackend(backend);
    Tune(this->Culler, &vtkNBufferTuning::BackOff, false);
  }

  void AddCuller() { this->GetRenderer()->AddCuller(this->Culler); }
  bool HasRenderer() const { return !this->Renderers.empty(); }

  void Render(int frames)
  {
    for (int i = 0; i < frames; ++i)
    {
      LeakScene::SetCamera(this->GetRenderer(), ++this->Frame);
      this->Window->Render();
    }
    this->MakeCurrent();
  }

  void Drop(Part part)
  {
    switch (part)
    {
      case Part::Window:
        this->Window = nullptr;
        break;
      case Part::Renderer:
        if (this->Window)
        {
          this->Window->RemoveRenderer(this->GetRenderer());
        }
        this->Renderers.clear();
        break;
      case Part::Culler:
        if (this->HasRenderer())
        {
          this->GetRenderer()->RemoveCuller(this->Culler);
        }
        this->Culler = nullptr;
        break;
    }
  }

  int GetHidden() const { return this->Culler->GetNumberOfHiddenProps(); }

  std::shared_ptr<LeakScene::WeakObjects> Foreign;

private:
  int Frame = 0;
};

using Leaks = OffscreenFixture;

using LeaksByOrder = OffscreenFixtureWithParam<std::tuple<Order, int>>;

const Order Orders[] = { { Part::Window, Part::Renderer, Part::Culler },
  { Part::Window, Part::Culler, Part::Renderer }, { Part::Renderer, Part::Window, Part::Culler },
  { Part::Renderer, Part::Culler, Part::Window }, { Part::Culler, Part::Window, Part::Renderer },
  { Part::Culler, Part::Renderer, Part::Window } };
}

// Whichever of window, renderer and culler goes first takes its share with it, the others go on
// without it, and nothing of the module is left in the end.
TEST_P(LeaksByOrder, NothingOutlivesItsOwner)
{
  const auto& [order, backend] = this->GetParam();
  long long blocks = 0;
  // The first time makes what lasts as long as the process.
  for (int time = 0; time < 2; ++time)
  {
    blocks = Memory::GetModuleBlocks();
    LeakStage stage(backend);
    stage.AddCuller();
    stage.Render(4);
    EXPECT_GE(stage.GetHidden(), LeakScene::BoxesBehind - 10);
    const LeakScene::WeakObjects contents = LeakScene::GetContents(stage.GetRenderer());
    EXPECT_EQ(contents.GetNumberOfLiving(), contents.GetSize());
    EXPECT_GE(stage.Foreign->GetSize(), 1 + LeakScene::TranslucentBehind);
    const vtkWeakPointer<vtkNBufferCuller> culler = stage.Culler.Get();
    for (Part part : order)
    {
      stage.Drop(part);
      if (!stage.HasRenderer())
      {
        EXPECT_EQ(contents.GetNumberOfLiving(), 0) << "the culler keeps them";
      }
      if (!stage.Culler && !stage.HasRenderer())
      {
        EXPECT_EQ(culler, nullptr);
      }
      if (!culler)
      {
        EXPECT_EQ(stage.Foreign->GetNumberOfLiving(), 0);
      }
      if (stage.Window && stage.HasRenderer())
      {
        EXPECT_EQ(culler, nullptr);
        stage.Render(2);
      }
    }
    EXPECT_EQ(culler, nullptr);
    EXPECT_EQ(stage.Foreign->GetNumberOfLiving(), 0);
  }
  if (Memory::GetModuleBlocks() >= 0)
  {
    EXPECT_EQ(Memory::GetModuleBlocks(), blocks);
  }
}

INSTANTIATE_TEST_SUITE_P(All, LeaksByOrder,
  testing::Combine(testing::ValuesIn(Orders),
    testing::Values(int{ vtkNBufferCuller::CPU }, int{ vtkNBufferCuller::OpenGL })));

// The module's blocks are told from those of others, or the tests above and below mean nothing.
TEST_F(Leaks, BlocksOfTheModuleAreSeen)
{
  const long long before = Memory::GetModuleBlocks();
  if (before < 0)
  {
    GTEST_SKIP() << "The module's allocations cannot be told apart in this build.";
  }
  {
    const auto own = std::make_unique<int>(1);
    EXPECT_EQ(Memory::GetModuleBlocks(), before) << "a block of this program";
    vtkNew<vtkNBufferCuller> culler;
    EXPECT_GT(Memory::GetModuleBlocks(), before);
    EXPECT_GT(Memory::GetModuleBytes(), 0);
  }
  EXPECT_EQ(Memory::GetModuleBlocks(), before);
}

// A window that goes on drawing without the culler has the OpenGL objects that it had before,
// on either back-end and with multisampling. Its shader cache keeps the programs, as it does
// those of VTK's own mappers, and a second culler finds them there.
TEST_F(Leaks, GLObjectsGoWithTheCuller)
{
  for (int backend : { vtkNBufferCuller::CPU, vtkNBufferCuller::OpenGL })
  {
    for (int samples : { 0, 4 })
    {
      SCOPED_TRACE("back-end " + std::to_string(backend) + ", samples " + std::to_string(samples));
      LeakStage stage(backend, samples);
      stage.Render(3);
      GLObjects::Counts before = GLObjects::Count();
      stage.AddCuller();
      stage.Render(4);
      EXPECT_GE(stage.GetHidden(), LeakScene::BoxesBehind - 10);
      const GLObjects::Counts during = GLObjects::Count();
      if (backend == vtkNBufferCuller::OpenGL)
      {
        for (const char* kind : { "textures", "framebuffers", "buffers", "vertex arrays" })
        {
          EXPECT_GT(during.at(kind), before.at(kind)) << kind << " of the N-buffer";
        }
      }
      const bool onDevice = backend == vtkNBufferCuller::OpenGL || samples > 1;
      before["programs"] = during.at("programs");
      before["shaders"] = during.at("shaders");
      for (int time = 0; time < 2; ++time)
      {
        stage.Drop(Part::Culler);
        stage.Window->MakeCurrent();
        EXPECT_EQ(GLObjects::Count(), before) << "culler " << time << (onDevice ? "" : " (host)");
        stage.Render(1);
        EXPECT_EQ(GLObjects::Count(), before);
        stage.Culler = vtkSmartPointer<vtkNBufferCuller>::New();
        stage.Culler->SetBackend(backend);
        Tune(stage.Culler, &vtkNBufferTuning::BackOff, false);
        stage.AddCuller();
        stage.Render(4);
      }
    }
  }
}

// The other way to be rid of them: the window releases its resources, and then has as many objects
// as one that never had a culler.
TEST_F(Leaks, GLObjectsGoWithTheWindowsResources)
{
  const auto countReleased = [](bool culled)
  {
    LeakStage stage(vtkNBufferCuller::OpenGL, 4);
    if (culled)
    {
      stage.AddCuller();
    }
    stage.Render(4);
    EXPECT_TRUE(!culled || stage.GetHidden() > 0);
    stage.Window->ReleaseGraphicsResources(stage.Window);
    stage.Window->MakeCurrent();
    return GLObjects::Count();
  };
  const GLObjects::Counts control = countReleased(false);
  EXPECT_EQ(countReleased(true), control);
}

// Contexts come and go under one culler (Finalize(), then Render() again).
TEST_F(Leaks, ContextsComeAndGo)
{
  for (int backend : { vtkNBufferCuller::CPU, vtkNBufferCuller::OpenGL })
  {
    LeakStage stage(backend);
    stage.AddCuller();
    long long blocks = 0;
    long long bytes = 0;
    GLObjects::Counts objects;
    for (int time = 0; time < 8; ++time)
    {
      stage.Render(3);
      EXPECT_GE(stage.GetHidden(), LeakScene::BoxesBehind - 10);
      if (time == 1)
      {
        blocks = Memory::GetModuleBlocks();
        bytes = Memory::GetModuleBytes();
        objects = GLObjects::Count();
      }
      else if (time > 1)
      {
        EXPECT_EQ(Memory::GetModuleBlocks(), blocks);
        EXPECT_EQ(Memory::GetModuleBytes(), bytes);
        EXPECT_EQ(GLObjects::Count(), objects);
      }
      stage.Window->Finalize();
    }
  }
}

// One culler sees windows and renderers come and go: what it knew of them is bounded by those that
// are there, and by those that were there last.
TEST_F(Leaks, OneCullerManyWindows)
{
  vtkNew<vtkNBufferCuller> culler;
  culler->SetBackend(vtkNBufferCuller::OpenGL);
  Tune(culler, &vtkNBufferTuning::BackOff, false);
  long long blocks = 0;
  long long bytes = 0;
  for (int time = 0; time < 12; ++time)
  {
    {
      LeakStage stage(vtkNBufferCuller::OpenGL);
      stage.Culler = culler.Get();
      stage.AddCuller();
      stage.Render(4);
      EXPECT_GE(stage.GetHidden(), LeakScene::BoxesBehind - 10);
    }
    if (time == 3)
    {
      blocks = Memory::GetModuleBlocks();
      bytes = Memory::GetModuleBytes();
    }
  }
  EXPECT_EQ(Memory::GetModuleBlocks(), blocks);
  EXPECT_EQ(Memory::GetModuleBytes(), bytes);
}

// A renderer that outlives its window and moves to another one that happens to lie at the same
// address: nothing that belonged to the dead window may be used for it.
TEST_F(Leaks, ANewWindowAtTheAddressOfADeadOne)
{
  LeakStage stage(vtkNBufferCuller::OpenGL);
  stage.AddCuller();
  stage.Render(3);
  int sameAddress = 0;
  for (int time = 0; time < 8; ++time)
  {
    const vtkRenderWindow* const dead = stage.Window;
    stage.Window->RemoveRenderer(stage.GetRenderer());
    stage.Window = nullptr;
    stage.Window = OffscreenFixture::NewWindow(96, 64, 0);
    sameAddress += stage.Window == dead ? 1 : 0;
    stage.Window->AddRenderer(stage.GetRenderer());
    stage.Render(4);
    EXPECT_GE(stage.GetHidden(), LeakScene::BoxesBehind - 10);
    // A second renderer makes the culler forget what is dead.
    vtkNew<vtkRenderer> second;
    second->SetViewport(0.5, 0.0, 1.0, 1.0);
    LeakScene::Build(second);
    second->AddCuller(stage.Culler);
    stage.Window->AddRenderer(second);
    stage.Render(2);
    stage.Window->RemoveRenderer(second);
    stage.Render(4);
    EXPECT_GE(stage.GetHidden(), LeakScene::BoxesBehind - 10);
  }
  std::cout << sameAddress << " of 8 windows lay where the one before had lain\n";
}

// After every kind of frame the props are referenced by whoever referenced them without the
// culler; a prop that is removed after it is deleted at once.
TEST_F(Leaks, RemovedPropsAreDeletedAtOnce)
{
  LeakStage stage(vtkNBufferCuller::CPU);
  stage.AddCuller();
  const std::function<void()> frames[] = {
    [&] { stage.Render(2); },        // culled
    [&] { stage.Window->Render(); }, // still
    [&]
    {
      stage.Culler->EnabledOff();
      stage.Render(1);
      stage.Culler->EnabledOn();
    }, // aside
    [&]
    {
      // Aborted while it is drawn.
      vtkNew<vtkCallbackCommand> abort;
      abort->SetClientData(stage.Window);
      abort->SetCallback([](vtkObject*, unsigned long, void* window, void*)
        { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
      const unsigned long tag = stage.GetRenderer()->AddObserver(vtkCommand::StartEvent, abort);
      stage.Render(1);
      stage.GetRenderer()->RemoveObserver(tag);
      stage.Window->SetAbortRender(0);
    },
    [&]
    {
      stage.GetRenderer()->SetPass(nullptr);
      stage.Culler->FreezeOn();
      stage.Render(2);
      stage.Culler->FreezeOff();
    },
    [&]
    {
      stage.Window->SetSize(64, 80);
      stage.Render(2);
    },
  };
  for (const auto& frame : frames)
  {
    SCOPED_TRACE(&frame - frames);
    frame();
    vtkPropCollection* props = stage.GetRenderer()->GetViewProps();
    // The last is translucent, the first a wall that is drawn, the others are held back.
    for (int index : { props->GetNumberOfItems() - 1, 20 })
    {
      const vtkWeakPointer<vtkObject> prop = props->GetItemAsObject(index);
      ASSERT_NE(prop, nullptr);
      stage.GetRenderer()->RemoveViewProp(static_cast<vtkProp*>(prop.Get()));
      EXPECT_EQ(prop, nullptr) << "prop " << index;
    }
    stage.GetRenderer()->AddActor(LeakScene::MakeLeakBox(0.0, 0.0, -3.0, 0.5, 0));
    stage.GetRenderer()->AddActor(LeakScene::MakeLeakBox(0.0, 0.0, -4.0, 0.5, 2));
  }
}
