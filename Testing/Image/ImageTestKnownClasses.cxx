// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Classes of an application: the culler steps aside until the application vouches for them, and
// the image is the same before and after.
#include "CullerTest.h"
#include "ScenePasses.h"
#include "Scenes.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"

using Scenes::Wall;

namespace
{
/// A pass whose source cannot be changed: it lets another one draw and does not say so.
class OwnPass : public vtkRenderPass
{
public:
  static OwnPass* New();
  vtkTypeMacro(OwnPass, vtkRenderPass);

  void Render(const vtkRenderState* s) override { this->Steps->Render(s); }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Steps->ReleaseGraphicsResources(window);
  }

private:
  vtkNew<vtkRenderStepsPass> Steps;
};
vtkStandardNewMacro(OwnPass);

class OwnMapper : public vtkOpenGLPolyDataMapper
{
public:
  static OwnMapper* New();
  vtkTypeMacro(OwnMapper, vtkOpenGLPolyDataMapper);

  /// The data may be changed by an object of which only this function knows.
  vtkMTimeType GetMTime() override
  {
    return std::max(this->Superclass::GetMTime(), this->Recipe->GetMTime());
  }

  vtkNew<vtkObject> Recipe;
};
vtkStandardNewMacro(OwnMapper);

/// Subclasses of an application's classes that are not vouched for.
class OwnMapperOfAnother : public OwnMapper
{
public:
  static OwnMapperOfAnother* New();
  vtkTypeMacro(OwnMapperOfAnother, OwnMapper);
};
vtkStandardNewMacro(OwnMapperOfAnother);

/// An actor with two levels of detail, which does not say when it changes to the other one.
class OwnActor : public vtkOpenGLActor
{
public:
  static OwnActor* New();
  vtkTypeMacro(OwnActor, vtkOpenGLActor);

  vtkMapper* GetMapper() override { return this->Coarse ? this->CoarseMapper : this->Mapper; }
  double* GetBounds() override { return this->GetMapper()->GetBounds(); }
  void Render(vtkRenderer* renderer, vtkMapper*) override
  {
    this->Superclass::Render(renderer, this->GetMapper());
  }

  bool Coarse = false;
  vtkNew<vtkOpenGLPolyDataMapper> CoarseMapper;
};
vtkStandardNewMacro(OwnActor);

/// A box behind the wall, drawn by this mapper and actor.
template <typename MapperClass, typename ActorClass>
vtkSmartPointer<ActorClass> MakeHidden(double height = 1.0)
{
  vtkNew<MapperClass> mapper;
  mapper->SetInputData(Scenes::MakeBox({ 1.0, 0.5, -3.0 }, { 1.0, height, 1.0 }));
  vtkNew<ActorClass> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.4, 0.1);
  return actor;
}

Comparison MakeComparison(const Comparison::Change& change, bool compareDraws = true)
{
  ComparisonOptions options;
  options.CompareDraws = compareDraws;
  return Comparison(
    [&change](Stage& stage)
    {
      Scenes::BuildWall(stage);
      change(stage);
    },
    options);
}

/// Frames in which the wall is passed, with the verdict of the prop behind it.
void ExpectVerdict(Comparison& comparison, Verdict expected)
{
  Scenes::FramesOfWall(comparison, { 0.0, 0.1, 0.2 });
  EXPECT_EQ(comparison.GetVerdict(Wall::Count), expected);
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  Scenes::FrameOfWall(comparison, 9.0, "behind the wall's edge");
  comparison.Frame("still");
}
}

// Hazard: a pass of an unknown class draws something else than the renderer's props.
TEST(CullerKnownClasses, Pass)
{
  Comparison comparison =
    MakeComparison([](Stage& stage) { stage.GetRenderer()->SetPass(vtkNew<OwnPass>()); });
  comparison.Frame();
  EXPECT_EQ(comparison.GetDecision(), Decision::RenderPass);
  EXPECT_EQ(comparison.GetHidden(), 0);
  vtkNBufferCuller::AddKnownPass("OwnPass");
  Scenes::ExpectFramesOfWall(comparison, { 0.0, 0.2, 0.4, 12.0, 16.0 }, Wall::Behind / 3 + 1);
  comparison.Frame("still");
}

// Hazard: a mapper of an unknown class draws outside its bounds. A mapper of a class that the
// application vouches for overrides GetMTime(), and a change that shows only there is missed.
TEST(CullerKnownClasses, Mapper)
{
  Comparison comparison = MakeComparison(
    [](Stage& stage)
    {
      stage.Add(MakeHidden<OwnMapper, vtkOpenGLActor>());
      stage.Add(MakeHidden<OwnMapperOfAnother, vtkOpenGLActor>());
    });
  ExpectVerdict(comparison, Verdict::NotAPlainMapper);
  vtkNBufferCuller::AddKnownMapper("OwnMapper");
  ExpectVerdict(comparison, Verdict::Hidden);
  EXPECT_EQ(comparison.GetVerdict(Wall::Count + 1), Verdict::NotAPlainMapper)
    << "a subclass of a known class is not known";

  // What draws as it likes changes without notice.
  comparison.Both([](Stage& stage) { stage.Props[Wall::Count + 1]->VisibilityOff(); });
  Scenes::FrameOfWall(comparison, 0.0, "without a change");
  comparison.Frame("still");
  comparison.Frame("still");
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
  comparison.Both(
    [](Stage& stage)
    {
      // In place: only the mapper's own function says that something has changed.
      auto* mapper = OwnMapper::SafeDownCast(stage.GetActor(Wall::Count)->GetMapper());
      mapper->Recipe->Modified();
    });
  comparison.Frame("with a newer time");
  EXPECT_NE(comparison.GetDecision(), Decision::Still);
}

// Hazard: an actor of an unknown class may draw anything. An actor of a class that the application
// vouches for changes its mapper without a newer time, and what the culler knows of the old mapper
// is used.
TEST(CullerKnownClasses, ActorWithTwoMappers)
{
  Comparison comparison = MakeComparison(
    [](Stage& stage)
    {
      vtkSmartPointer<OwnActor> actor = MakeHidden<vtkOpenGLPolyDataMapper, OwnActor>();
      actor->CoarseMapper->SetInputData(Scenes::MakeBox({ 1.0, 0.5, -3.0 }, { 1.0, 40.0, 1.0 }));
      stage.Add(actor);
      // The newest time is that of the property, with either mapper.
      actor->GetProperty()->Modified();
    },
    false);
  ExpectVerdict(comparison, Verdict::NotAPlainActor);
  vtkNBufferCuller::AddKnownActor("OwnActor");
  ExpectVerdict(comparison, Verdict::Hidden);
  for (const bool coarse : { true, false, true })
  {
    comparison.Frame("still");
    Scenes::FrameOfWall(comparison, 0.0, coarse ? "fine" : "coarse");
    comparison.Frame("still");
    comparison.Both([coarse](Stage& stage)
      { OwnActor::SafeDownCast(stage.Props[Wall::Count])->Coarse = coarse; });
    comparison.Frame(coarse ? "coarse now" : "fine now");
    EXPECT_NE(comparison.GetDecision(), Decision::Still);
    comparison.Frame("once more");
    EXPECT_EQ(comparison.GetVerdict(Wall::Count), coarse ? Verdict::Visible : Verdict::Hidden);
  }
}
