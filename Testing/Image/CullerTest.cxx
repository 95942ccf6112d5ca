// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CullerTest.h"

#include "Tune.h"
#include "vtkNBufferGL.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCullerCollection.h"
#include "vtkFloatArray.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersion.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <numeric>
#include <sstream>

namespace
{
void CountDraw(vtkObject*, unsigned long, void* counter, void*)
{
  ++*static_cast<int*>(counter);
}

void WriteImage(vtkRenderWindow* window, const std::string& name)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetShouldRerender(false);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputConnection(grab->GetOutputPort());
  writer->Write();
}
}

void PrintTo(vtkNBufferVerdict verdict, std::ostream* os)
{
  *os << vtkNBufferStatistics::GetName(verdict);
}

void PrintTo(vtkNBufferDecision decision, std::ostream* os)
{
  *os << vtkNBufferStatistics::GetName(decision);
}

testing::AssertionResult DidNoWork(const vtkNBufferStatistics& statistics)
{
  if (statistics.Levels || statistics.Texels || statistics.Queries || statistics.Lookups ||
    statistics.ReadBacks || statistics.BytesRead || statistics.Tested)
  {
    return testing::AssertionFailure() << "N-buffer work was done: " << statistics.GetAsJSON();
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------------------------
vtkActor* Stage::GetActor(int index) const
{
  return vtkActor::SafeDownCast(this->Props[index]);
}

vtkRenderer* Stage::AddRenderer(double x0, double y0, double x1, double y1, int layer)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetViewport(x0, y0, x1, y1);
  renderer->SetLayer(layer);
  this->Window->AddRenderer(renderer);
  this->Renderers.emplace_back(renderer);
  return renderer;
}

void Stage::Add(vtkProp* prop, vtkRenderer* renderer)
{
  (renderer ? renderer : this->GetRenderer())->AddViewProp(prop);
  this->Props.emplace_back(prop);
  this->Draws.emplace_back(std::make_shared<int>(0));
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    this->CountDraws(actor);
  }
}

vtkActor* Stage::AddActor(vtkPolyData* data, const double color[3], vtkRenderer* renderer)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  this->Add(actor, renderer);
  return actor;
}

bool Stage::AreDrawsCounted(int prop) const
{
  // Others draw by mappers of their own, or announce updates of their pipeline by the same event
  // (composite mappers when they are asked for translucent geometry, drawn or not).
  vtkActor* actor = this->GetActor(prop);
  return actor && actor->GetMapper() && actor->GetMapper()->IsA("vtkOpenGLPolyDataMapper") &&
    !actor->GetMapper()->IsA("vtkCompositePolyDataMapper") &&
    !actor->GetMapper()->IsA("vtkCompositePolyDataMapper2");
}

void Stage::CountDraws(vtkActor* actor)
{
  const auto found = std::find(this->Props.begin(), this->Props.end(), actor);
  if (found == this->Props.end() || !actor->GetMapper())
  {
    return;
  }
  // Polydata mappers announce every piece they draw by a StartEvent.
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(CountDraw);
  observer->SetClientData(this->Draws[found - this->Props.begin()].get());
  actor->GetMapper()->AddObserver(vtkCommand::StartEvent, observer);
}

void Stage::ResetDraws()
{
  for (const auto& draws : this->Draws)
  {
    *draws = 0;
  }
}

//------------------------------------------------------------------------------------------------
Comparison::Comparison(const Change& build, const ComparisonOptions& options)
  : Options(options)
{
  TakeMessages();
  // The control experiment: what differs without the culler on either side is a fault of the test
  // ("stock": stock VTK on both sides; anything else: no culler against stock VTK).
  if (const char* control = std::getenv("VTKNBUFFER_TEST_CONTROL"))
  {
    this->Options.StockReference =
      options.StockReference || (options.KeepDefaultCuller && std::strcmp(control, "stock") == 0);
    this->Options.Control = true;
  }
  for (Stage* stage : { &this->Reference, &this->Culled })
  {
    stage->Window = vtkSmartPointer<vtkRenderWindow>::New();
    stage->Window->SetOffScreenRendering(1);
    stage->Window->SetMultiSamples(options.MultiSamples);
    stage->Window->SetSize(options.Width, options.Height);
    stage->AddRenderer(0.0, 0.0, 1.0, 1.0);
    if (stage == &this->Culled)
    {
      stage->Culler = vtkSmartPointer<vtkNBufferCuller>::New();
      if (options.RoundSize > 0)
      {
        Tune(stage->Culler, &vtkNBufferTuning::RoundSize, options.RoundSize);
      }
      Tune(stage->Culler, &vtkNBufferTuning::BackOff, options.BackOff);
      if (options.Configure)
      {
        options.Configure(stage->Culler);
      }
    }
    build(*stage);
  }
  for (vtkRenderer* renderer : this->Reference.Renderers)
  {
    if (!this->Options.StockReference)
    {
      renderer->GetCullers()->RemoveAllItems();
    }
  }
  if (options.AddCuller)
  {
    this->AddCuller();
  }
}

Comparison::~Comparison()
{
  this->CheckMessages();
}

void Comparison::AddCuller()
{
  for (vtkRenderer* renderer : this->Culled.Renderers)
  {
    if (!this->Options.KeepDefaultCuller)
    {
      renderer->GetCullers()->RemoveAllItems();
    }
    if (!this->Options.Control)
    {
      renderer->AddCuller(this->Culled.Culler);
    }
  }
}

void Comparison::Both(const Change& change)
{
  change(this->Reference);
  change(this->Culled);
}

void Comparison::Frame(const std::string& what)
{
  const std::string name = "frame " + std::to_string(this->Frames++) + " " + what;
  SCOPED_TRACE(name);
  GLenum errors[2] = { GL_NO_ERROR, GL_NO_ERROR };
  for (Stage* stage : { &this->Reference, &this->Culled })
  {
    stage->ResetDraws();
    stage->Window->Render();
    stage->Window->MakeCurrent();
    errors[stage == &this->Culled] = glGetError();
  }
  if (!this->Options.ReadRendered)
  {
    // Else there might be nothing in the image to compare.
    EXPECT_EQ(errors[0], GL_NO_ERROR) << "VTK alone";
  }
  EXPECT_TRUE(errors[1] == GL_NO_ERROR || errors[0] != GL_NO_ERROR)
    << "OpenGL error 0x" << std::hex << errors[1] << std::dec;
  if (std::getenv("VTKNBUFFER_TEST_VERBOSE") && this->Culled.Culler)
  {
    std::cout << name << ": " << this->GetStatistics().GetAsJSON() << std::endl;
  }
  this->ComparePixels(name);
  this->CheckStatistics();
  if (this->Options.CompareDraws)
  {
    this->CheckDraws();
  }
  this->CheckMessages();
}

void Comparison::CheckMessages()
{
  const std::string messages = TakeMessages();
  if (this->Options.KeepMessages)
  {
    this->Messages += messages;
    return;
  }
  EXPECT_EQ(messages, "") << "errors or warnings of VTK";
}

void Comparison::ComparePixels(const std::string& what)
{
  const int* size = this->Reference.Window->GetActualSize();
  ASSERT_EQ(size[0], this->Culled.Window->GetActualSize()[0]);
  ASSERT_EQ(size[1], this->Culled.Window->GetActualSize()[1]);
  const auto read = [this, size](
                      const Stage& stage, vtkUnsignedCharArray* pixels, vtkFloatArray* depth)
  {
    stage.Window->GetRGBACharPixelData(
      0, 0, size[0] - 1, size[1] - 1, this->Options.ReadRendered ? 0 : 1, pixels);
    if (depth)
    {
      stage.Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depth);
    }
  };
  vtkNew<vtkUnsignedCharArray> pixels[2];
  vtkNew<vtkFloatArray> depths[2];
  const bool compareDepth = this->Options.CompareDepth;
  read(this->Reference, pixels[0], compareDepth ? depths[0].Get() : nullptr);
  read(this->Culled, pixels[1], compareDepth ? depths[1].Get() : nullptr);
  const vtkIdType bytes = 4 * static_cast<vtkIdType>(size[0]) * size[1];
  ASSERT_EQ(pixels[0]->GetNumberOfValues(), bytes);
  ASSERT_EQ(pixels[1]->GetNumberOfValues(), bytes);
  const unsigned char* a = pixels[0]->GetPointer(0);
  const unsigned char* b = pixels[1]->GetPointer(0);
  if (std::memcmp(a, b, bytes) != 0)
  {
    vtkIdType differing = 0;
    vtkIdType first = -1;
    for (vtkIdType i = 0; i < bytes; ++i)
    {
      if (a[i] != b[i])
      {
        ++differing;
        first = first < 0 ? i / 4 : first;
      }
    }
    ADD_FAILURE() << differing << " bytes differ, first in pixel (" << first % size[0] << ", "
                  << first / size[0] << ") of " << size[0] << " x " << size[1] << "\n"
                  << (this->Culled.Culler ? this->Culled.Culler->GetStatisticsAsJSON() : "");
    // Pictures for the eye, where somebody asks for them.
    if (const char* folder = std::getenv("VTKNBUFFER_TEST_OUTPUT"))
    {
      const auto* info = testing::UnitTest::GetInstance()->current_test_info();
      std::string file = std::string(info->test_suite_name()) + "." + info->name() + "." + what;
      std::replace_if(
        file.begin(), file.end(), [](char c) { return c == '/' || c == ' '; }, '_');
      WriteImage(this->Reference.Window, std::string(folder) + "/" + file + ".expected.png");
      WriteImage(this->Culled.Window, std::string(folder) + "/" + file + ".culled.png");
    }
  }
  if (compareDepth && depths[0]->GetNumberOfValues() == depths[1]->GetNumberOfValues())
  {
    const vtkIdType count = depths[0]->GetNumberOfValues();
    const float* c = depths[0]->GetPointer(0);
    const float* d = depths[1]->GetPointer(0);
    const vtkIdType at = std::mismatch(c, c + count, d).first - c;
    EXPECT_EQ(at, count) << "depth differs first in pixel (" << at % size[0] << ", " << at / size[0]
                         << ")";
  }
}

void Comparison::CheckStatistics()
{
  if (!this->Culled.Culler)
  {
    return;
  }
  for (vtkRenderer* renderer : this->Culled.Renderers)
  {
    if (!renderer->GetCullers()->IsItemPresent(this->Culled.Culler))
    {
      continue;
    }
    const vtkNBufferStatistics& s = this->Culled.Culler->GetStatistics(renderer);
    SCOPED_TRACE(s.GetAsJSON());
    EXPECT_EQ(std::accumulate(s.Verdicts.begin(), s.Verdicts.end(), 0), s.Props);
    for (int count : s.Verdicts)
    {
      EXPECT_GE(count, 0);
    }
    EXPECT_EQ(s.GetCount(vtkNBufferVerdict::Unknown), 0) << "every prop has a verdict";
    EXPECT_LE(s.Rounds, this->Culled.Culler->GetTuning().MaximumNumberOfRounds);
    EXPECT_LE(s.HeldBack, s.Candidates);
    EXPECT_LE(s.Tested, s.Candidates * std::max(s.Rounds, 1));
    EXPECT_LE(s.PassedCoarseTest, s.Tested * std::max(s.Rounds, 1));
    EXPECT_LE(s.Candidates, s.Props);
    if (s.Decision == vtkNBufferDecision::Culled)
    {
      EXPECT_GE(s.Rounds, 1);
      EXPECT_GE(s.ReadBacks, 1);
      EXPECT_LE(s.ReadBacks, s.Rounds);
      EXPECT_GT(s.BytesRead, 0);
      EXPECT_GE(s.Lookups, s.Queries);
      // Pixels looked at for props in doubt count as lookups, too.
      EXPECT_TRUE(s.Lookups <= 4 * s.Queries || s.PassedCoarseTest > 0);
      EXPECT_LE(s.GetCount(vtkNBufferVerdict::Hidden), s.HeldBack);
    }
    else
    {
      // These are found out while the held props are drawn.
      EXPECT_TRUE(DidNoWork(s) || s.Decision >= vtkNBufferDecision::OtherView);
    }
    if (s.Decision > vtkNBufferDecision::BackedOff)
    {
      EXPECT_EQ(s.GetCount(vtkNBufferVerdict::Hidden), 0);
    }
  }
}

void Comparison::CheckDraws()
{
  int redrawn = 0;
  for (vtkRenderer* renderer : this->Culled.Renderers)
  {
    if (renderer->GetCullers()->IsItemPresent(this->Culled.Culler))
    {
      redrawn += this->Culled.Culler->GetStatistics(renderer).Redrawn;
    }
  }
  int extra = 0;
  bool allCounted = true;
  std::ostringstream wrong;
  for (std::size_t i = 0; i < this->Culled.Props.size(); ++i)
  {
    const int index = static_cast<int>(i);
    const int expected = this->Reference.GetDraws(index);
    const int drawn = this->Culled.GetDraws(index);
    if (!this->Culled.AreDrawsCounted(index))
    {
      allCounted = false;
      continue;
    }
    extra += std::max(drawn - expected, 0);
    if (this->Culled.Renderers.size() > 1)
    {
      continue; // a prop may be in several renderers
    }
    const vtkNBufferVerdict verdict = this->GetVerdict(index);
    const bool culled =
      verdict == vtkNBufferVerdict::Hidden || verdict == vtkNBufferVerdict::Outside;
    // Of the others, vtkFrustumCoverageCuller may still remove some.
    const bool tested =
      verdict == vtkNBufferVerdict::Visible || verdict == vtkNBufferVerdict::NearPlane;
    if ((culled && drawn > 0) || (tested && drawn < expected))
    {
      wrong << " " << i << " (" << vtkNBufferStatistics::GetName(verdict) << ", drawn " << drawn
            << ")";
    }
  }
  EXPECT_EQ(wrong.str(), "") << "these props were drawn against their verdict";
  // Draws of other kinds of prop cannot be counted. In a view that draws twice what was hidden the
  // first time makes up for some of the extra draws of the second.
  allCounted = allCounted && this->GetDecision() != vtkNBufferDecision::OtherView;
  EXPECT_LE(extra, redrawn) << "draws beyond one per prop must be counted ones";
  EXPECT_TRUE(extra == redrawn || !allCounted) << extra << " extra draws, counted " << redrawn;
}
