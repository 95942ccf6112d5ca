// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferResourceCallback.h
 * @brief vtkOpenGLResourceFreeCallback, also where VTK does not install its header (before 9.5).
 *
 * A render window calls it before its context goes, so that what lives in the context can be
 * released. The interface is part of VTK's library in every version: what is declared here for
 * the old ones has to keep its names, its members and their order.
 */
#ifndef vtkNBufferResourceCallback_h
#define vtkNBufferResourceCallback_h

#include "vtkNBufferVTKVersion.h"

#if VTKNBUFFER_HAS_RESOURCE_CALLBACK
#include "vtkOpenGLResourceFreeCallback.h"
#else
#include "vtkOpenGLRenderWindow.h"

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

  /// Belong to this window from now on; what another one held is released first.
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
// VTK-HeaderTest-Exclude: vtkNBufferResourceCallback.h
