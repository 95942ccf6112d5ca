// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DepthPainter
 * @brief Draws triangles by OpenGL into a depth texture of any format and encoding
 * (DepthFormats.h), and reads back what the depth test left.
 *
 * VTK draws depths of one encoding only. This class draws all of them, in a framebuffer of its own,
 * with VTK's depth test: of equal depths the triangle that comes last is seen.
 */
#ifndef DepthPainter_h
#define DepthPainter_h

#include "DepthFormats.h"

#include "vtkNBufferGLM.h"
#include "vtkNBufferGLObject.h"

#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace NBufferPeers
{

/// A perspective view. X, Y and W are the rows of x, y and w of the matrix from positions relative
/// to the eye to clip coordinates.
struct DepthView
{
  int Width;
  int Height;
  NBufferStudy::DepthPlanes Planes;
  glm::dvec3 X;
  glm::dvec3 Y;
  glm::dvec3 W;
};

struct DepthVertex
{
  glm::vec3 Place; ///< Relative to the eye.
  float Number;    ///< What the triangle leaves in its pixels: an integer from 1 to 2^24.
};

class DepthPainter
{
public:
  explicit DepthPainter(vtkOpenGLRenderWindow* window)
    : Window(window)
  {
  }

  /// Copies triangles to the device, three vertices each. The context must be current for this and
  /// for all other calls, and when the object is destroyed. They throw std::runtime_error on any
  /// error of OpenGL.
  void SetTriangles(const std::vector<DepthVertex>& vertices);

  /// Sets what is drawn into. Returns false, with the cause in `why`, if the device has no depth
  /// buffer of exactly this format, or cannot draw this encoding.
  bool SetView(const NBufferStudy::DepthFormat& format, const DepthView& view, std::string& why);

  /// Sets glPolygonOffset(); 0 and 0 by default.
  void SetOffset(float factor, float units);

  /// Clears the image and draws `count` vertices from `first` on.
  void Draw(int first, int count);

  ///@{
  /// Read the image row by row, the lowest first: the number that each pixel shows, or 0, and its
  /// stored depth.
  std::vector<float> ReadNumbers();
  std::vector<double> ReadDepth();
  ///@}

private:
  bool Allocate(std::string& why);
  vtkShaderProgram* UseProgram();

  vtkOpenGLRenderWindow* Window;
  NBufferStudy::DepthFormat Format{};
  DepthView View{};
  float Offset[2] = { 0.0f, 0.0f };
  /// By encoding. Forward and Reversed are the same program.
  std::map<NBufferStudy::DepthEncoding, vtkSmartPointer<vtkShaderProgram>> Programs;
  vtkNBufferGL::Texture Depth;
  vtkNBufferGL::Texture Numbers;
  vtkNBufferGL::Framebuffer Target;
  vtkNBufferGL::Buffer Vertices;
  vtkNBufferGL::VertexArray VertexArray;
};

} // namespace NBufferPeers

#endif
