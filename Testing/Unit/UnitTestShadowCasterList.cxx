// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which props cast, and when the list says that one of them may draw something else.
#include "CompositeMapper.h"

#include "vtkShadowCasterList.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
class ShadowCasterList : public testing::Test
{
protected:
  ShadowCasterList()
  {
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
  }

  /// Whether the version has grown.
  bool Update(vtkInformation* keys = nullptr)
  {
    const vtkMTimeType before = this->List.GetVersion();
    this->List.Update(this->Renderer, keys);
    return this->List.GetVersion() != before;
  }

  int GetSkipped(vtkShadowSkip reason) const
  {
    return this->List.GetSkipped()[static_cast<std::size_t>(reason)];
  }

  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkShadowCasterList List;
};
}

// Hazard: the shadows of a still scene are drawn anew, or those of a scene that has changed are
// kept.
TEST_F(ShadowCasterList, VersionGrowsWithChangesOnly)
{
  EXPECT_TRUE(this->Update());
  EXPECT_EQ(this->List.GetNumberOfUpdates(), 1);
  EXPECT_FALSE(this->Update());
  EXPECT_EQ(this->List.GetNumberOfUpdates(), 0);
  this->Source->SetRadius(2.0);
  EXPECT_TRUE(this->Update()) << "the pipeline has to run";
  EXPECT_EQ(this->List.GetNumberOfUpdates(), 1);
  EXPECT_FALSE(this->Update());

  this->Mapper->SetInputData(this->Mapper->GetInput());
  this->Update();
  EXPECT_FALSE(this->Update());
  this->Actor->SetPosition(1.0, 0.0, 0.0);
  EXPECT_TRUE(this->Update()) << "without a pipeline";
  EXPECT_EQ(this->List.GetNumberOfUpdates(), 1);
  this->Actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  EXPECT_TRUE(this->Update()) << "it may draw something else";
  EXPECT_EQ(this->List.GetNumberOfUpdates(), 0) << "of the same shape";

  vtkNew<vtkActor> empty;
  this->Renderer->AddActor(empty);
  EXPECT_TRUE(this->Update());
  EXPECT_FALSE(this->Update()) << "an actor without a mapper changes like any other";
  this->Actor->VisibilityOff();
  EXPECT_TRUE(this->Update());
  EXPECT_TRUE(this->List.GetCasters().empty());
}

TEST_F(ShadowCasterList, VersionAlwaysGrowsWithWhatChangesWithoutATrace)
{
  vtkNew<vtkAssembly> assembly;
  this->Renderer->RemoveActor(this->Actor);
  assembly->AddPart(this->Actor);
  this->Renderer->AddActor(assembly);
  EXPECT_TRUE(this->Update());
  EXPECT_TRUE(this->Update());
  EXPECT_EQ(this->List.GetCasters().size(), 1u);

  this->Renderer->RemoveActor(assembly);
  this->Actor->SetMapper(vtkNew<vtkGlyph3DMapper>());
  this->Renderer->AddActor(this->Actor);
  EXPECT_TRUE(this->Update());
  EXPECT_TRUE(this->Update());
  EXPECT_EQ(this->GetSkipped(vtkShadowSkip::NotAPlainMapper), 1);
}

// Hazard: each instance of a glyph has a copy of its source.
TEST_F(ShadowCasterList, InstancesShareTheirTopology)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(this->Source->GetOutputPort());
  mapper->SetSourceConnection(this->Source->GetOutputPort());
  this->Actor->SetMapper(mapper);
  EXPECT_TRUE(this->Update());
  const std::vector<vtkShadowCaster*> casters = this->List.GetCasters();
  this->Source->Update();
  ASSERT_EQ(static_cast<vtkIdType>(casters.size()), this->Source->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(casters.front()->GetTriangles().data(), casters.back()->GetTriangles().data());
  EXPECT_NE(casters.front()->GetPoints()[0], casters.back()->GetPoints()[0]);
  EXPECT_FALSE(this->Update()) << "nothing has changed";
  EXPECT_EQ(this->List.GetCasters(), casters);
  this->Source->SetRadius(2.0);
  EXPECT_TRUE(this->Update()) << "the pipeline has to run";
  EXPECT_EQ(this->List.GetNumberOfUpdates(), static_cast<int>(casters.size()));
  EXPECT_EQ(this->List.GetCasters(), casters);
}

// Hazard: glyphs cast shadows from places where they are not drawn.
TEST_F(ShadowCasterList, GlyphsThatAreNotKnownCastNothing)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(this->Source->GetOutputPort());
  mapper->SetSourceConnection(this->Source->GetOutputPort());
  this->Actor->SetMapper(mapper);
  const auto expect = [this](bool cast)
  {
    this->Update();
    EXPECT_EQ(this->List.GetCasters().empty(), !cast);
    EXPECT_EQ(this->GetSkipped(vtkShadowSkip::NotAPlainMapper), cast ? 0 : 1);
  };
  expect(true);
  mapper->SetCullingAndLOD(true);
  expect(false);
  mapper->SetCullingAndLOD(false);
  mapper->SetUseSourceTableTree(true);
  expect(false);
  mapper->SetUseSourceTableTree(false);
  vtkNew<vtkPolyData> other;
  mapper->SetSourceData(1, other);
  expect(false);
  mapper->SetSourceConnection(1, nullptr);
  expect(true);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, this->Source->GetOutput());
  mapper->SetInputDataObject(blocks);
  expect(false);
}

// Hazard: a block is added or removed, and all other blocks are read again; or an invisible block
// casts.
TEST_F(ShadowCasterList, EachBlockIsACaster)
{
  constexpr unsigned int count = 1000;
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < count; ++i)
  {
    vtkNew<vtkPolyData> block;
    this->Source->SetCenter(3.0 * i, 0.0, 0.0);
    this->Source->Update();
    block->DeepCopy(this->Source->GetOutput());
    blocks->SetBlock(i, block);
  }
  vtkNew<CompositeMapper> mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(blocks);
  this->Actor->SetMapper(mapper);
  EXPECT_TRUE(this->Update());
  EXPECT_EQ(this->List.GetNumberOfUpdates(), static_cast<int>(count));
  std::vector<vtkShadowCaster*> casters = this->List.GetCasters();
  EXPECT_EQ(casters.size(), count);
  EXPECT_FALSE(this->Update());
  EXPECT_EQ(this->List.GetCasters(), casters);

  mapper->SetBlockVisibility(1, false); // The first block; flat index 0 is the whole.
  EXPECT_TRUE(this->Update());
  EXPECT_EQ(this->List.GetNumberOfUpdates(), 0);
  casters.erase(casters.begin());
  EXPECT_EQ(this->List.GetCasters(), casters);

  mapper->SetBlockVisibility(1, true);
  EXPECT_TRUE(this->Update());
  EXPECT_EQ(this->List.GetNumberOfUpdates(), 1);
  casters.insert(casters.begin(), this->List.GetCasters().front());
  EXPECT_EQ(this->List.GetCasters(), casters);

  // Hazard: the change of a block is not noticed, whether it casts or only receives.
  auto* last = vtkPolyData::SafeDownCast(blocks->GetBlock(count - 1));
  last->GetPoints()->Modified();
  EXPECT_TRUE(this->Update());
  EXPECT_EQ(this->List.GetNumberOfUpdates(), 1);
  attributes->SetBlockOpacity(last, 0.5);
  mapper->Modified();
  EXPECT_TRUE(this->Update());
  EXPECT_EQ(this->GetSkipped(vtkShadowSkip::Translucent), 1);
  EXPECT_FALSE(this->Update());
  last->GetPoints()->Modified();
  EXPECT_TRUE(this->Update()) << "it may hide receivers";
  attributes->RemoveBlockOpacities();
  mapper->Modified();
  this->Update();
  EXPECT_EQ(this->List.GetCasters().size(), count);
  vtkNew<vtkInformation> required;
  required->Set(vtkInformationIntegerKey::MakeKey("BLOCKS_CAST", "ShadowCasterList"), 1);
  EXPECT_TRUE(this->Update(required));
  EXPECT_TRUE(this->List.GetCasters().empty());
  EXPECT_FALSE(this->Update(required));
  last->GetPoints()->Modified();
  EXPECT_TRUE(this->Update(required)) << "it is a receiver";
}

TEST_F(ShadowCasterList, ActorsThatDoNotCastAreCountedByReason)
{
  this->Actor->GetProperty()->SetOpacity(0.5);
  this->Update();
  EXPECT_EQ(this->GetSkipped(vtkShadowSkip::Translucent), 1);
  this->Actor->GetProperty()->SetOpacity(1.0);
  this->Actor->GetProperty()->SetRepresentationToWireframe();
  this->Update();
  EXPECT_EQ(this->GetSkipped(vtkShadowSkip::Translucent), 0);
  EXPECT_EQ(this->GetSkipped(vtkShadowSkip::NotASurface), 1);
  EXPECT_TRUE(this->List.GetCasters().empty());
}

// Hazard: keys change without a change of the prop's time.
TEST_F(ShadowCasterList, KeysAreReadAgain)
{
  vtkNew<vtkInformation> required;
  auto* key = vtkInformationIntegerKey::MakeKey("CASTS", "ShadowCasterList");
  required->Set(key, 1);
  this->Update(required);
  EXPECT_TRUE(this->List.GetCasters().empty());
  vtkNew<vtkInformation> keys;
  this->Actor->SetPropertyKeys(keys);
  this->Update(required);
  EXPECT_TRUE(this->List.GetCasters().empty());
  keys->Set(key, 1);
  EXPECT_TRUE(this->Update(required));
  EXPECT_EQ(this->List.GetCasters().size(), 1u);
  keys->Remove(key);
  this->Update(required);
  EXPECT_TRUE(this->List.GetCasters().empty());
  this->Update(nullptr);
  EXPECT_EQ(this->List.GetCasters().size(), 1u);
}
