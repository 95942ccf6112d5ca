// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FrameSums.cxx
 * @brief A plug-in that appends a checksum of each frame of each window to the file FRAME_SUMS.
 *
 * Programs that are not changed write at most their last picture. Errors of culling show in frames
 * while the camera moves.
 */
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersion.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace
{
class Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }
  vtkTypeMacro(Observer, vtkCommand);

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* window = static_cast<vtkRenderWindow*>(caller);
    const int* size = window->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    std::uint64_t sum = 0xcbf29ce484222325; // FNV-1a
    for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
    {
      sum = (sum ^ pixels->GetValue(i)) * 0x100000001b3;
    }
    std::ofstream file(std::getenv("FRAME_SUMS"), std::ios::app);
    file << size[0] << 'x' << size[1] << ' ' << std::hex << sum << '\n';
  }
};

/// Observes the windows that the factories behind it make. It needs no library that registers a
/// factory, so that it is the first one if its folder is the first in VTK_AUTOLOAD_PATH.
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
  const char* GetDescription() override { return "checksums of frames"; }

protected:
  vtkObject* CreateObject(const char* className) override
  {
    thread_local bool isBusy = false;
    if (isBusy || std::strcmp(className, "vtkRenderWindow") != 0)
    {
      return nullptr;
    }
    isBusy = true;
    vtkObject* window = vtkObjectFactory::CreateInstance(className);
    isBusy = false;
    if (window)
    {
      window->AddObserver(vtkCommand::EndEvent, this->Watch);
    }
    return window;
  }

private:
  vtkNew<Observer> Watch;
};
}

VTK_FACTORY_INTERFACE_IMPLEMENT(Factory)
