// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NBufferAutoload.cxx
 * @brief A plug-in that gives vtkNBufferCuller to all renderers of a program that is not changed.
 *
 * VTK loads every library in the folders of VTK_AUTOLOAD_PATH before it makes its first object by a
 * factory. This one replaces no class: its factory lets the factories behind it make each window
 * and renderer, of whatever class, and observes it. When a frame begins, a renderer gets a culler
 * of its own if it has none, even if the program has emptied its list of cullers. README.md lists
 * the environment variables.
 */
#include "vtkNBufferCuller.h"

#include "vtkCommand.h"
#include "vtkCullerCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// The value of an environment variable, split at its commas, without blanks around the names.
std::vector<std::string> ReadNames(const char* variable)
{
  std::vector<std::string> names;
  const char* value = std::getenv(variable);
  std::istringstream list(value ? value : "");
  for (std::string name; std::getline(list, name, ',');)
  {
    name.erase(0, name.find_first_not_of(" \t"));
    name.erase(name.find_last_not_of(" \t") + 1);
    if (!name.empty())
    {
      names.push_back(name);
    }
  }
  return names;
}

/// What happened in the frames of one renderer.
struct Record
{
  std::string Renderer;
  std::string Window;
  int Frames = 0;
  int FramesWithoutProps = 0; ///< The renderer calls no culler in these.
  long long Hidden = 0;
  long long Drawn = 0;
  std::map<std::string, int> Decisions;
  vtkNBufferStatistics Last;
};

std::ostream& operator<<(std::ostream& os, const Record& record)
{
  os << "{\"renderer\": \"" << record.Renderer << "\", \"window\": \"" << record.Window
     << "\", \"frames\": " << record.Frames
     << ", \"frames_without_props\": " << record.FramesWithoutProps
     << ", \"hidden\": " << record.Hidden << ", \"drawn\": " << record.Drawn
     << ", \"decisions\": {";
  const char* separator = "";
  for (const auto& [decision, count] : record.Decisions)
  {
    os << separator << '"' << decision << "\": " << count;
    separator = ", ";
  }
  return os << "}, \"last\": " << record.Last.GetAsJSON() << '}';
}

/// Observes all windows and renderers, those of several threads, too.
class Observer : public vtkCommand
{
public:
  /// There is one for the whole program: after vtkObjectFactory::ReHash() another factory goes on
  /// with the records of the first one.
  static Observer* GetInstance()
  {
    static const auto instance = vtkSmartPointer<Observer>::Take(new Observer);
    return instance;
  }
  vtkTypeMacro(Observer, vtkCommand);

  void Execute(vtkObject* caller, unsigned long event, void*) override
  {
    auto* renderer = vtkRenderer::SafeDownCast(caller);
    if (auto* window = vtkRenderWindow::SafeDownCast(caller))
    {
      this->ObserveRenderers(window);
    }
    else if (renderer && event == vtkCommand::StartEvent)
    {
      this->BeginFrame(renderer);
    }
    else if (renderer && event == vtkCommand::EndEvent)
    {
      this->EndFrame(renderer);
    }
    else if (event == vtkCommand::DeleteEvent)
    {
      // Another renderer may be made at its address.
      this->Forget(static_cast<vtkRenderer*>(caller));
    }
  }

  void ObserveRenderer(vtkRenderer* renderer)
  {
    if (!renderer->HasObserver(vtkCommand::StartEvent, this))
    {
      renderer->AddObserver(vtkCommand::StartEvent, this);
      renderer->AddObserver(vtkCommand::EndEvent, this);
      renderer->AddObserver(vtkCommand::DeleteEvent, this);
    }
  }

  void Write(const char* file)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::ofstream os(file);
    os << "{\"vtk\": \"" << vtkVersion::GetVTKVersion() << "\", \"renderers\": [";
    const char* separator = "\n";
    const auto write = [&os, &separator](const Record& record)
    {
      if (record.Frames > 0)
      {
        os << separator << record;
        separator = ",\n";
      }
    };
    std::for_each(this->Finished.begin(), this->Finished.end(), write);
    for (const auto& [renderer, entry] : this->Entries)
    {
      write(entry.Frames);
    }
    os << "]}\n";
    if (!os.flush())
    {
      std::cerr << "nbuffer-autoload: cannot write " << file << " (NBUFFER_REPORT)\n";
    }
  }

private:
  struct Entry
  {
    /// Two threads cannot draw with one culler.
    vtkNew<vtkNBufferCuller> Culler;
    Record Frames;
  };

  /// The entry of a renderer is used by the thread alone that draws the renderer, and stays where
  /// it is while other threads add theirs.
  Entry& GetEntry(vtkRenderer* renderer)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Entries[renderer];
  }

  /// Renderers of classes that no factory makes are found here.
  void ObserveRenderers(vtkRenderWindow* window)
  {
    vtkCollectionSimpleIterator cookie;
    window->GetRenderers()->InitTraversal(cookie);
    while (vtkRenderer* renderer = window->GetRenderers()->GetNextRenderer(cookie))
    {
      this->ObserveRenderer(renderer);
    }
  }

  static vtkNBufferCuller* FindCuller(vtkRenderer* renderer)
  {
    vtkCullerCollection* cullers = renderer->GetCullers();
    vtkCollectionSimpleIterator cookie;
    cullers->InitTraversal(cookie);
    while (vtkCuller* culler = cullers->GetNextCuller(cookie))
    {
      if (auto* found = vtkNBufferCuller::SafeDownCast(culler))
      {
        return found;
      }
    }
    return nullptr;
  }

  void BeginFrame(vtkRenderer* renderer)
  {
    vtkRenderWindow* window = renderer->GetRenderWindow();
    if (!window || !window->IsA("vtkOpenGLRenderWindow"))
    {
      return;
    }
    if (!FindCuller(renderer))
    {
      renderer->AddCuller(this->GetEntry(renderer).Culler);
    }
    // Some passes use the props of the frame in which they were modified, and would use the list of
    // that frame again.
    vtkRenderPass* pass = renderer->GetPass();
    if (pass &&
      std::find(this->Passes.begin(), this->Passes.end(), pass->GetClassName()) !=
        this->Passes.end())
    {
      pass->Modified();
    }
  }

  static bool HasVisibleProps(vtkRenderer* renderer)
  {
    vtkPropCollection* props = renderer->GetViewProps();
    vtkCollectionSimpleIterator cookie;
    props->InitTraversal(cookie);
    while (vtkProp* prop = props->GetNextProp(cookie))
    {
      if (prop->GetVisibility())
      {
        return true;
      }
    }
    return false;
  }

  void EndFrame(vtkRenderer* renderer)
  {
    const vtkNBufferCuller* culler = FindCuller(renderer);
    if (!culler || !renderer->GetRenderWindow())
    {
      return;
    }
    Record& record = this->GetEntry(renderer).Frames;
    record.Renderer = renderer->GetClassName();
    record.Window = renderer->GetRenderWindow()->GetClassName();
    ++record.Frames;
    if (!HasVisibleProps(renderer))
    {
      ++record.FramesWithoutProps;
      return;
    }
    record.Last = culler->GetStatistics(renderer);
    ++record.Decisions[vtkNBufferStatistics::GetName(record.Last.Decision)];
    record.Hidden += record.Last.GetCount(vtkNBufferVerdict::Hidden);
    record.Drawn += record.Last.GetNumberOfPropsDrawn();
  }

  void Forget(vtkRenderer* renderer)
  {
    decltype(this->Entries)::node_type entry; // The culler is deleted after the lock.
    const std::lock_guard<std::mutex> lock(this->Mutex);
    entry = this->Entries.extract(renderer);
    if (entry)
    {
      this->Finished.push_back(entry.mapped().Frames);
    }
  }

  const std::vector<std::string> Passes = ReadNames("NBUFFER_KNOWN_PASSES");
  std::mutex Mutex; ///< For Entries and Finished.
  std::map<vtkRenderer*, Entry> Entries;
  std::vector<Record> Finished; ///< The records of renderers that have been deleted.
};

/// Has windows and renderers made by the factories behind it.
class Factory : public vtkObjectFactory
{
public:
  static Factory* New() { VTK_STANDARD_NEW_BODY(Factory); }
  vtkTypeMacro(Factory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "vtkNBufferCuller for all renderers"; }

protected:
  Factory()
  {
    for (const std::string& name : ReadNames("NBUFFER_KNOWN_PASSES"))
    {
      vtkNBufferCuller::AddKnownPass(name.c_str());
    }
    for (const std::string& name : ReadNames("NBUFFER_KNOWN_MAPPERS"))
    {
      vtkNBufferCuller::AddKnownMapper(name.c_str());
    }
    for (const std::string& name : ReadNames("NBUFFER_KNOWN_ACTORS"))
    {
      vtkNBufferCuller::AddKnownActor(name.c_str());
    }
  }

  ~Factory() override
  {
    if (const char* file = std::getenv("NBUFFER_REPORT"))
    {
      this->Watch->Write(file);
    }
  }

  vtkObject* CreateObject(const char* className) override
  {
    thread_local bool isBusy = false;
    if (isBusy ||
      (std::strcmp(className, "vtkRenderWindow") != 0 &&
        std::strcmp(className, "vtkRenderer") != 0))
    {
      return nullptr;
    }
    isBusy = true;
    vtkObject* object = vtkObjectFactory::CreateInstance(className);
    isBusy = false;
    if (auto* renderer = vtkRenderer::SafeDownCast(object))
    {
      this->Watch->ObserveRenderer(renderer);
    }
    else if (object)
    {
      object->AddObserver(vtkCommand::StartEvent, this->Watch);
    }
    return object;
  }

private:
  const vtkSmartPointer<Observer> Watch = Observer::GetInstance();
};

/**
 * What VTK loads. VTK puts it at the end of its list of factories, behind those of its own
 * libraries that this plug-in needs, which would make all windows. It makes nothing, and puts a
 * Factory at the beginning of the list.
 */
class Loader : public vtkObjectFactory
{
public:
  static Loader* New() { VTK_STANDARD_NEW_BODY(Loader); }
  vtkTypeMacro(Loader, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "loads vtkNBufferCuller"; }

protected:
  Loader()
  {
    vtkNew<Factory> factory;
    vtkObjectFactory::RegisterFactory(factory);
    vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
    // (VTK inserts nothing into an empty list.)
    if (factories->GetNumberOfItems() > 1)
    {
      factories->RemoveItem(factory);
      factories->InsertItem(-1, factory);
    }
  }
};
}

VTK_FACTORY_INTERFACE_IMPLEMENT(Loader)
