// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDepthExchange
 * @brief Lets the culler of each rank of a parallel program leave out what occluders of other ranks
 * hide.
 *
 * Where a scene is spread over the ranks of a parallel program, each rank draws its own props, and
 * the pictures are composited by depth (sort-last). A culler without an exchange knows only the
 * depth of its own rank. With an exchange, all ranks of the renderer share the depth that they have
 * drawn so far, reduced to tiles. The composited image stays the same, to the bit.
 *
 * This class does not use MPI: vtkNBufferParallelDepthExchange in the module VTK::NBufferParallel
 * exchanges by a vtkMultiProcessController, and an application may derive a class of its own.
 *
 * @code
 * exchange->SetRenderer(renderer);       // on every rank, before its first frame
 * culler->SetDepthExchange(exchange);
 * renderer->AddCuller(culler);
 * @endcode
 *
 * ## What it requires
 *
 *  - Every rank draws each frame of its renderer, of the same size and with the same camera, and
 *    composites the picture by depth after that, as vtkSynchronizedRenderers does.
 *  - The exchange of a renderer exists on all ranks from the same frame on, with the same
 *    ParallelRendering. The application keeps it as long as the renderer is drawn.
 *
 * Apart from that, ranks may differ. A rank without props, or whose culler is missing, off, pausing
 * or steps aside, joins all exchanges at the end of its frame, with the depth of its picture; where
 * depth cannot be read, it contributes the far plane. So no rank ever waits for one that does not
 * come. Each rank culls by its own depth alone if the ranks' views, sizes or settings differ, if an
 * exchange fails, and for one frame if another rank's depth buffer turns out to be coarser.
 *
 * A rank also uses its own depth alone with FXAA or SSAO, because a prop that another rank hides
 * might change the color of pixels beside it, and with render passes or multisampling, because the
 * depth of the test may not be the depth that is composited.
 *
 * ## Cost
 *
 * A frame has one exchange, and two after a cut of the camera by which a rank gets more than 256
 * props of which it knows nothing. While nothing moves it has only a
 * poll, a message of 4 bytes by which the ranks find out whether anything has changed, and while
 * the ranks back off together it has no message (vtkNBufferExchangePlan.h). An exchange sends 4
 * bytes per tile, 12 per rank and 176 more: with few ranks, 173 kB at 960 x 720 pixels. The time is
 * that of an all-reduce of that size, and the time until the slowest rank has drawn what it draws
 * before its first test.
 *
 * @sa vtkNBufferCuller
 */
#ifndef vtkNBufferDepthExchange_h
#define vtkNBufferDepthExchange_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"
#include "vtkObject.h"
#include "vtkWeakPointer.h" // For the renderer

#include <memory> // For the shared depth

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferSharedDepth;
class vtkRenderer;

class VTKNBUFFER_EXPORT vtkNBufferDepthExchange : public vtkObject
{
public:
  vtkTypeMacro(vtkNBufferDepthExchange, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The renderer whose depth is exchanged. The exchange does not keep it alive. Default: nullptr.
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer() const;
  ///@}

  ///@{
  /// Whether depth is exchanged. If off, each rank culls by its own depth. Like the setting of that
  /// name of vtkSynchronizedRenderers, it must be the same on all ranks in every frame. Default:
  /// on.
  vtkSetMacro(ParallelRendering, bool);
  vtkGetMacro(ParallelRendering, bool);
  vtkBooleanMacro(ParallelRendering, bool);
  ///@}

  ///@{
  /// The side of a tile in pixels: 1, 2, 4 or 8; other values are an error. Smaller tiles cost more
  /// bytes and hide more: a tile hides nothing if the occluders of two ranks fill it only together.
  /// While depth is exchanged this replaces vtkNBufferTuning::BaseFactor. It must be the same on
  /// all ranks. Default: 4.
  void SetTileSize(int pixels);
  vtkGetMacro(TileSize, int);
  ///@}

  ///@{
  /// Whether the ranks stop exchanging together for some frames where that hides next to nothing.
  /// It must be the same on all ranks. Default: on.
  vtkSetMacro(BackOff, bool);
  vtkGetMacro(BackOff, bool);
  vtkBooleanMacro(BackOff, bool);
  ///@}

  ///@{
  /// What the last frame cost: the number of exchanges, the bytes of this rank's messages, polls
  /// included, and the milliseconds spent in them, most of them for waiting for other ranks.
  int GetNumberOfExchanges() const;
  long long GetNumberOfBytes() const;
  double GetExchangeTime() const;
  ///@}

  ///@{
  /// The number of ranks, and the number of this rank, counted from 0.
  virtual int GetNumberOfRanks() = 0;
  virtual int GetRank() = 0;
  ///@}

  /**
   * Write the minimum over all ranks of each of `count` floats to `minima`. All ranks call this
   * function equally often, with the same count. Returns false on failure.
   */
  virtual bool ReduceToMinimum(const float* values, float* minima, int count) = 0;

  /// Called by vtkNBufferCuller: returns what is shared in this frame of `renderer`, or nullptr if
  /// nothing is shared.
  std::shared_ptr<vtkNBufferSharedDepth> GetSharedDepth(vtkRenderer* renderer);

protected:
  vtkNBufferDepthExchange();
  ~vtkNBufferDepthExchange() override;

private:
  vtkNBufferDepthExchange(const vtkNBufferDepthExchange&) = delete;
  void operator=(const vtkNBufferDepthExchange&) = delete;

  bool IsOn();
  /// Observe the end of the renderer's frames. Returns false if it is observed already.
  bool Observe();
  void EndFrame();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
  bool ParallelRendering = true;
  bool BackOff = true;
  int TileSize = 4;
  std::shared_ptr<vtkNBufferSharedDepth> Shared;
};

VTK_ABI_NAMESPACE_END
#endif
