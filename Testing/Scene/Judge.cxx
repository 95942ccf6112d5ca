// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Judge.h"

#include "GLErrors.h"
#include "Messages.h"
#include "StatisticsCheck.h"
#include "Tune.h"
#include "vtkNBufferGL.h"

#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace TestScene
{
Picture TakePicture(vtkRenderWindow* window, bool withDepth, PictureSource source)
{
  Picture picture;
  std::copy_n(window->GetActualSize(), 2, picture.Size);
  const int right = picture.Size[0] - 1;
  const int top = picture.Size[1] - 1;
  vtkNew<vtkUnsignedCharArray> colors;
  window->GetRGBACharPixelData(0, 0, right, top, source == PictureSource::Shown, colors);
  picture.Colors.assign(colors->GetPointer(0), colors->GetPointer(0) + colors->GetNumberOfValues());
  if (withDepth)
  {
    vtkNew<vtkFloatArray> depths;
    window->GetZbufferData(0, 0, right, top, depths);
    picture.Depths.assign(
      depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues());
  }
  return picture;
}

namespace
{
/// Compare `values` numbers of each pixel, which may differ by `tolerance`.
template <typename T>
void Compare(const char* what, const Picture& shape, const int region[4],
  const std::vector<T>& expected, const std::vector<T>& actual, std::size_t values, int tolerance,
  std::ostream& faults)
{
  const auto isClose = [tolerance](T x, T y) { return std::abs(x - y) <= tolerance; };
  const std::size_t width = static_cast<std::size_t>(shape.Size[0]);
  std::size_t differing = 0;
  std::size_t first = 0;
  for (int y = region[1]; y < region[1] + region[3]; ++y)
  {
    const std::size_t begin = y * width + region[0];
    const T* a = &expected[values * begin];
    const T* b = &actual[values * begin];
    if (std::memcmp(a, b, sizeof(T) * values * region[2]) == 0)
    {
      continue;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(region[2]); ++i)
    {
      const std::size_t k = values * i;
      const bool same = tolerance == 0 ? std::memcmp(a + k, b + k, sizeof(T) * values) == 0
                                       : std::equal(a + k, a + k + values, b + k, isClose);
      if (!same && differing++ == 0)
      {
        first = begin + i;
      }
    }
  }
  if (differing == 0)
  {
    return;
  }
  faults << what << " differs in " << differing << " of " << region[2] * region[3]
         << " pixels, first in (" << first % width << ", " << first / width << "):";
  for (const std::vector<T>* image : { &expected, &actual })
  {
    for (std::size_t i = 0; i < values; ++i)
    {
      faults << ' ' << +(*image)[values * first + i];
    }
    faults << (image == &expected ? " expected," : " drawn\n");
  }
}
}

std::vector<std::array<double, 2>> GetSamplePlaces(vtkRenderWindow* window)
{
  auto* openGLWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  window->MakeCurrent();
  openGLWindow->GetState()->PushFramebufferBindings();
  openGLWindow->GetRenderFramebuffer()->Bind();
  const vtkNBufferGL::SamplePlaces places = vtkNBufferGL::GetSamplePlaces();
  openGLWindow->GetState()->PopFramebufferBindings();
  return places;
}

std::string FindDifference(
  const Picture& expected, const Picture& actual, const int region[4], int tolerance)
{
  const std::size_t count = static_cast<std::size_t>(expected.Size[0]) * expected.Size[1];
  if (!std::equal(expected.Size, expected.Size + 2, actual.Size) ||
    expected.Colors.size() != 4 * count || actual.Colors.size() != 4 * count)
  {
    return "The windows have different sizes.\n";
  }
  const int all[4] = { 0, 0, expected.Size[0], expected.Size[1] };
  const int* part = region ? region : all;
  std::ostringstream faults;
  Compare("The image", expected, part, expected.Colors, actual.Colors, 4, tolerance, faults);
  if (expected.Depths.size() == count && actual.Depths.size() == count)
  {
    Compare("The depth", expected, part, expected.Depths, actual.Depths, 1, 0, faults);
  }
  return faults.str();
}

void PrintTo(const Selected& selected, std::ostream* os)
{
  *os << selected.Pixels << " pixels, " << selected.Elements.size() << " elements";
}

Selection Select(const Stage& stage, const int area[4], int field)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.GetRenderer());
  selector->SetFieldAssociation(field);
  selector->SetArea(area[0], area[1], area[2], area[3]);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  Selection result;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    Selected& found = result[stage.FindIndex(node->GetProperties()->Get(vtkSelectionNode::PROP()))];
    found.Pixels += node->GetProperties()->Get(vtkSelectionNode::PIXEL_COUNT());
    vtkDataArray* elements = vtkDataArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; elements && k < elements->GetNumberOfTuples(); ++k)
    {
      found.Elements.push_back(static_cast<vtkIdType>(elements->GetTuple1(k)));
    }
  }
  return result;
}

FrameErrors RenderFrame(Stage& stage)
{
  stage.ResetDraws();
  // Before the first frame there may be no context.
  if (!stage.Window->GetNeverRendered())
  {
    stage.MakeCurrent();
    CollectGLErrors();
  }
  stage.Window->Render();
  stage.MakeCurrent();
  FrameErrors errors;
  errors.GL = TakeGLErrors(&errors.IsPending);
  errors.VTK = TakeMessages();
  return errors;
}

namespace
{
/// Pixels are compared where the levels do not hide a box. Statistics tell of such boxes, except
/// for those of translucent props, which are tested last.
bool MayReadPixels(vtkNBufferCuller* culler, vtkRenderer* renderer)
{
  const auto isTranslucent = [renderer]
  {
    vtkPropCollection* props = renderer->GetViewProps();
    vtkCollectionSimpleIterator cookie;
    props->InitTraversal(cookie);
    while (vtkProp* prop = props->GetNextProp(cookie))
    {
      if (prop->HasTranslucentPolygonalGeometry())
      {
        return true;
      }
    }
    return false;
  };
  return culler->GetTuning().TestPixels &&
    (culler->GetStatistics(renderer).PassedCoarseTest > 0 || isTranslucent());
}
}

std::string FindInconsistency(const Stage& stage)
{
  std::string faults;
  for (int i = 0; i < stage.GetNumberOfRenderers(); ++i)
  {
    if (vtkNBufferCuller* culler = stage.GetCuller(i))
    {
      vtkRenderer* renderer = stage.GetRenderer(i);
      // A pass that draws the opaque props twice may add a round.
      const int rounds = culler->GetTuning().MaximumNumberOfRounds + (renderer->GetPass() ? 1 : 0);
      faults += ::FindInconsistency(
        culler->GetStatistics(renderer), rounds, MayReadPixels(culler, renderer));
    }
  }
  return faults;
}

std::string FindWrongDraws(
  const Stage& reference, const Stage& tested, MustBeDrawn which, bool exactly)
{
  int redrawn = 0;
  for (int i = 0; i < tested.GetNumberOfRenderers(); ++i)
  {
    if (vtkNBufferCuller* culler = tested.GetCuller(i))
    {
      const vtkNBufferStatistics& statistics = culler->GetStatistics(tested.GetRenderer(i));
      redrawn += statistics.Redrawn + statistics.FreshDraws + statistics.TieQueries;
      // In a view that draws twice what was hidden the first time makes up for some of the extra
      // draws of the second.
      exactly = exactly && (i > 0 || statistics.Decision != vtkNBufferDecision::OtherView);
    }
  }
  vtkNBufferCuller* culler = tested.GetCuller();
  int extra = 0;
  std::ostringstream wrong;
  for (int i = 0; i < static_cast<int>(tested.Props.size()); ++i)
  {
    if (!tested.AreDrawsCounted(i))
    {
      exactly = false;
      continue;
    }
    const int expected = reference.GetDraws(i);
    const int drawn = tested.GetDraws(i);
    extra += std::max(drawn - expected, 0);
    if (tested.GetNumberOfRenderers() > 1 || !culler)
    {
      continue; // a prop may be in several renderers
    }
    const vtkNBufferVerdict verdict = culler->GetVerdict(tested.Props[i], tested.GetRenderer());
    const bool culled =
      verdict == vtkNBufferVerdict::Hidden || verdict == vtkNBufferVerdict::Outside;
    const bool wanted = which == MustBeDrawn::Tested
      ? verdict == vtkNBufferVerdict::Visible || verdict == vtkNBufferVerdict::NearPlane
      : which == MustBeDrawn::NotCulled && !culled;
    if ((culled && drawn > 0) || (wanted && drawn < expected))
    {
      wrong << "Prop " << i << " is " << vtkNBufferStatistics::GetName(verdict) << " and was drawn "
            << drawn << " times, " << expected << " in the reference.\n";
    }
  }
  if (extra > redrawn || (exactly && extra != redrawn))
  {
    wrong << extra << " draws beyond those of the reference, " << redrawn << " counted.\n";
  }
  return wrong.str();
}
}
