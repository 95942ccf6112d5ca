// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a change of one of many observed objects is known, whatever else observes the object.
#include "vtkNBufferObservedObjects.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

// Hazard: after its first event an object changes a second time.
TEST(NBufferObservedObjects, FirstChangeIsSeenAndEndsTheObservation)
{
  vtkNBufferObservedObjects objects;
  vtkNew<vtkProperty> property;
  vtkNew<vtkPoints> points;
  EXPECT_TRUE(objects.Add(property) && objects.Add(points) && objects.Add(property));
  EXPECT_EQ(objects.GetSize(), 2u);
  EXPECT_FALSE(objects.TakeChange());

  property->SetOpacity(0.5);
  EXPECT_TRUE(objects.TakeChange());
  EXPECT_FALSE(objects.TakeChange());
  EXPECT_FALSE(objects.TakeLoss());
  EXPECT_EQ(objects.GetSize(), 1u);
  EXPECT_FALSE(property->HasObserver(vtkCommand::ModifiedEvent));
  property->SetOpacity(0.4);
  EXPECT_FALSE(objects.TakeChange()) << "the object is not observed any more";

  EXPECT_TRUE(objects.Add(property));
  property->SetOpacity(0.3);
  EXPECT_TRUE(objects.TakeChange());
}

// Hazard: another observer aborts the event before it reaches the module's observer.
TEST(NBufferObservedObjects, NoOtherObserverHidesAChange)
{
  vtkNew<vtkProperty> property;
  const auto addObserver = [&property]()
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback([](vtkObject*, unsigned long, void* data, void*)
      { static_cast<vtkCallbackCommand*>(data)->AbortFlagOn(); });
    command->SetClientData(command);
    property->AddObserver(vtkCommand::ModifiedEvent, command, VTK_FLOAT_MAX);
  };
  vtkNBufferObservedObjects objects;
  addObserver();
  objects.Add(property);
  addObserver();
  property->SetOpacity(0.5);
  EXPECT_TRUE(objects.TakeChange());
}

// Hazard: an application removes all observers of an object, and changes it afterwards.
TEST(NBufferObservedObjects, RemovedObserversAreALoss)
{
  vtkNBufferObservedObjects objects;
  vtkNew<vtkProperty> property;
  for (const bool byEvent : { false, true })
  {
    objects.Add(property);
    byEvent ? property->RemoveObservers(vtkCommand::ModifiedEvent) : property->RemoveAllObservers();
    EXPECT_TRUE(objects.TakeLoss());
    EXPECT_FALSE(objects.TakeLoss());
    EXPECT_EQ(objects.GetSize(), 0u);
  }
}

// Hazard: a deleted object is accessed, or another object at its address is treated as the observed
// one.
TEST(NBufferObservedObjects, DeletedObjectsAreForgotten)
{
  vtkNBufferObservedObjects objects;
  auto property = vtkSmartPointer<vtkProperty>::New();
  objects.Add(property);
  property = nullptr;
  EXPECT_EQ(objects.GetSize(), 0u);
  // VTK 9.1 destroys observers before their object is without references.
  const bool isLost = objects.TakeLoss();
  EXPECT_EQ(objects.TakeChange(), !isLost);
}

// Hazard: an event reaches an observer whose owner is deleted.
TEST(NBufferObservedObjects, ObserversGoWithTheirOwner)
{
  vtkNew<vtkProperty> property;
  {
    vtkNBufferObservedObjects objects;
    objects.Add(property);
    EXPECT_TRUE(property->HasObserver(vtkCommand::ModifiedEvent));
  }
  EXPECT_FALSE(property->HasObserver(vtkCommand::ModifiedEvent));
  property->SetOpacity(0.5);
}

// Hazard: objects are modified in several threads at once.
TEST(NBufferObservedObjects, ChangesInOtherThreadsAreSeen)
{
  constexpr int count = 1000;
  vtkNBufferObservedObjects objects;
  std::vector<vtkSmartPointer<vtkProperty>> properties(4 * count);
  for (auto& property : properties)
  {
    property = vtkSmartPointer<vtkProperty>::New();
    objects.Add(property);
  }
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
  {
    threads.emplace_back(
      [&properties, t]()
      {
        for (int i = 0; i < count; ++i)
        {
          properties[t * count + i]->Modified();
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_TRUE(objects.TakeChange());
  EXPECT_FALSE(objects.TakeLoss());
  EXPECT_EQ(objects.GetSize(), 0u);
}

// Hazard: observers use up the memory.
TEST(NBufferObservedObjects, TheirNumberIsLimited)
{
  vtkNBufferObservedObjects objects;
  std::vector<vtkSmartPointer<vtkObject>> many(vtkNBufferObservedObjects::MaximumSize);
  for (auto& object : many)
  {
    object = vtkSmartPointer<vtkObject>::New();
    ASSERT_TRUE(objects.Add(object));
  }
  vtkNew<vtkProperty> oneMore;
  EXPECT_FALSE(objects.Add(oneMore));
  EXPECT_TRUE(objects.Add(many.front())) << "which is observed already";
  many.pop_back();
  EXPECT_TRUE(objects.Add(oneMore));
}
