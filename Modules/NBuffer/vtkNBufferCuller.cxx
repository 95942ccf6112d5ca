// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCuller.h"

#include "vtkNBufferBackend.h"
#include "vtkNBufferCompatibility.h"
#include "vtkNBufferDepthExchange.h"
#include "vtkNBufferDrawPass.h"
#include "vtkNBufferFrameGuard.h"
#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferLargeProps.h"
#include "vtkNBufferView.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <typeinfo>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferCuller);

/**
 * The views of a culler, one for each eye of each renderer. The views of a window share a back-end.
 * When a new view is made, those of deleted renderers and windows are deleted.
 */
class vtkNBufferCuller::Internals
{
public:
  struct Detach
  {
    void operator()(vtkNBufferFrameGuard* guard) const
    {
      guard->Detach();
      guard->Delete();
    }
  };
  struct ViewEntry
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkRenderWindow> Window;
    int Eye = 0;
    std::unique_ptr<vtkNBufferView> View;
    /// This is no vtkWeakPointer, because VTK 9.1 does not reset weak pointers to a vtkCommand when
    /// the command is deleted.
    std::unique_ptr<vtkNBufferFrameGuard, Detach> Guard;
  };

  ViewEntry& GetView(vtkRenderer* renderer)
  {
    vtkRenderWindow* window = renderer->GetRenderWindow();
    const int eye = window && window->GetStereoRender() && renderer->GetActiveCamera()
      ? renderer->GetActiveCamera()->GetLeftEye()
      : 1;
    for (std::size_t i = 0; i < this->Views.size(); ++i)
    {
      ViewEntry& entry = this->Views[i];
      if (entry.Renderer == renderer && entry.Window == window && entry.Eye == eye)
      {
        this->Last = i;
        return entry;
      }
    }
    const auto other = std::find_if(this->Views.begin(), this->Views.end(),
      [window](const ViewEntry& entry) { return entry.Window == window; });
    auto backend = other != this->Views.end() ? other->View->GetBackend()
                                              : std::make_shared<vtkNBufferBackend>();
    this->DropDeleted();
    this->Last = this->Views.size();
    this->Views.push_back(
      { renderer, window, eye, std::make_unique<vtkNBufferView>(std::move(backend)),
        decltype(ViewEntry::Guard)(vtkNBufferFrameGuard::New()) });
    this->Views.back().Guard->Attach(renderer);
    return this->Views.back();
  }

  vtkNBufferView* FindView(vtkRenderer* renderer) const
  {
    if (!renderer)
    {
      return this->Last < this->Views.size() ? this->Views[this->Last].View.get() : nullptr;
    }
    vtkNBufferView* found = nullptr;
    for (std::size_t i = 0; i < this->Views.size(); ++i)
    {
      if (this->Views[i].Renderer == renderer && (!found || i == this->Last))
      {
        found = this->Views[i].View.get();
      }
    }
    return found;
  }

private:
  void DropDeleted()
  {
    const auto isViewDeleted = [](const ViewEntry& entry) {
      return !entry.Renderer || !entry.Window || entry.Renderer->GetRenderWindow() != entry.Window;
    };
    this->Views.erase(
      std::remove_if(this->Views.begin(), this->Views.end(), isViewDeleted), this->Views.end());
  }

  std::vector<ViewEntry> Views;
  std::size_t Last = 0;
};

namespace
{
static_assert(int(vtkNBufferCuller::Auto) == int(vtkNBufferBackend::Auto) &&
    int(vtkNBufferCuller::OpenGL) == int(vtkNBufferBackend::OpenGL) &&
    int(vtkNBufferCuller::CPU) == int(vtkNBufferBackend::CPU),
  "the setting is cast to the enumeration of the private class");

void AddKnownClass(vtkNBufferKnownClasses::List list, const char* className)
{
  if (!vtkNBufferKnownClasses::Add(list, className))
  {
    vtkErrorWithObjectMacro(nullptr,
      "vtkNBufferCuller: a class to be known has no name; give what its GetClassName() returns.");
  }
}
}

vtkNBufferCuller::vtkNBufferCuller()
  : Implementation(new Internals)
{
}

vtkNBufferCuller::~vtkNBufferCuller() = default;

void vtkNBufferCuller::SetTuning(const vtkNBufferTuning& tuning)
{
  const std::string fault = tuning.FindFault();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << "; the tuning stays as it was.");
    return;
  }
  if (!(tuning == this->Tuning))
  {
    this->Tuning = tuning;
    this->Modified();
  }
}

void vtkNBufferCuller::SetDepthExchange(vtkNBufferDepthExchange* exchange)
{
  if (exchange != this->DepthExchange)
  {
    this->DepthExchange = exchange;
    this->Modified();
  }
}

vtkNBufferDepthExchange* vtkNBufferCuller::GetDepthExchange() const
{
  return this->DepthExchange;
}

void vtkNBufferCuller::AddKnownPass(const char* className)
{
  AddKnownClass(vtkNBufferKnownClasses::Passes, className);
}

void vtkNBufferCuller::AddKnownMapper(const char* className)
{
  AddKnownClass(vtkNBufferKnownClasses::Mappers, className);
}

void vtkNBufferCuller::AddKnownActor(const char* className)
{
  AddKnownClass(vtkNBufferKnownClasses::Actors, className);
}

double vtkNBufferCuller::Cull(
  vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized)
{
  Internals::ViewEntry& entry = this->Implementation->GetView(renderer);
  vtkNBufferView& view = *entry.View;
  vtkNBufferDecision obstacle = this->Enabled
    ? vtkNBufferCompatibility::WhyNot(renderer, this, propList, listLength)
    : vtkNBufferDecision::Disabled;
  // This comes before the props are counted. A default frustum culler in front of this one may have
  // left only a few of many props, and it takes its time in each frame until it is moved.
  if (obstacle == vtkNBufferDecision::None && this->Tuning.TakeOverFrustumCulling)
  {
    vtkNBufferCompatibility::MoveFrustumCullersBehind(renderer->GetCullers(), this);
  }
  vtkNBufferSettings settings = { this->Tuning, nullptr,
    static_cast<vtkNBufferBackend::Kind>(this->Backend), this->TestSlivers, this->DivideProps,
    this->Freeze };
  if (obstacle == vtkNBufferDecision::None && this->DepthExchange &&
    vtkNBufferCompatibility::CanShareDepth(renderer))
  {
    settings.Share(this->DepthExchange->GetSharedDepth(renderer));
  }
  const auto isLarge = [this](vtkProp* prop)
  { return vtkNBufferLargeProps::IsLarge(prop, this->Tuning.MinimumNumberOfPrimitives); };
  if (obstacle == vtkNBufferDecision::None && listLength < settings.MinimumNumberOfCandidates &&
    !(this->DivideProps && std::any_of(propList, propList + listLength, isLarge)))
  {
    obstacle = vtkNBufferDecision::FewCandidates;
  }
  if (obstacle != vtkNBufferDecision::None)
  {
    view.StepAside(obstacle, propList, listLength);
    vtkNBufferDrawPass::Follow(renderer->GetRenderWindow(), propList, listLength);
    settings.ReportUntested(view.GetStatistics());
    if (obstacle == vtkNBufferDecision::NoContext)
    {
      view.Fail(renderer, obstacle,
        "The render window has no OpenGL context. Use a window of VTK::RenderingOpenGL2, with the "
        "context made.");
    }
    double total = 0.0;
    for (int i = 0; i < listLength; ++i)
    {
      total += initialized ? propList[i]->GetRenderTimeMultiplier() : 1.0;
    }
    return total;
  }
  entry.Guard->BeginFrame(this);
  const double total = view.Cull(renderer, propList, listLength, initialized, settings);
  settings.ReportUntested(view.GetStatistics());
  return total;
}

vtkNBufferVerdict vtkNBufferCuller::GetVerdict(vtkProp* prop, vtkRenderer* renderer) const
{
  vtkNBufferView* view = this->Implementation->FindView(renderer);
  return view ? view->GetVerdict(prop, {}) : vtkNBufferVerdict::Unknown;
}

vtkNBufferVerdict vtkNBufferCuller::GetVerdict(vtkProp* prop, int part, vtkRenderer* renderer) const
{
  vtkNBufferView* view = this->Implementation->FindView(renderer);
  return view ? view->GetVerdict(prop, part) : vtkNBufferVerdict::Unknown;
}

bool vtkNBufferCuller::GetVisiblePixels(vtkProp* prop, int pixels[4], vtkRenderer* renderer) const
{
  vtkNBufferView* view = this->Implementation->FindView(renderer);
  vtkNBufferRectangle found;
  const bool isFound = view && view->GetVisiblePixels(prop, found);
  pixels[0] = found.X0;
  pixels[1] = found.Y0;
  pixels[2] = found.X1;
  pixels[3] = found.Y1;
  return isFound;
}

const vtkNBufferStatistics& vtkNBufferCuller::GetStatistics(vtkRenderer* renderer) const
{
  static const vtkNBufferStatistics none;
  const vtkNBufferView* view = this->Implementation->FindView(renderer);
  return view ? view->GetStatistics() : none;
}

bool vtkNBufferCuller::PreservesImage() const
{
  return !this->Freeze && typeid(*this) == typeid(vtkNBufferCuller);
}

int vtkNBufferCuller::GetBackendInUse() const
{
  const vtkNBufferView* view = this->Implementation->FindView(nullptr);
  return view ? view->GetBackend()->GetInUse() : vtkNBufferBackend::Auto;
}

const char* vtkNBufferCuller::GetBackendReason() const
{
  const vtkNBufferView* view = this->Implementation->FindView(nullptr);
  return view ? view->GetBackend()->GetReason().c_str() : "nothing built yet";
}

void vtkNBufferCuller::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << this->Enabled << "\n";
  os << indent << "Backend: " << this->Backend << " (in use: " << this->GetBackendInUse() << ", "
     << this->GetBackendReason() << ")\n";
  os << indent << "TestSlivers: " << this->TestSlivers << "\n";
  os << indent << "DivideProps: " << this->DivideProps << "\n";
  os << indent << "Freeze: " << this->Freeze << "\n";
  os << indent << "DepthExchange: " << this->DepthExchange << "\n";
  this->Tuning.PrintSelf(os, indent);
  os << indent << "Statistics: " << this->GetStatisticsAsJSON() << "\n";
}
VTK_ABI_NAMESPACE_END
