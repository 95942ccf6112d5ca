// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowDebugView
 * @brief Makes an image of how the shadows of one light were made, and lays it over the picture.
 *
 * The image is made when the plan, the volumes and the litmaps of the light exist, and is kept in
 * host memory. It is shown after the opaque props, also in later frames that use the same masks.
 * vtkShadowDebugImage.h paints litmaps, boxes and counts; the volumes themselves are drawn here.
 */
#ifndef vtkShadowDebugView_h
#define vtkShadowDebugView_h

#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowDebugImage.h"
#include "vtkShadowStatistics.h"
#include "vtkShadowVolumeBuffer.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowCounter;

class VTKNBUFFER_EXPORT vtkShadowDebugView
{
public:
  vtkShadowDebugView();

  /// What the image shows: how the shadows of a light were made.
  struct Subject
  {
    const vtkShadowLitmap* Litmaps = nullptr; ///< One, or the six of a point light.
    int NumberOfLitmaps = 0;                  ///< 0 if the light was drawn without litmaps.
    const vtkShadowVolumeBuffer& Volume;
    const std::vector<vtkShadowDraw>& Draws; ///< The draws of Volume.
    const vtkShadowDrawList::View& View;     ///< The view that they were made for.
  };

  /**
   * Makes the image. Returns false, with the cause in `why`, if an OpenGL call fails. Call it
   * within a vtkShadowCounter::Scope, whose state is restored.
   */
  bool Make(vtkOpenGLRenderWindow* window, vtkShadowPicture picture, const Subject& subject,
    vtkShadowCounter& counter, vtkShadowStatistics& statistics, std::string& why);

  /**
   * Blends the image, if there is one, over the colours of the framebuffer that is bound. Depth and
   * opacity of the framebuffer do not change. Returns false, with the cause in `why`, if an OpenGL
   * call fails. Restores the state of OpenGL.
   */
  bool Show(vtkOpenGLRenderWindow* window, vtkShadowStatistics& statistics, std::string& why);

  /// Shows nothing until the next image is made.
  void Clear() { this->Image.clear(); }

  ///@{
  /// The image, which is empty if nothing is shown, and its size in pixels.
  const vtkShadowDebugImage::Image& GetImage() const { return this->Image; }
  int GetWidth() const { return this->Viewport[2]; }
  int GetHeight() const { return this->Viewport[3]; }
  ///@}

  /// Deletes the OpenGL objects. Their context must be current.
  void Release();

private:
  bool Reserve(std::string& why);
  bool DrawVolumes(vtkOpenGLRenderWindow* window, vtkShadowPicture picture, const Subject& subject,
    vtkShadowCounter& counter, vtkShadowStatistics& statistics, std::string& why);

  vtkShadowDebugImage::Image Image;
  int Viewport[4] = { 0, 0, 0, 0 };
  vtkNBufferGL::GrowingTexture Texture; ///< Each texel is for the framebuffer's pixel there.
  vtkNBufferGL::FullScreenPass Pass;
};
VTK_ABI_NAMESPACE_END
#endif
