// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DepthChain
 * @brief The two techniques of Turitzin (2020) on the device: a mip chain of depth, and one level
 * at 1/16 of it without the others, for several images (the eyes of a headset) in one array.
 *
 * All texels hold the farthest depth.
 *
 *  - BuildChain() draws the chain level by level, each size half of the last one, rounded down.
 *    Exact: where a size is odd, every texel covers three columns (rows) of the level below, so
 *    that it has all that is at its place in texture coordinates. Fat: only the last one does.
 *  - BuildGroups() runs one compute shader (needs OpenGL 4.3), a work group for each texel of the
 *    level. The size is rounded up, as that of SingleLevel.
 *
 * The chain is a texture of 32-bit float depth whose level 0 is the image, as the paper has it. The
 * other level is a texture of its own, because shaders cannot store depth.
 */
#ifndef DepthChain_h
#define DepthChain_h

#include "DeviceTimer.h"

#include "vtkNBufferComputePrograms.h"
#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGLObject.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace NBufferPeers
{

enum class ChainEdges
{
  Exact,
  Fat
};

/// How a work group finds the farthest of its 16 x 16 pixels.
struct GroupForm
{
  int Side;     ///< Invocations along each axis: 2, 4, 8 or 16.
  bool Gather;  ///< Whether four pixels are read at a time; not with 16, which have one each.
  bool Atomics; ///< Whether they meet in one number by atomics, or over a tree of pairs.
};

class DepthChain
{
public:
  DepthChain();
  ~DepthChain() { this->Groups.Delete(); }
  DepthChain(const DepthChain&) = delete;
  void operator=(const DepthChain&) = delete;

  /// Returns why the current context cannot run BuildGroups(), or an empty text if it can.
  static std::string WhyNotGroups() { return vtkNBufferGL::ComputePrograms::WhyNot(); }

  /// Uploads depth images of one size, row 0 at the bottom, values in [0, 1]. The context must be
  /// current for this call, for those below, and when the object is destroyed. They throw
  /// std::runtime_error on any error of OpenGL.
  void SetDepth(vtkOpenGLRenderWindow* window, const std::vector<std::vector<float>>& layers,
    int width, int height);

  /// Starts to build the first `count` levels above level 0 of all layers, or all there are.
  void BuildChain(ChainEdges edges, int count);

  /// Starts to build the one level of all layers.
  void BuildGroups(const GroupForm& form);

  /// Waits for the last build, and returns the milliseconds that the device took for it by a timer
  /// query, or -1 where there are no timers.
  double GetDeviceTime() { return this->Timer.GetMilliseconds(); }

  /// Returns the number of levels of the chain, with level 0.
  int GetNumberOfLevels() const;
  /// Returns the length of a level's side, of the side of level 0.
  static int GetLevelSize(int size, int level);

  ///@{
  /// Wait for a level of the chain, or for the one level, and read a layer of it.
  std::vector<float> DownloadChain(int level, int layer);
  std::vector<float> DownloadGroups(int layer);
  ///@}

private:
  void Allocate();
  unsigned int GetFramebuffer(int level, int layer) const;

  vtkOpenGLRenderWindow* Window = nullptr;
  int Width = 0;
  int Height = 0;
  int Layers = 0;
  vtkNBufferGL::Texture Chain;
  vtkNBufferGL::Texture Level;
  std::vector<vtkNBufferGL::Framebuffer> ChainTargets; ///< By level and layer.
  std::vector<vtkNBufferGL::Framebuffer> LevelTargets; ///< By layer.
  vtkNBufferGL::FullScreenPass Pass;
  vtkNBufferGL::ComputePrograms Groups;
  DeviceTimer Timer;
};

} // namespace NBufferPeers

#endif
