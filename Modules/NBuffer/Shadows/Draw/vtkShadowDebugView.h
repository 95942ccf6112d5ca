// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowDebugView
 * @brief An image that shows what the shadows of one light took, and lays it over the picture.
 *
 * The image is made while plan, volumes and litmaps of the light are at hand, is kept in host
 * memory, and is shown after the opaque props, also in frames that take their masks from an earlier
 * one. vtkShadowDebugImage.h paints it; the volumes themselves are drawn here.
 */
#ifndef vtkShadowDebugView_h
#define vtkShadowDebugView_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowDebugImage.h"
#include "vtkShadowStatistics.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkShadowCounter;

class VTKNBUFFER_EXPORT vtkShadowDebugView
{
public:
  /// What is shown of a light.
  struct Subject
  {
    const vtkShadowLitmap* Litmaps = nullptr;
    int NumberOfLitmaps = 0;
    const std::vector<vtkShadowDraw>& Draws; ///< Of the volume uploaded last.
    const double* VolumeToClip;              ///< Row-major 4 x 4.
    const int* Viewport;                     ///< Of the framebuffer: x, y, width, height.
  };

  /**
   * Make the image. False, with the cause in `why`, if OpenGL refuses. The state is as before,
   * within a vtkShadowCounter::Scope.
   */
  bool Make(vtkOpenGLRenderWindow* window, vtkShadowPicture picture, const Subject& subject,
    vtkShadowCounter& counter, vtkShadowStatistics& statistics, std::string& why);

  /**
   * Lay the image, if there is one, over the colours of the framebuffer that is bound, where the
   * image is not transparent; depth and opacity stay. The state is as before.
   */
  bool Show(vtkOpenGLRenderWindow* window, vtkShadowStatistics& statistics, std::string& why);

  /// Show nothing until the next image is made.
  void Clear() { this->Image.clear(); }

  /// Empty if nothing is shown.
  const vtkShadowDebugImage::Image& GetImage() const { return this->Image; }
  int GetWidth() const { return this->Viewport[2]; }
  int GetHeight() const { return this->Viewport[3]; }

  /// Delete everything; the context that made it must be current.
  void Release();

private:
  bool Reserve(std::string& why);
  bool DrawVolumes(vtkOpenGLRenderWindow* window, vtkShadowPicture picture, const Subject& subject,
    vtkShadowCounter& counter, vtkShadowStatistics& statistics, std::string& why);

  vtkShadowDebugImage::Image Image;
  int Viewport[4] = { 0, 0, 0, 0 };
  unsigned int Texture = 0;
  unsigned int Framebuffer = 0;
  unsigned int VertexArray = 0;
  int Width = 0; ///< Of the texture.
  int Height = 0;
  vtkSmartPointer<vtkShaderProgram> Program;
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowDebugView.h
