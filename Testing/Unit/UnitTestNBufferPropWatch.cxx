// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a change of what a prop draws is noticed, by which means, and what may change without
// being noticed.
#include "CompositeMapper.h"

#include "vtkNBufferCandidate.h"
#include "vtkNBufferObservedObjects.h"
#include "vtkNBufferPropWatch.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataSetMapper.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

namespace
{
using Means = vtkNBufferPropWatch::Means;

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

/// A sphere without a pipeline.
struct StampedActor
{
  StampedActor()
  {
    vtkNew<vtkSphereSource> source;
    source->Update();
    this->Data->ShallowCopy(source->GetOutput());
    this->Mapper->SetInputData(this->Data);
    this->Mapper->SetLookupTable(this->Table);
    this->Actor->SetMapper(this->Mapper);
    this->Actor->SetUserMatrix(this->Matrix);
    this->Actor->GetBounds();
  }

  vtkNew<vtkPolyData> Data;
  vtkNew<vtkLookupTable> Table;
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkNew<vtkActor> Actor;
};

/// What is done to an actor, by name.
template <typename Props>
using ChangeOf = std::pair<const char*, std::function<void(Props&)>>;

/// A prop of another class that begins at the address of a plain actor, and may be of any class.
class OtherProp : public vtkOpenGLActor
{
public:
  static OtherProp* New();
  vtkTypeMacro(OtherProp, vtkOpenGLActor);
  vtkMapper* GetMapper() override
  {
    EXPECT_TRUE(this->IsKnown) << "called for a prop that is no actor any more";
    return this->Superclass::GetMapper();
  }
  bool IsKnown = false; ///< Whether the prop may be called.

protected:
  OtherProp() = default;
};
vtkStandardNewMacro(OtherProp);

/// A new object of class T at an address at which there was another one, or nullptr if the
/// allocator does not give it back.
template <typename T>
vtkSmartPointer<T> MakeAt(const vtkProp* address)
{
  std::vector<vtkSmartPointer<T>> elsewhere;
  for (int i = 0; i < 100; ++i)
  {
    elsewhere.push_back(vtkSmartPointer<T>::New());
    if (elsewhere.back() == address)
    {
      return elsewhere.back();
    }
  }
  return nullptr;
}

vtkNBufferPropWatch Watch(vtkProp* prop)
{
  vtkNBufferPropWatch watch;
  watch.Track(prop);
  return watch;
}
}

// Hazard: a change upstream does not change the times of actor, mapper and data before the pipeline
// runs.
TEST(NBufferPipeline, ChangesAreSeenBeforeTheyAreRun)
{
  const ChangeOf<PipedActor> changes[] = {
    { "Source", [](PipedActor& p) { p.Source->SetRadius(3.0); } },
    { "FiltersTransform", [](PipedActor& p) { p.Transform->Translate(1.0, 0.0, 0.0); } },
    { "SourceRunByAnother",
      [](PipedActor& p)
      {
        p.Source->SetRadius(3.0);
        p.Filter->Update();
      } },
    { "Connection",
      [](PipedActor& p) { p.Mapper->SetInputConnection(p.Source->GetOutputPort()); } },
    { "FiltersConnection",
      [](PipedActor& p)
      { p.Filter->SetInputConnection(vtkNew<vtkSphereSource>()->GetOutputPort()); } },
    { "Data",
      [](PipedActor& p)
      { vtkPolyData::SafeDownCast(p.Mapper->GetInput())->GetPoints()->Modified(); } },
    { "ReleasedData", [](PipedActor& p) { p.Mapper->GetInput()->ReleaseData(); } },
    { "TimeStep",
      [](PipedActor& p)
      { p.GetRequest()->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), 2.0); } },
    { "UserTransform", [](PipedActor& p) { p.UserTransform->Translate(1.0, 0.0, 0.0); } },
    { "TransformBehindTheUsers", [](PipedActor& p) { p.Outer->Translate(1.0, 0.0, 0.0); } },
    { "Position", [](PipedActor& p) { p.Actor->SetPosition(1.0, 0.0, 0.0); } },
    { "Property", [](PipedActor& p) { p.Actor->GetProperty()->SetOpacity(0.5); } },
    { "Mapper",
      [](PipedActor& p)
      {
        vtkNew<vtkOpenGLPolyDataMapper> other;
        other->SetInputConnection(p.Source->GetOutputPort());
        p.Actor->SetMapper(other);
      } },
    { "NewShaderProperty", [](PipedActor& p) { p.Actor->GetShaderProperty(); } },
  };
  for (const auto& [name, apply] : changes)
  {
    SCOPED_TRACE(name);
    PipedActor piped;
    const vtkNBufferPropWatch watch = Watch(piped.Actor);
    ASSERT_EQ(watch.GetMeans(), Means::Pipeline);
    EXPECT_TRUE(watch.MayHaveChanged()) << "which only the pipeline knows";
    EXPECT_FALSE(watch.HasChanged());
    apply(piped);
    EXPECT_TRUE(watch.HasChanged());
    EXPECT_TRUE(watch.HasChanged()) << "the first call must not forget the change";
  }
}

// Hazard: a filter that modifies itself while it runs counts as changed in every frame.
TEST(NBufferPipelines, RunningIsNoChange)
{
  PipedActor piped;
  vtkNBufferPropWatch watch;
  for (int i = 0; i < 3; ++i)
  {
    piped.Source->SetRadius(1.0 + i);
    EXPECT_TRUE(watch.HasChanged());
    piped.Actor->GetBounds();
    watch.Track(piped.Actor);
    ASSERT_EQ(watch.GetMeans(), Means::Pipeline);
    piped.Actor->GetBounds();
    EXPECT_FALSE(watch.HasChanged());
  }
}

// Hazard: the times of a pipeline are compared although the image depends on something that has no
// time of its own.
TEST(NBufferPipelines, WhatDoesNotShowInTimesIsNotTracked)
{
  const auto tracks = [](const std::function<void(PipedActor&)>& prepare)
  {
    PipedActor piped;
    prepare(piped);
    return Watch(piped.Actor).GetMeans() == Means::Pipeline;
  };
  EXPECT_TRUE(tracks([](PipedActor&) {}));
  EXPECT_FALSE(tracks([](PipedActor& piped) { piped.Actor->SetMapper(nullptr); }));
  EXPECT_FALSE(tracks([](PipedActor& piped) { piped.Actor->SetTexture(vtkNew<vtkTexture>()); }));
  EXPECT_FALSE(
    tracks([](PipedActor& piped) { piped.Mapper->AddClippingPlane(vtkNew<vtkPlane>()); }));
  EXPECT_FALSE(tracks(
    [](PipedActor& piped)
    {
      const double range[2] = { 0.0, 1.0 };
      piped.GetRequest()->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    }));
  EXPECT_FALSE(tracks(
    [](PipedActor& piped)
    {
      vtkNew<vtkDataSetMapper> mapper;
      mapper->SetInputData(vtkNew<vtkImageData>());
      piped.Actor->SetMapper(mapper);
    }));
}

// Hazard: one of the objects of an actor without a pipeline is not compared.
TEST(NBufferStamps, ChangesAreSeen)
{
  const ChangeOf<StampedActor> changes[] = {
    { "Position", [](StampedActor& s) { s.Actor->SetPosition(1.0, 0.0, 0.0); } },
    { "Property", [](StampedActor& s) { s.Actor->GetProperty()->SetOpacity(0.5); } },
    { "NewBackfaceProperty",
      [](StampedActor& s) { s.Actor->SetBackfaceProperty(vtkNew<vtkProperty>()); } },
    { "UserMatrix", [](StampedActor& s) { s.Matrix->SetElement(0, 3, 2.0); } },
    { "NewShaderProperty", [](StampedActor& s) { s.Actor->GetShaderProperty(); } },
    { "Mapper", [](StampedActor& s) { s.Mapper->SetScalarVisibility(false); } },
    { "NewLookupTable",
      [](StampedActor& s) { s.Mapper->SetLookupTable(vtkNew<vtkLookupTable>()); } },
    { "OpacityInTheLookupTable", [](StampedActor& s) { s.Table->SetAlphaRange(0.5, 0.5); } },
    { "NewMapper",
      [](StampedActor& s)
      {
        vtkNew<vtkOpenGLPolyDataMapper> other;
        other->SetInputData(s.Data);
        s.Actor->SetMapper(other);
      } },
    { "NewData",
      [](StampedActor& s)
      {
        vtkNew<vtkPolyData> other;
        other->DeepCopy(s.Data);
        s.Mapper->SetInputData(other);
      } },
    { "Data", [](StampedActor& s) { s.Data->Modified(); } },
    { "Points", [](StampedActor& s) { s.Data->GetPoints()->Modified(); } },
    { "Coordinates", [](StampedActor& s) { s.Data->GetPoints()->GetData()->Modified(); } },
    { "Polygons", [](StampedActor& s) { s.Data->GetPolys()->Modified(); } },
    { "Normals", [](StampedActor& s) { s.Data->GetPointData()->GetNormals()->Modified(); } },
    { "NewArray",
      [](StampedActor& s)
      {
        vtkNew<vtkFloatArray> array;
        array->SetName("new");
        s.Data->GetPointData()->AddArray(array);
      } },
    { "FieldData", [](StampedActor& s) { s.Data->GetFieldData()->Modified(); } },
  };
  for (const auto& [name, apply] : changes)
  {
    SCOPED_TRACE(name);
    vtkNBufferObservedObjects objects;
    vtkNBufferObservedObjects actors;
    const auto mayHaveChanged = [&objects](const vtkNBufferPropWatch& watch)
    { return watch.MayHaveChanged(!objects.TakeChange()); };
    StampedActor stamped;
    vtkNBufferPropWatch watch = Watch(stamped.Actor);
    ASSERT_EQ(watch.GetMeans(), Means::Stamps);
    EXPECT_TRUE(watch.SeesAllChanges());
    EXPECT_FALSE(watch.MayHaveChanged());
    EXPECT_FALSE(watch.HasChanged());
    watch.Observe(objects, actors);
    EXPECT_FALSE(watch.IsObserved()) << "it may change in the next frame again";
    watch.Observe(objects, actors);
    EXPECT_TRUE(watch.IsObserved());
    EXPECT_FALSE(mayHaveChanged(watch));
    const vtkMTimeType time = watch.GetTime();
    apply(stamped);
    EXPECT_TRUE(mayHaveChanged(watch)) << "observed";
    EXPECT_TRUE(watch.MayHaveChanged());
    EXPECT_TRUE(watch.HasChanged());
    stamped.Actor->GetBounds();
    watch.Track(stamped.Actor);
    EXPECT_GT(watch.GetTime(), time);
    EXPECT_FALSE(watch.HasChanged());
    EXPECT_FALSE(watch.IsObserved());
  }
}

// Hazard: objects are observed instead of compared, and one of them is not observed.
TEST(NBufferStamps, AllObjectsButTheActorAreObserved)
{
  vtkNBufferObservedObjects objects;
  vtkNBufferObservedObjects actors;
  StampedActor stamped;
  vtkNBufferPropWatch watch = Watch(stamped.Actor);
  watch.Observe(objects, actors);
  watch.Observe(objects, actors);
  for (vtkObject* object : { static_cast<vtkObject*>(stamped.Actor->GetProperty()),
         static_cast<vtkObject*>(stamped.Matrix), static_cast<vtkObject*>(stamped.Mapper),
         static_cast<vtkObject*>(stamped.Table),
         static_cast<vtkObject*>(stamped.Mapper->GetInputAlgorithm()),
         static_cast<vtkObject*>(stamped.Data), static_cast<vtkObject*>(stamped.Data->GetPoints()),
         static_cast<vtkObject*>(stamped.Data->GetPolys()),
         static_cast<vtkObject*>(stamped.Data->GetPointData()->GetNormals()) })
  {
    EXPECT_TRUE(object->HasObserver(vtkCommand::ModifiedEvent)) << object->GetClassName();
  }
  EXPECT_FALSE(stamped.Actor->HasObserver(vtkCommand::ModifiedEvent));
  EXPECT_FALSE(watch.IsWhollyObserved()) << "a transform may depend on any number of others";
}

// Hazard: an observed actor, which is not compared in each frame, moves, gets a shader property, or
// is deleted.
TEST(NBufferStamps, ActorsWithoutTransformsOfUsersAreObservedAsWell)
{
  const ChangeOf<StampedActor> changes[] = {
    { "Position", [](StampedActor& s) { s.Actor->SetPosition(1.0, 0.0, 0.0); } },
    { "Transform", [](StampedActor& s) { s.Actor->SetUserMatrix(s.Matrix); } },
    { "Mapper", [](StampedActor& s) { s.Actor->SetMapper(vtkNew<vtkOpenGLPolyDataMapper>()); } },
    { "Property", [](StampedActor& s) { s.Actor->SetProperty(vtkNew<vtkProperty>()); } },
    { "ShaderProperty",
      [](StampedActor& s) { s.Actor->SetShaderProperty(vtkNew<vtkOpenGLShaderProperty>()); } },
    { "Shaders",
      [](StampedActor& s)
      { s.Actor->GetShaderProperty()->SetVertexShaderCode("void main() {}"); } },
  };
  for (const auto& [name, apply] : changes)
  {
    SCOPED_TRACE(name);
    vtkNBufferObservedObjects objects;
    vtkNBufferObservedObjects actors;
    StampedActor stamped;
    stamped.Actor->SetUserMatrix(nullptr);
    vtkNBufferPropWatch watch = Watch(stamped.Actor);
    watch.Observe(objects, actors);
    watch.Observe(objects, actors);
    EXPECT_FALSE(watch.IsWhollyObserved()) << "a shader property is created without an event";
    stamped.Actor->GetShaderProperty();
    EXPECT_TRUE(watch.HasChanged());
    watch.Track(stamped.Actor);
    watch.Observe(objects, actors);
    EXPECT_FALSE(watch.IsWhollyObserved());
    watch.Observe(objects, actors);
    EXPECT_TRUE(watch.IsWhollyObserved());
    EXPECT_FALSE(objects.TakeChange() || actors.TakeChange() || watch.HasChanged());
    apply(stamped);
    EXPECT_TRUE(objects.TakeChange() || actors.TakeChange());
    EXPECT_TRUE(watch.HasChanged());
  }
}

// Hazard: a prop that has to be read in every frame counts as unchanged, because only something
// behind its mapper has changed.
TEST(NBufferPropWatch, TimesFollowWhatHasToBeReadInEveryFrame)
{
  const auto follows =
    [](vtkActor* actor, const std::function<void()>& change, bool withBlocks = true)
  {
    vtkNBufferPropWatch watch;
    watch.Track(actor, withBlocks);
    EXPECT_EQ(watch.GetMeans(), Means::Times);
    EXPECT_TRUE(watch.HasChanged());
    const vtkMTimeType time = watch.GetTime();
    watch.Track(actor, withBlocks);
    EXPECT_EQ(watch.GetTime(), time);
    change();
    watch.Track(actor, withBlocks);
    return watch.GetTime() > time;
  };
  StampedActor clipped;
  vtkNew<vtkPlane> plane;
  clipped.Mapper->AddClippingPlane(plane);
  EXPECT_TRUE(follows(clipped.Actor, [&]() { plane->SetOrigin(0.0, 0.0, 1.0); }));

  StampedActor textured;
  vtkNew<vtkImageData> image;
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  textured.Actor->SetTexture(texture);
  EXPECT_TRUE(follows(textured.Actor, [&]() { image->Modified(); }));

  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, textured.Data);
  blocks->SetBlock(0, inner);
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> composite;
  composite->SetMapper(mapper);
  const auto changeBlock = [&]() { textured.Data->GetPoints()->Modified(); };
  EXPECT_TRUE(follows(composite, changeBlock));
  EXPECT_FALSE(follows(composite, changeBlock, false)) << "without the blocks";
  EXPECT_TRUE(follows(
    composite, [&]() { blocks->Modified(); }, false));

  vtkNew<vtkActor> empty;
  EXPECT_TRUE(follows(empty, [&]() { empty->SetPosition(1.0, 0.0, 0.0); }));
}

// Hazard: a still image is used again although a prop moves without a newer time.
TEST(NBufferPropWatch, WhatMayChangeWithoutATraceIsSaid)
{
  vtkNBufferPropWatch fresh;
  EXPECT_TRUE(fresh.MayHaveChanged() && fresh.HasChanged());
  EXPECT_FALSE(fresh.SeesAllChanges());

  EXPECT_TRUE(Watch(vtkNew<vtkActor>()).SeesAllChanges()) << "draws nothing without a mapper";

  vtkNew<vtkFollower> subclass;
  EXPECT_EQ(Watch(subclass).GetMeans(), Means::None);
  EXPECT_EQ(Watch(subclass).GetTime(), 0u);
  EXPECT_FALSE(Watch(subclass).SeesAllChanges());

  vtkNew<vtkActor> glyphs;
  glyphs->SetMapper(vtkNew<vtkGlyph3DMapper>());
  EXPECT_EQ(Watch(glyphs).GetMeans(), Means::None);
  EXPECT_TRUE(Watch(glyphs).HasChanged());
  EXPECT_FALSE(Watch(glyphs).SeesAllChanges());
  vtkNew<vtkGlyph3DMapper> known;
  known->SetInputData(vtkNew<vtkPolyData>());
  known->SetSourceData(vtkNew<vtkPolyData>());
  glyphs->SetMapper(known);
  EXPECT_EQ(Watch(glyphs).GetMeans(), Means::Times);
  EXPECT_FALSE(Watch(glyphs).SeesAllChanges());

  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(vtkNew<vtkMultiBlockDataSet>());
  vtkNew<vtkActor> composite;
  composite->SetMapper(mapper);
  EXPECT_EQ(Watch(composite).GetMeans(), Means::Times);
  EXPECT_FALSE(Watch(composite).SeesAllChanges()) << "blocks have attributes without times";

  StampedActor shaded;
  shaded.Actor->GetShaderProperty()->SetFragmentShaderCode("void main() {}");
  EXPECT_EQ(Watch(shaded.Actor).GetMeans(), Means::Stamps);
  EXPECT_FALSE(Watch(shaded.Actor).SeesAllChanges()) << "uniforms have no times";
#if VTKNBUFFER_HAS_COORDINATE_SYSTEMS
  StampedActor worn;
  worn.Actor->SetCoordinateSystemToPhysical();
  EXPECT_FALSE(Watch(worn.Actor).SeesAllChanges()) << "a device moves it";
#endif
}

// Hazard: props with a user matrix, as importers make them, are read anew in every frame; or a
// change of the matrix is missed.
TEST(NBufferPipelines, WithoutOneTransformsOfUsersAreComparedInParallel)
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

// Hazard: another prop is made at the address of a deleted plain actor, and functions of the actor
// are called for it.
TEST(NBufferPropWatch, AnotherPropAtTheSameAddressIsAChange)
{
  PipedActor piped;
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(piped.Mapper);
  actor->GetBounds();
  vtkNBufferPropWatch watch = Watch(actor);
  ASSERT_EQ(watch.GetMeans(), Means::Pipeline);
  EXPECT_FALSE(watch.HasChanged());
  const vtkProp* const address = actor;
  actor = nullptr;
  const auto other = MakeAt<OtherProp>(address);
  if (!other)
  {
    GTEST_SKIP() << "The allocator does not use the address again.";
  }
  EXPECT_TRUE(watch.HasChanged());
  watch.Track(other);
  EXPECT_EQ(watch.GetMeans(), Means::None);
}

// Hazard: another prop is made at the address of a deleted actor, and the objects of that actor are
// observed for it.
TEST(NBufferPropWatch, AnotherPropAtTheSameAddressHasNothingOfThePlainActor)
{
  vtkNBufferObservedObjects objects;
  StampedActor stamped;
  vtkNew<vtkProperty> property;
  property->SetOpacity(0.5);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(stamped.Mapper);
  actor->SetProperty(property);
  actor->ForceOpaqueOn();
  vtkNBufferCandidate candidate(actor);
  candidate.Refresh(false);
  EXPECT_TRUE(candidate.IsBlended());
  ASSERT_EQ(candidate.GetWatch().GetMeans(), Means::Stamps);
  const vtkProp* const address = actor;
  actor = nullptr;
  const auto other = MakeAt<OtherProp>(address);
  if (!other)
  {
    GTEST_SKIP() << "The allocator does not use the address again.";
  }
  other->IsKnown = true;
  EXPECT_TRUE(candidate.IsStale());
  candidate.Refresh(false);
  EXPECT_EQ(candidate.GetVerdict(), vtkNBufferVerdict::NotAPlainActor);
  EXPECT_FALSE(candidate.IsBlended());
  candidate.GetWatch().Observe(objects, objects);
  candidate.GetWatch().Observe(objects, objects);
  EXPECT_EQ(objects.GetSize(), 0u);
}

// Hazard: a prop that is not a plain actor is never read again, although there is now a plain actor
// at its address.
TEST(NBufferPropWatch, APlainActorAtTheAddressOfAnotherPropBecomesACandidate)
{
  StampedActor stamped;
  auto other = vtkSmartPointer<OtherProp>::New();
  other->IsKnown = true;
  vtkNBufferCandidate candidate(other);
  EXPECT_TRUE(candidate.IsStale());
  candidate.Refresh(false);
  EXPECT_EQ(candidate.GetVerdict(), vtkNBufferVerdict::NotAPlainActor);
  EXPECT_FALSE(candidate.IsStale());
  const vtkProp* const address = other;
  other = nullptr;
  const auto actor = MakeAt<vtkOpenGLActor>(address);
  if (!actor)
  {
    GTEST_SKIP() << "The allocator does not use the address again.";
  }
  actor->SetMapper(stamped.Mapper);
  EXPECT_TRUE(candidate.IsStale());
  EXPECT_TRUE(candidate.Refresh(false));
  EXPECT_TRUE(candidate.IsCandidate());
}
