// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CullerTest.h"
#include "TestedBackend.h"

#include "vtkCullerCollection.h"
#include "vtkPNGWriter.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace
{
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

void PrintStatistics(const Stage& culled, const std::string& frame)
{
  if (std::getenv("VTKNBUFFER_TEST_VERBOSE") && culled.Culler)
  {
    std::cout << frame << ": " << culled.Culler->GetStatistics(culled.GetRenderer()).GetAsJSON()
              << std::endl;
  }
}

void WritePictures(const Stage& reference, const Stage& culled, const std::string& frame)
{
  if (const char* folder = std::getenv("VTKNBUFFER_TEST_OUTPUT"))
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string file = std::string(info->test_suite_name()) + "." + info->name() + "." + frame;
    std::replace_if(
      file.begin(), file.end(), [](char c) { return c == '/' || c == ' '; }, '_');
    WriteImage(reference.Window, std::string(folder) + "/" + file + ".expected.png");
    WriteImage(culled.Window, std::string(folder) + "/" + file + ".culled.png");
  }
}

//------------------------------------------------------------------------------------------------
Comparison::Comparison(const Change& build, const ComparisonOptions& options)
  : Options(options)
{
  TakeMessages();
  for (Stage* stage : { &this->Reference, &this->Culled })
  {
    *stage = Stage(options.Width, options.Height, options.MultiSamples);
    if (stage == &this->Culled)
    {
      stage->Culler = vtkSmartPointer<vtkNBufferCuller>::New();
      stage->Culler->SetBackend(GetTestedBackend(options.Backend));
      stage->Culler->SetTuning(options.Tuning);
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
  this->CheckMessages(TakeMessages());
  EXPECT_TRUE(this->HasShown || this->Frames == 0 || this->Options.MayBeOfOneColor)
    << "all pictures of this test are of one color";
}

void Comparison::AddCuller()
{
  for (vtkRenderer* renderer : this->Culled.Renderers)
  {
    if (!this->Options.KeepDefaultCuller)
    {
      renderer->GetCullers()->RemoveAllItems();
    }
    renderer->AddCuller(this->Culled.Culler);
  }
}

void Comparison::Both(const Change& change)
{
  change(this->Reference);
  change(this->Culled);
}

void Comparison::Frame(const std::string& what, const Change& change)
{
  if (change)
  {
    this->Both(change);
  }
  const std::string name = "frame " + std::to_string(this->Frames++) + " " + what;
  SCOPED_TRACE(name);
  const TestScene::FrameErrors expected = TestScene::RenderFrame(this->Reference);
  const TestScene::FrameErrors found = TestScene::RenderFrame(this->Culled);
  if (!this->Options.ReadRendered)
  {
    // Else there might be nothing in the image to compare.
    EXPECT_EQ(expected.GL, "") << "VTK alone";
  }
  if (expected.GL.empty())
  {
    EXPECT_EQ(found.GL, "");
  }
  PrintStatistics(this->Culled, name);
  this->CompareImages(name);
  EXPECT_EQ(TestScene::FindInconsistency(this->Culled), "");
  if (this->Options.CompareDraws)
  {
    EXPECT_EQ(TestScene::FindWrongDraws(
                this->Reference, this->Culled, TestScene::MustBeDrawn::Tested, true),
      "");
  }
  this->CheckMessages(expected.VTK + found.VTK + TakeMessages());
}

void Comparison::CheckMessages(const std::string& messages)
{
  if (this->Options.KeepMessages)
  {
    this->Messages += messages;
    return;
  }
  EXPECT_EQ(messages, "") << "errors or warnings of VTK";
}

void Comparison::CompareImages(const std::string& frame)
{
  using TestScene::PictureSource;
  const PictureSource source =
    this->Options.ReadRendered ? PictureSource::Rendered : PictureSource::Shown;
  const bool withDepth = this->Options.CompareDepth;
  const TestScene::Picture expected =
    TestScene::TakePicture(this->Reference.Window, withDepth, source);
  const TestScene::Picture actual = TestScene::TakePicture(this->Culled.Window, withDepth, source);
  for (std::size_t pixel = 1; pixel < expected.Colors.size() / 4 && !this->HasShown; ++pixel)
  {
    const unsigned char* first = expected.GetColor(0);
    this->HasShown = !std::equal(first, first + 4, expected.GetColor(pixel));
  }
  const std::string difference = TestScene::FindDifference(expected, actual);
  if (!difference.empty())
  {
    ADD_FAILURE() << difference
                  << (this->Culled.Culler ? this->Culled.Culler->GetStatisticsAsJSON() : "");
    WritePictures(this->Reference, this->Culled, frame);
  }
}
