// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The classes that an application vouches for: what the module assumes about them, and from when
// on.
#include "CompositeMapper.h"

#include "vtkNBufferCuller.h"
#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferPropWatch.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkCommand.h"
#include "vtkDataSetMapper.h"
#include "vtkFollower.h"
#include "vtkFramebufferPass.h"
#include "vtkGlyph3DMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOutputWindow.h"
#include "vtkPolyData.h"
#include "vtkVolume.h"

#include <gtest/gtest.h>

#include <string>

using vtkNBufferKnownClasses::MapperKind;

namespace
{
#define OWN_CLASS(name, base)                                                                      \
  class name : public base                                                                         \
  {                                                                                                \
  public:                                                                                          \
    static name* New();                                                                            \
    vtkTypeMacro(name, base);                                                                      \
  };                                                                                               \
  vtkStandardNewMacro(name)

OWN_CLASS(OwnPolyDataMapper, vtkOpenGLPolyDataMapper);
OWN_CLASS(OwnSubclass, OwnPolyDataMapper);
OWN_CLASS(OwnDataSetMapper, vtkDataSetMapper);
OWN_CLASS(OwnCompositeMapper, CompositeMapper);
OWN_CLASS(OwnGlyphMapper, vtkGlyph3DMapper);
OWN_CLASS(OwnFollower, vtkFollower);
OWN_CLASS(OwnVolume, vtkVolume);
OWN_CLASS(OwnCameraPass, vtkCameraPass);

/// Keeps the last message.
class Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Text += text; }
  std::string Text;
};
vtkStandardNewMacro(Window);
}

TEST(NBufferKnownClasses, AMapperIsOfTheKindOfItsBase)
{
  vtkNew<OwnPolyDataMapper> polyData;
  EXPECT_EQ(vtkNBufferKnownClasses::GetKind(polyData), MapperKind::Other);
  EXPECT_FALSE(vtkNBufferSurface::IsPlain(polyData));
  for (const char* name :
    { "OwnPolyDataMapper", "OwnDataSetMapper", "OwnCompositeMapper", "OwnGlyphMapper" })
  {
    vtkNBufferCuller::AddKnownMapper(name);
  }
  EXPECT_EQ(vtkNBufferKnownClasses::GetKind(polyData), MapperKind::PolyData);
  EXPECT_TRUE(vtkNBufferSurface::IsPlain(polyData));
  vtkNew<vtkPolyData> data;
  polyData->SetInputData(data);
  EXPECT_EQ(vtkNBufferSurface::GetOnlyPolyData(polyData), data);
  EXPECT_EQ(vtkNBufferKnownClasses::GetKind(vtkNew<OwnDataSetMapper>()), MapperKind::DataSet);
  EXPECT_EQ(vtkNBufferKnownClasses::GetKind(vtkNew<OwnCompositeMapper>()), MapperKind::Composite);
  EXPECT_TRUE(vtkNBufferSurface::IsComposite(vtkNew<OwnCompositeMapper>()));
  // Hazard: a class is vouched for from which nothing can be read.
  EXPECT_EQ(vtkNBufferKnownClasses::GetKind(vtkNew<OwnGlyphMapper>()), MapperKind::Other);
  // Hazard: so is a subclass, which may draw anything again.
  EXPECT_EQ(vtkNBufferKnownClasses::GetKind(vtkNew<OwnSubclass>()), MapperKind::Other);
}

TEST(NBufferKnownClasses, AnActorAndAPassAreKnownByName)
{
  vtkNew<OwnFollower> follower;
  EXPECT_EQ(vtkNBufferKnownClasses::GetPlainActor(follower), nullptr);
  vtkNBufferCuller::AddKnownActor("OwnFollower");
  EXPECT_EQ(vtkNBufferKnownClasses::GetPlainActor(follower), follower);
  EXPECT_EQ(vtkNBufferKnownClasses::GetPlainActor(vtkNew<vtkFollower>()), nullptr);
  vtkNBufferCuller::AddKnownActor("OwnVolume");
  EXPECT_EQ(vtkNBufferKnownClasses::GetPlainActor(vtkNew<OwnVolume>()), nullptr) << "it is no actor";

  EXPECT_TRUE(vtkNBufferKnownClasses::IsKnown(vtkNew<vtkFramebufferPass>()));
  vtkNew<OwnCameraPass> pass;
  EXPECT_FALSE(vtkNBufferKnownClasses::IsKnown(pass));
  vtkNBufferCuller::AddKnownPass("OwnCameraPass");
  EXPECT_TRUE(vtkNBufferKnownClasses::IsKnown(pass));
}

// Hazard: an application vouches for a class, and props that were read before keep their old
// verdicts.
TEST(NBufferKnownClasses, ANewNameChangesTheGlobalState)
{
  const auto before = vtkNBufferPropWatch::GetGlobalState();
  EXPECT_EQ(vtkNBufferPropWatch::GetGlobalState(), before);
  vtkNBufferCuller::AddKnownMapper("NewName");
  const auto after = vtkNBufferPropWatch::GetGlobalState();
  EXPECT_NE(after, before);
  vtkNBufferCuller::AddKnownMapper("NewName");
  EXPECT_EQ(vtkNBufferPropWatch::GetGlobalState(), after) << "it was known";
}

// Hazard: time stamps are compared without calling GetMTime(), and what an application's GetMTime()
// adds is missed.
TEST(NBufferKnownClasses, TimesOfKnownClassesAreReadByTheirFunctions)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkOpenGLPolyDataMapper> plain;
  plain->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(plain);
  vtkNBufferPropWatch watch;
  watch.Track(actor);
  EXPECT_EQ(watch.GetMeans(), vtkNBufferPropWatch::Means::Stamps);

  vtkNBufferCuller::AddKnownMapper("OwnPolyDataMapper");
  vtkNew<OwnPolyDataMapper> own;
  own->SetInputData(data);
  own->Update();
  actor->SetMapper(own);
  watch.Track(actor);
  EXPECT_EQ(watch.GetMeans(), vtkNBufferPropWatch::Means::Pipeline);
  EXPECT_TRUE(watch.SeesAllChanges());
  EXPECT_FALSE(watch.HasChanged());
  own->Modified();
  EXPECT_TRUE(watch.HasChanged());
}

TEST(NBufferKnownClasses, AMissingNameIsAnError)
{
  vtkNew<Window> window;
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkOutputWindow::SetInstance(window);
  const auto state = vtkNBufferPropWatch::GetGlobalState();
  vtkNBufferCuller::AddKnownPass(nullptr);
  vtkNBufferCuller::AddKnownMapper("");
  vtkNBufferCuller::AddKnownActor("");
  vtkOutputWindow::SetInstance(before);
  EXPECT_EQ(vtkNBufferPropWatch::GetGlobalState(), state);
  std::size_t errors = 0;
  for (std::size_t at = 0;
       (at = window->Text.find("a class to be known has no name", at)) != std::string::npos; ++at)
  {
    ++errors;
  }
  EXPECT_EQ(errors, 3u) << window->Text;
}
