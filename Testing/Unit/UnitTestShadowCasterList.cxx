// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which props cast, and when the list says that one of them may draw something else.
#include "vtkShadowCasterList.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

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

// Hazard: shadows of a still scene are drawn anew, or those of a scene that changes are kept.
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
