// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Failures: the culler warns once, with cause and remedy, counts the frames, and does not change
// the image. docs/limits.md lists the messages.
#include "CullerTest.h"
#include "OwnFramebuffer.h"
#include "Scenes.h"
#include "Tune.h"

#include VTKNBUFFER_GL_HEADER

namespace
{
/// The wall scene behind an OwnFramebuffer; depth of the window itself is then that of nothing.
Comparison::Change WithOwnFramebuffer(int samples, bool withDepth)
{
  return [=](Stage& stage)
  {
    vtkNew<OwnFramebuffer> framebuffer;
    framebuffer->Samples = samples;
    framebuffer->WithDepth = withDepth;
    stage.GetRenderer()->AddViewProp(framebuffer);
    Scenes::BuildWall(stage);
  };
}

bool HasSamples(int samples)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->Render();
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  return most >= samples;
}
}

// Hazard: a window without an OpenGL context has no depth to read.
TEST(CullerErrors, NoContext)
{
  TakeMessages();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkNBufferCuller> culler;
  Tune(culler, &vtkNBufferTuning::MinimumNumberOfCandidates, 1);
  std::vector<vtkSmartPointer<vtkActor>> actors(50);
  std::vector<vtkProp*> list;
  for (auto& actor : actors)
  {
    actor = vtkSmartPointer<vtkActor>::New();
    renderer->AddActor(actor);
    list.push_back(actor);
  }
  const std::vector<vtkProp*> before = list;
  std::string messages;
  for (int i = 0; i < 4; ++i)
  {
    int count = static_cast<int>(list.size());
    int initialized = 0;
    culler->Cull(renderer, list.data(), count, initialized);
    messages += TakeMessages();
    EXPECT_EQ(count, static_cast<int>(before.size()));
    EXPECT_EQ(list, before);
    EXPECT_EQ(culler->GetStatistics().Decision, Decision::NoContext);
    EXPECT_EQ(culler->GetStatistics().FailedFrames, i + 1);
  }
  Scenes::ExpectOneWarning(messages, { "has no OpenGL context", "VTK::RenderingOpenGL2" });
}

// Hazard: an application culls a renderer that belongs to no window.
TEST(CullerErrors, NoWindow)
{
  TakeMessages();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkActor> actor;
  vtkNew<vtkNBufferCuller> culler;
  vtkProp* list[] = { actor };
  int count = 1;
  int initialized = 0;
  EXPECT_EQ(culler->Cull(renderer, list, count, initialized), 1.0);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(culler->GetStatistics().Decision, Decision::NoContext);
  Scenes::ExpectOneWarning(TakeMessages(), { "has no OpenGL context" });
}

// Hazard: a device that cannot draw into float textures cannot build levels.
TEST(CullerErrors, NoFloatTexturesOnTheDevice)
{
  ComparisonOptions options;
  options.Backend = vtkNBufferCuller::OpenGL;
  options.Tuning.AllowFloatTextures = false;
  Scenes::ExpectFailure(Scenes::BuildWall, options, Decision::NoFloatTextures,
    { "Float textures are switched off", "use the CPU back-end" });
}

// Hazard: the host builds without float textures, but samples can only be reduced on the device.
TEST(CullerErrors, NoFloatTexturesAndMultiSamples)
{
  if (!HasSamples(4))
  {
    GTEST_SKIP() << "no framebuffer of 4 samples here";
  }
  ComparisonOptions options;
  options.MultiSamples = 4;
  options.Tuning.AllowFloatTextures = false;
  Scenes::ExpectFailure(Scenes::BuildWall, options, Decision::NoFloatTextures,
    { "Float textures are switched off", "without multisampling" });
}

// Hazard: with the setting Auto, a feature that only one back-end needs is missing, and nothing is
// culled.
TEST(CullerErrors, AutoDoesWithoutFloatTextures)
{
  ComparisonOptions options;
  options.Tuning.AllowFloatTextures = false;
  Comparison comparison(Scenes::BuildWall, options);
  comparison.GetCuller()->SetBackend(vtkNBufferCuller::Auto);
  Scenes::Settle(comparison);
  EXPECT_GE(comparison.GetHidden(), Scenes::Wall::Hidden);
  EXPECT_EQ(comparison.GetStatistics().FailedFrames, 0);
  EXPECT_EQ(comparison.GetCuller()->GetBackendInUse(), vtkNBufferCuller::CPU);
}

// Hazard: the application draws into a framebuffer whose samples OpenGL lets nobody read.
TEST(CullerErrors, MultisampledRenderbuffer)
{
  if (!HasSamples(4))
  {
    GTEST_SKIP() << "no framebuffer of 4 samples here";
  }
  Scenes::ExpectFailure(WithOwnFramebuffer(4, true), ComparisonOptions(), Decision::NoDepth,
    { "Multisampled depth in a renderbuffer", "SetMultiSamples(0)" });
}

// Hazard: the application draws into a framebuffer that has no depth at all.
TEST(CullerErrors, NoDepthBuffer)
{
  Scenes::ExpectFailure(WithOwnFramebuffer(0, false), ComparisonOptions(), Decision::NoDepth,
    { "has no depth buffer", "Attach one" });
}

// The counterpart of the two above: a framebuffer of the application's own that can be read.
TEST(CullerErrors, OwnFramebufferWithReadableDepth)
{
  Comparison comparison(WithOwnFramebuffer(0, true));
  Scenes::Settle(comparison);
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  EXPECT_GE(comparison.GetHidden(), Scenes::Wall::Hidden);
}

// Hazard: the cause of a failure is gone, and the culler still does not test.
TEST(CullerErrors, CullsAgainAfterAFailure)
{
  ComparisonOptions options;
  options.KeepMessages = true;
  options.Backend = vtkNBufferCuller::OpenGL;
  options.Tuning.AllowFloatTextures = false;
  Comparison comparison(Scenes::BuildWall, options);
  comparison.Frame("fails");
  EXPECT_EQ(comparison.GetDecision(), Decision::NoFloatTextures);
  Tune(comparison.GetCuller(), &vtkNBufferTuning::AllowFloatTextures, true);
  Scenes::Settle(comparison);
  EXPECT_GE(comparison.GetHidden(), Scenes::Wall::Hidden);
  EXPECT_EQ(comparison.GetStatistics().FailedFrames, 1);
}
