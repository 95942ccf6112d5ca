// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class SingleLevel
 * @brief A depth texture reduced to one level on the device, without any hierarchy.
 *
 * With the factor N, texel (x, y) holds the farthest depth of the pixels [Nx, Nx + N) x
 * [Ny, Ny + N) inside the image, equal to vtkNBufferLevels::BuildBase() bit for bit. There are
 * three ways to compute it:
 *
 *  - one fragment pass with N x N fetches for each texel (the module's shader),
 *  - log2(N) fragment passes with 2 x 2 fetches,
 *  - a compute shader that fetches each pixel once and combines them by atomics in shared memory
 *    (needs OpenGL 4.3).
 *
 * All start from the same texture of 32-bit float depth, so that only the reduction is compared.
 */
#ifndef SingleLevel_h
#define SingleLevel_h

#include "DeviceTimer.h"

#include "vtkNBufferComputePrograms.h"
#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGLObject.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

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
  ~SingleLevel() { this->Compute.Delete(); }
  SingleLevel(const SingleLevel&) = delete;
  void operator=(const SingleLevel&) = delete;

  /// Returns why the current context cannot use a method, or an empty text if it can.
  static std::string WhyNot(ReduceMethod method);

  /// Uploads a depth image, row 0 at the bottom, values in [0, 1]. The context must be current for
  /// this call, for those below, and when the object is destroyed. They throw std::runtime_error on
  /// any error of OpenGL.
  void SetDepth(
    vtkOpenGLRenderWindow* window, const std::vector<float>& depth, int width, int height);

  /// Starts to reduce the depth image; `factor` is 4, 8 or 16. Does not wait for the device.
  void Reduce(ReduceMethod method, int factor);

  /// Waits for the last Reduce(), and returns the milliseconds that the device took for it by a
  /// timer query, or -1 where there are no timers.
  double GetDeviceTime() { return this->Timer.GetMilliseconds(); }

  /// Waits for the level, and reads its GetWidth() x GetHeight() texels.
  void Download(std::vector<float>& level);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

private:
  void DrawPass(unsigned int source, int width, int height, int factor, int target);
  void ReduceByPasses(int factor);
  void Dispatch(int factor);

  vtkOpenGLRenderWindow* Window = nullptr;
  int PixelWidth = 0;
  int PixelHeight = 0;
  int Width = 0;
  int Height = 0;
  vtkNBufferGL::GrowingTexture Depth;
  vtkNBufferGL::GrowingTexture Targets[2]; ///< The level is in the first one.
  vtkNBufferGL::FullScreenPass Pass;
  vtkNBufferGL::ComputePrograms Compute;
  DeviceTimer Timer;
};

} // namespace NBufferPeers

#endif
