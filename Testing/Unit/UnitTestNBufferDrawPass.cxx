// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDrawPass.h"
#include "vtkNBufferPropertyKeys.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
int CountPasses(vtkActor* actor)
{
  return actor->GetPropertyKeys()
    ? vtkOpenGLRenderPass::RenderPasses()->Length(actor->GetPropertyKeys())
    : 0;
}

TEST(NBufferDrawPass, OneForEachWindow)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindow> other;
  const auto pass = vtkNBufferDrawPass::Get(window);
  EXPECT_EQ(pass, vtkNBufferDrawPass::Get(window));
  EXPECT_NE(pass, vtkNBufferDrawPass::Get(other));
}

// Two renderers have the same actor, so that the pass is attached to it twice.
TEST(NBufferDrawPass, StaysUntilItIsDetachedAsOftenAsAttached)
{
  vtkNew<vtkRenderWindow> window;
  const auto pass = vtkNBufferDrawPass::Get(window);
  vtkNew<vtkActor> actor;
  vtkNew<vtkPolyDataMapper> mapper;
  actor->SetMapper(mapper);
  pass->Attach(actor);
  pass->Attach(actor);
  EXPECT_EQ(CountPasses(actor), 1);
  EXPECT_TRUE(pass->IsUsedBy(mapper));
  pass->Detach(actor);
  EXPECT_EQ(CountPasses(actor), 1);
  pass->Detach(actor);
  EXPECT_EQ(CountPasses(actor), 0);
  EXPECT_FALSE(pass->IsUsedBy(mapper));
}

// Two renderers have the same actor, and one of them finds first that it shows another mapper.
TEST(NBufferDrawPass, MovesToAnotherMapper)
{
  vtkNew<vtkRenderWindow> window;
  const auto pass = vtkNBufferDrawPass::Get(window);
  vtkNew<vtkActor> actor;
  vtkNew<vtkPolyDataMapper> mappers[2];
  actor->SetMapper(mappers[0]);
  pass->Attach(actor);
  pass->Attach(actor);
  EXPECT_FALSE(pass->HasOtherMapper(actor));
  actor->SetMapper(mappers[1]);
  EXPECT_TRUE(pass->HasOtherMapper(actor));
  pass->Detach(actor);
  pass->Attach(actor);
  EXPECT_FALSE(pass->HasOtherMapper(actor));
  EXPECT_EQ(CountPasses(actor), 1);
  EXPECT_FALSE(pass->IsUsedBy(mappers[0]));
  EXPECT_TRUE(pass->IsUsedBy(mappers[1]));
  pass->Detach(actor);
  EXPECT_EQ(CountPasses(actor), 1);
  pass->Detach(actor);
  EXPECT_EQ(CountPasses(actor), 0);
}

// Hazard: actors that have used a mapper in several ways leave the renderer's list. Without the
// pass the mapper would make its shaders anew when they come back.
TEST(NBufferDrawPass, StaysAttachedWhereTheMapperIsKeptWhole)
{
  vtkNew<vtkRenderWindow> window;
  const auto pass = vtkNBufferDrawPass::Get(window);
  vtkNew<vtkActor> actor;
  vtkNew<vtkPolyDataMapper> mapper;
  actor->SetMapper(mapper);
  pass->Attach(actor);
  vtkNBufferDrawPass::KeepWhole(mapper);
  for (int i = 0; i < 3; ++i)
  {
    pass->Detach(actor);
    EXPECT_EQ(CountPasses(actor), 1);
    pass->Attach(actor);
    EXPECT_EQ(CountPasses(actor), 1);
  }
  EXPECT_TRUE(pass->IsUsedBy(mapper));
}

// Hazard: the application replaces the property keys of a divided actor, which is drawn whole from
// then on, once for each of its lists.
TEST(NBufferDrawPass, IsAttachedAgainToNewKeys)
{
  vtkNew<vtkRenderWindow> window;
  const auto pass = vtkNBufferDrawPass::Get(window);
  vtkNew<vtkActor> actor;
  pass->Attach(actor);
  EXPECT_FALSE(pass->AttachAgain(actor));
  actor->SetPropertyKeys(nullptr);
  EXPECT_TRUE(pass->AttachAgain(actor));
  EXPECT_FALSE(pass->AttachAgain(actor));
  EXPECT_EQ(CountPasses(actor), 1);
  pass->Detach(actor);
  EXPECT_EQ(CountPasses(actor), 0);
}

// Hazard: an actor begins to share a mapper in a frame in which nothing looks for large props.
TEST(NBufferDrawPass, FollowsTheMapper)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkActor> actors[3];
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkPolyDataMapper> other;
  actors[0]->SetMapper(mapper);
  actors[1]->SetMapper(mapper);
  actors[2]->SetMapper(other);
  vtkProp* props[] = { actors[0], actors[1], actors[2] };
  vtkNBufferDrawPass::Follow(window, props, 3);
  EXPECT_EQ(CountPasses(actors[0]), 0) << "no actor has it";
  const auto pass = vtkNBufferDrawPass::Get(window);
  pass->Attach(actors[0]);
  vtkNBufferDrawPass::Follow(window, props, 3);
  vtkNBufferDrawPass::Follow(window, props, 3);
  EXPECT_EQ(CountPasses(actors[0]), 1);
  EXPECT_EQ(CountPasses(actors[1]), 1);
  EXPECT_EQ(CountPasses(actors[2]), 0);
  for (const int i : { 0, 1 })
  {
    if (i > 0)
    {
      pass->Attach(actors[i]);
      EXPECT_EQ(CountPasses(actors[i]), 1);
    }
    pass->Detach(actors[i]);
    EXPECT_EQ(CountPasses(actors[i]), 0);
  }
}

// Hazard: an actor that has begun to share a mapper is never attached, because the culler that
// looks for large props has gone.
TEST(NBufferDrawPass, GoesWithTheLastActorOfItsMapper)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkActor> actors[3];
  vtkNew<vtkPolyDataMapper> mapper;
  vtkProp* props[3];
  for (int i = 0; i < 3; ++i)
  {
    actors[i]->SetMapper(mapper);
    props[i] = actors[i];
  }
  const auto pass = vtkNBufferDrawPass::Get(window);
  pass->Attach(actors[0]);
  pass->Attach(actors[1]);
  vtkNBufferDrawPass::Follow(window, props, 3);
  pass->Detach(actors[0]);
  EXPECT_EQ(CountPasses(actors[0]), 0);
  EXPECT_EQ(CountPasses(actors[2]), 1) << "the mapper is still divided";
  pass->Detach(actors[1]);
  EXPECT_EQ(CountPasses(actors[1]), 0);
  EXPECT_EQ(CountPasses(actors[2]), 0);
  EXPECT_FALSE(pass->IsUsedBy(mapper));
}

// Hazard: VTK counts the references of a pass otherwise in copies of keys, so that the pass would
// be deleted while it is in use.
TEST(NBufferPropertyKeys, CopiesReferenceAPassOnce)
{
  vtkNew<vtkNBufferDrawPass> passes[3];
  vtkNew<vtkInformation> keys;
  vtkNBufferPropertyKeys::AddPass(keys, passes[0]);
  vtkNBufferPropertyKeys::AddPass(keys, passes[2]);
  vtkNew<vtkInformation> copy;
  copy->CopyEntry(keys, vtkOpenGLRenderPass::RenderPasses());
  const auto expectPasses = [&copy](const std::vector<vtkObjectBase*>& expected)
  {
    ASSERT_EQ(vtkNBufferPropertyKeys::CountPasses(copy), static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_EQ(vtkOpenGLRenderPass::RenderPasses()->Get(copy, static_cast<int>(i)), expected[i]);
    }
  };
  for (const int place : { 0, 1, 2, 100 })
  {
    const int others[2] = { passes[0]->GetReferenceCount(), passes[2]->GetReferenceCount() };
    vtkNBufferPropertyKeys::AddPassToCopy(copy, passes[1], place);
    vtkNBufferPropertyKeys::AddPassToCopy(copy, passes[1], 0);
    EXPECT_EQ(passes[1]->GetReferenceCount(), 2);
    std::vector<vtkObjectBase*> expected = { passes[0], passes[2] };
    expected.insert(expected.begin() + std::min(place, 2), passes[1]);
    expectPasses(expected);
    vtkNBufferPropertyKeys::RemovePassFromCopy(copy, passes[1]);
    vtkNBufferPropertyKeys::RemovePassFromCopy(copy, passes[1]);
    EXPECT_EQ(passes[1]->GetReferenceCount(), 1);
    expectPasses({ passes[0], passes[2] });
    EXPECT_EQ(passes[0]->GetReferenceCount(), others[0]);
    EXPECT_EQ(passes[2]->GetReferenceCount(), others[1]);
  }
  vtkNBufferPropertyKeys::RemovePass(keys, passes[0]);
  vtkNBufferPropertyKeys::RemovePass(keys, passes[2]);
}

// The pass is never detached from an actor that is deleted. A new actor may be made at its address
// (the allocator uses an address again soon), and must get the pass.
TEST(NBufferDrawPass, ForgetsActorsThatWereDeleted)
{
  vtkNew<vtkRenderWindow> window;
  const auto pass = vtkNBufferDrawPass::Get(window);
  for (int i = 0; i < 100; ++i)
  {
    vtkNew<vtkActor> actor;
    pass->Attach(actor);
    ASSERT_EQ(CountPasses(actor), 1);
  }
}
}
