// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class SingleLevel
 * @brief A depth texture reduced to one level on the device, without any hierarchy.
 *
 * Texel (x, y) holds the farthest of the pixels [Nx, Nx + N) x [Ny, Ny + N) that there are, as
 * vtkNBufferLevels::BuildBase has it, bit for bit. Three ways:
 *
 *  - one fragment pass, N x N fetches for each texel (the module's shader),
 *  - log2(N) fragment passes of 2 x 2 fetches,
 *  - a compute shader: a fetch for each pixel, combined by atomics in shared memory (OpenGL 4.3).
 *
 * All start from the same texture of 32-bit float depth, so that only the reduction is compared.
 */
#ifndef SingleLevel_h
#define SingleLevel_h

#include "vtkSmartPointer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderTimer;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
template <class T>
class vtkOpenGLResourceFreeCallback;

namespace NBufferPeers
{

enum class ReduceMethod
{
  OnePass,
  Passes,
  Compute
};

class SingleLevel
{
public:
  SingleLevel();
  ~SingleLevel();
  SingleLevel(const SingleLevel&) = delete;
  void operator=(const SingleLevel&) = delete;

  /// Why the current context cannot do this; empty if it can.
  static std::string WhyNot(ReduceMethod method);

  /// Upload a depth image, row 0 at the bottom, values in [0, 1]. The context must be current here
  /// and below. False, with the cause in `why`, on any error of OpenGL.
  bool SetDepth(vtkOpenGLRenderWindow* window, const std::vector<float>& depth, int width,
    int height, std::string& why);

  /// `factor` is 4, 8 or 16. Nothing is waited for.
  bool Reduce(ReduceMethod method, int factor, std::string& why);

  /// Milliseconds on the device of the last Reduce(), by a timer query; waits. -1 without timers.
  double GetDeviceTime();

  /// The level, GetWidth() x GetHeight() texels; waits.
  bool Download(std::vector<float>& level, std::string& why);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Image
  {
    unsigned int Texture = 0;
    unsigned int Framebuffer = 0;
  };

  vtkShaderProgram* ReadyPass(int factor, std::string& why);
  bool DrawPass(
    unsigned int source, int width, int height, int factor, const Image& target, std::string& why);
  bool ReduceByPasses(int factor, std::string& why);
  bool Dispatch(int factor, std::string& why);
  bool CompileCompute(std::string& why);

  vtkOpenGLRenderWindow* Window = nullptr;
  int PixelWidth = 0;
  int PixelHeight = 0;
  int Width = 0;
  int Height = 0;
  unsigned int Depth = 0;
  Image Targets[2]; ///< The level is in the first.
  unsigned int VertexArray = 0;
  unsigned int ComputeProgram = 0;
  std::map<int, vtkSmartPointer<vtkShaderProgram>> Programs; ///< By factor.
  std::unique_ptr<vtkOpenGLRenderTimer> Timer;
  std::unique_ptr<vtkOpenGLResourceFreeCallback<SingleLevel>> ResourceCallback;
};

} // namespace NBufferPeers

#endif
