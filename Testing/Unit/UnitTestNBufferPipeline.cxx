// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether an actor's pipeline says that something changed, without being run.
#include "vtkNBufferCandidate.h"
#include "vtkNBufferPipeline.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataSetMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace
{
/// A sphere, moved by a filter, shown by an actor with a transform of its user's.
struct PipedActor
{
  PipedActor()
  {
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetTransform(this->Transform);
    this->Mapper->SetInputConnection(this->Filter->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
    this->Actor->SetUserTransform(this->UserTransform);
    this->UserTransform->Concatenate(this->Outer);
    this->Actor->GetBounds();
  }

  vtkInformation* GetRequest() { return this->Mapper->GetInputInformation(0, 0); }

  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkTransform> Transform;
  vtkNew<vtkTransformFilter> Filter;
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkTransform> UserTransform;
  vtkNew<vtkTransform> Outer;
  vtkNew<vtkActor> Actor;
};

struct Change
{
  std::string Name;
  std::function<void(PipedActor&)> Apply;
};

void PrintTo(const Change& change, std::ostream* os)
{
  *os << change.Name;
}

class NBufferPipeline : public testing::TestWithParam<Change>
{
};
}

// Hazard: a change upstream leaves the times of actor, mapper and data untouched.
TEST_P(NBufferPipeline, ChangesAreSeenBeforeTheyAreRun)
{
  PipedActor piped;
  vtkNBufferPipeline pipeline;
  ASSERT_TRUE(pipeline.Take(piped.Actor));
  EXPECT_FALSE(pipeline.HasChanged());
  this->GetParam().Apply(piped);
  EXPECT_TRUE(pipeline.HasChanged());
  EXPECT_TRUE(pipeline.HasChanged()) << "asking is no answer";
}

INSTANTIATE_TEST_SUITE_P(Each, NBufferPipeline,
  testing::Values(Change{ "Source", [](PipedActor& piped) { piped.Source->SetRadius(3.0); } },
    Change{
      "FiltersTransform", [](PipedActor& piped) { piped.Transform->Translate(1.0, 0.0, 0.0); } },
    Change{ "SourceRunByAnother",
      [](PipedActor& piped)
      {
        piped.Source->SetRadius(3.0);
        piped.Filter->Update();
      } },
    Change{ "Connection",
      [](PipedActor& piped) { piped.Mapper->SetInputConnection(piped.Source->GetOutputPort()); } },
    Change{ "FiltersConnection",
      [](PipedActor& piped)
      {
        vtkNew<vtkSphereSource> other;
        piped.Filter->SetInputConnection(other->GetOutputPort());
      } },
    Change{ "Data", [](PipedActor& piped)
      { vtkPolyData::SafeDownCast(piped.Mapper->GetInput())->GetPoints()->Modified(); } },
    Change{ "ReleasedData", [](PipedActor& piped) { piped.Mapper->GetInput()->ReleaseData(); } },
    Change{ "TimeStep", [](PipedActor& piped)
      { piped.GetRequest()->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), 2.0); } },
    Change{
      "UserTransform", [](PipedActor& piped) { piped.UserTransform->Translate(1.0, 0.0, 0.0); } },
    Change{
      "TransformBehindTheUsers", [](PipedActor& piped) { piped.Outer->Translate(1.0, 0.0, 0.0); } },
    Change{ "Position", [](PipedActor& piped) { piped.Actor->SetPosition(1.0, 0.0, 0.0); } },
    Change{ "Property", [](PipedActor& piped) { piped.Actor->GetProperty()->SetOpacity(0.5); } },
    Change{ "Mapper",
      [](PipedActor& piped)
      {
        vtkNew<vtkOpenGLPolyDataMapper> other;
        other->SetInputConnection(piped.Source->GetOutputPort());
        piped.Actor->SetMapper(other);
      } },
    Change{ "NewShaderProperty", [](PipedActor& piped) { piped.Actor->GetShaderProperty(); } }),
  [](const auto& info) { return info.param.Name; });

// Hazard: a filter that marks itself as modified while it runs counts as changed for ever.
TEST(NBufferPipelines, RunningIsNoChange)
{
  PipedActor piped;
  vtkNBufferPipeline pipeline;
  for (int i = 0; i < 3; ++i)
  {
    piped.Source->SetRadius(1.0 + i);
    EXPECT_TRUE(i == 0 || pipeline.HasChanged());
    piped.Actor->GetBounds();
    ASSERT_TRUE(pipeline.Take(piped.Actor));
    piped.Actor->GetBounds();
    EXPECT_FALSE(pipeline.HasChanged());
  }
}

// Hazard: what decides about the image without a time of its own is taken.
TEST(NBufferPipelines, WhatDoesNotShowInTimesIsNotTaken)
{
  const auto takes = [](const std::function<void(PipedActor&)>& prepare)
  {
    PipedActor piped;
    prepare(piped);
    return vtkNBufferPipeline().Take(piped.Actor);
  };
  EXPECT_TRUE(takes([](PipedActor&) {}));
  EXPECT_FALSE(takes([](PipedActor& piped) { piped.Actor->SetMapper(nullptr); }));
  EXPECT_FALSE(takes([](PipedActor& piped) { piped.Actor->SetTexture(vtkNew<vtkTexture>()); }));
  EXPECT_FALSE(
    takes([](PipedActor& piped) { piped.Mapper->AddClippingPlane(vtkNew<vtkPlane>()); }));
  EXPECT_FALSE(takes(
    [](PipedActor& piped)
    {
      const double range[2] = { 0.0, 1.0 };
      piped.GetRequest()->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    }));
  EXPECT_FALSE(takes(
    [](PipedActor& piped)
    {
      vtkNew<vtkDataSetMapper> mapper;
      mapper->SetInputData(vtkNew<vtkImageData>());
      piped.Actor->SetMapper(mapper);
    }));
}

// Hazard: props with a matrix of their user's, as importers make them, are looked at anew in every
// frame; or not even when it changes.
TEST(NBufferPipelines, WithoutOneTransformsOfUsersAreAskedInParallel)
{
  vtkNew<vtkSphereSource> source;
  source->Update();
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputData(source->GetOutput());
  vtkNew<vtkMatrix4x4> matrix;
  vtkNew<vtkTransform> transform;
  vtkNew<vtkTransform> outer;
  transform->Concatenate(outer);
  for (const bool isMatrix : { true, false })
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    if (isMatrix)
    {
      actor->SetUserMatrix(matrix);
    }
    else
    {
      actor->SetUserTransform(transform);
    }
    vtkNBufferCandidate candidate(actor);
    candidate.Refresh(false);
    ASSERT_TRUE(candidate.IsCandidate());
    EXPECT_FALSE(candidate.IsStale());
    matrix->SetElement(0, 3, 2.0);
    outer->Translate(1.0, 0.0, 0.0);
    EXPECT_TRUE(candidate.IsStale());
    EXPECT_TRUE(candidate.Refresh(false));
    EXPECT_FALSE(candidate.IsStale());
  }
}
