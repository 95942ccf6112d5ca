// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferResourceCallback.h
 * @brief Declares vtkOpenGLResourceFreeCallback, also for versions of VTK that do not install its
 * header.
 *
 * A render window calls this object before the window's context is destroyed, so that the owner can
 * delete its OpenGL objects. The class is part of VTK's library in every version, but VTK installs
 * its header only since 9.5. The declaration for older versions must keep the names, the members
 * and their order.
 */
#ifndef vtkNBufferResourceCallback_h
#define vtkNBufferResourceCallback_h

#include "vtkNBufferVTKVersion.h"

#include "vtkOpenGLRenderWindow.h" // VTK's header calls its methods without including it.

#if VTKNBUFFER_HAS_RESOURCE_CALLBACK
#include "vtkOpenGLResourceFreeCallback.h"
#else
VTK_ABI_NAMESPACE_BEGIN
class vtkWindow;

class vtkGenericOpenGLResourceFreeCallback
{
public:
  vtkGenericOpenGLResourceFreeCallback() = default;
  virtual ~vtkGenericOpenGLResourceFreeCallback() = default;
  virtual void Release() = 0;
  virtual void RegisterGraphicsResources(vtkOpenGLRenderWindow* window) = 0;
  bool IsReleasing() { return this->Releasing; }

protected:
  vtkOpenGLRenderWindow* VTKWindow = nullptr;
  bool Releasing = false;
};

template <class T>
class vtkOpenGLResourceFreeCallback : public vtkGenericOpenGLResourceFreeCallback
{
public:
  vtkOpenGLResourceFreeCallback(T* owner, void (T::*release)(vtkWindow*))
    : Owner(owner)
    , ReleaseOwner(release)
  {
  }

  /// Register with a window. The owner's objects in the previous window are released first.
  void RegisterGraphicsResources(vtkOpenGLRenderWindow* window) override
  {
    if (this->VTKWindow != window)
    {
      this->Release();
      this->VTKWindow = window;
      if (window)
      {
        window->RegisterGraphicsResources(this);
      }
    }
  }

  void Release() override
  {
    if (this->VTKWindow && !this->Releasing)
    {
      this->Releasing = true;
      this->VTKWindow->PushContext();
      (this->Owner->*this->ReleaseOwner)(this->VTKWindow);
      this->VTKWindow->UnregisterGraphicsResources(this);
      this->VTKWindow->PopContext();
      this->VTKWindow = nullptr;
      this->Releasing = false;
    }
  }

private:
  T* Owner;
  void (T::*ReleaseOwner)(vtkWindow*);
};
VTK_ABI_NAMESPACE_END
#endif

#endif
