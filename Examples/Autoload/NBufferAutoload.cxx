// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NBufferAutoload.cxx
 * @brief A plug-in that gives vtkNBufferCuller to all renderers of a program that is not changed.
 *
 * VTK loads every library in the folders of VTK_AUTOLOAD_PATH before it makes its first object by a
 * factory. This one replaces no class: its factory lets the factories behind it make each window
 * and renderer, of whatever class, and observes it. When a frame begins, a renderer gets the culler
 * if it has none, even if the program has emptied its list of cullers. README.md lists the
 * environment variables.
 */
#include "vtkNBufferCuller.h"

#include "vtkCommand.h"
#include "vtkCullerCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkRenderPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// The value of an environment variable, split at its commas.
std::vector<std::string> ReadNames(const char* variable)
{
  std::vector<std::string> names;
  const char* value = std::getenv(variable);
  std::istringstream list(value ? value : "");
  for (std::string name; std::getline(list, name, ',');)
  {
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
  long long Hidden = 0;
  long long Drawn = 0;
  std::map<std::string, int> Decisions;
  vtkNBufferStatistics Last;
};

std::ostream& operator<<(std::ostream& os, const Record& record)
{
  os << "{\"renderer\": \"" << record.Renderer << "\", \"window\": \"" << record.Window
     << "\", \"frames\": " << record.Frames << ", \"hidden\": " << record.Hidden
     << ", \"drawn\": " << record.Drawn << ", \"decisions\": {";
  const char* separator = "";
  for (const auto& [decision, count] : record.Decisions)
  {
    os << separator << '"' << decision << "\": " << count;
    separator = ", ";
  }
  return os << "}, \"last\": " << record.Last.GetAsJSON() << '}';
}

/// Observes all windows and renderers.
class Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }
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
    while (!this->Records.empty())
    {
      this->Forget(this->Records.begin()->first);
    }
    std::ofstream os(file);
    os << "{\"vtk\": \"" << vtkVersion::GetVTKVersion() << "\", \"renderers\": [";
    for (std::size_t i = 0; i < this->Finished.size(); ++i)
    {
      os << (i == 0 ? "\n" : ",\n") << this->Finished[i];
    }
    os << "]}\n";
    if (!os.flush())
    {
      std::cerr << "nbuffer-autoload: cannot write " << file << " (NBUFFER_REPORT)\n";
    }
  }

private:
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
      renderer->AddCuller(this->Culler);
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

  void EndFrame(vtkRenderer* renderer)
  {
    const vtkNBufferCuller* culler = FindCuller(renderer);
    if (!culler || !renderer->GetRenderWindow())
    {
      return;
    }
    Record& record = this->Records[renderer];
    record.Renderer = renderer->GetClassName();
    record.Window = renderer->GetRenderWindow()->GetClassName();
    record.Last = culler->GetStatistics(renderer);
    ++record.Frames;
    ++record.Decisions[vtkNBufferStatistics::GetName(record.Last.Decision)];
    record.Hidden += record.Last.GetCount(vtkNBufferVerdict::Hidden);
    record.Drawn += record.Last.GetNumberOfPropsDrawn();
  }

  void Forget(vtkRenderer* renderer)
  {
    const auto found = this->Records.find(renderer);
    if (found != this->Records.end())
    {
      this->Finished.push_back(found->second);
      this->Records.erase(found);
    }
  }

  vtkNew<vtkNBufferCuller> Culler;
  const std::vector<std::string> Passes = ReadNames("NBUFFER_KNOWN_PASSES");
  std::map<vtkRenderer*, Record> Records;
  std::vector<Record> Finished; ///< The records of renderers that have been deleted.
};

/// Has windows and renderers made by the factories behind it.
class Factory : public vtkObjectFactory
{
public:
  static Factory* New()
  {
    auto* factory = new Factory;
    factory->InitializeObjectBase();
    return factory;
  }
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
    if (this->IsBusy ||
      (std::strcmp(className, "vtkRenderWindow") != 0 &&
        std::strcmp(className, "vtkRenderer") != 0))
    {
      return nullptr;
    }
    this->IsBusy = true;
    vtkObject* object = vtkObjectFactory::CreateInstance(className);
    this->IsBusy = false;
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
  vtkNew<Observer> Watch;
  bool IsBusy = false;
};

/**
 * What VTK loads. VTK puts it at the end of its list of factories, behind those of its own
 * libraries that this plug-in needs, which would make all windows. It makes nothing, and puts a
 * Factory at the beginning of the list.
 */
class Loader : public vtkObjectFactory
{
public:
  static Loader* New()
  {
    auto* loader = new Loader;
    loader->InitializeObjectBase();
    return loader;
  }
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
