// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDividedProp
 * @brief One large prop whose units (vtkNBufferUnits) are culled one by one.
 *
 * From frame to frame:
 *
 *     Waiting ---> Reading ---> Building ---> Ready
 *                     |             |
 *                     +-------------+---> Refused
 *
 *  - Waiting: The data has changed recently. Nothing is done until it has stayed the same for some
 *    frames.
 *  - Reading: The next draw copies the list of indices that VTK draws, and the points.
 *  - Building: A thread makes the units from the copy. The prop is drawn whole.
 *  - Ready: The units are tested.
 *  - Refused: The prop cannot be divided, and is drawn whole until it changes.
 *
 * In a frame with a test, when it is Ready:
 *
 *  1. FindKept() tests the frustum. The units that the last test found visible are to be drawn
 *     first. In a new view, of which the last test says little, these are units that probably
 *     hide the others.
 *  2. The first draw draws these.
 *  3. Test() compares the other units with the levels. Units that were drawn already are tested as
 *     well, so that the next frame need not draw hidden ones; an eighth of them in each frame also
 *     with pixels.
 *  4. The second draw draws the units that the test found visible, the fresh ones.
 *
 * A prop that is held back is tested before its first draw; then all units take steps 3 and 4. So
 * is a translucent prop, which may be drawn several times (depth peeling).
 */
#ifndef vtkNBufferDividedProp_h
#define vtkNBufferDividedProp_h

#include "vtkNBufferDrawHook.h"
#include "vtkNBufferUnitCulling.h"

#include "vtkActor.h" // For the weak pointer
#include "vtkWeakPointer.h"

#include <functional>
#include <future>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkRenderer;
struct vtkNBufferTuning;

class vtkNBufferDividedProp
{
public:
  using Depth = vtkNBufferUnitCulling::Depth;

  vtkNBufferDividedProp(vtkActor* actor, vtkNBufferDrawPass* pass);
  ~vtkNBufferDividedProp();
  vtkNBufferDividedProp(const vtkNBufferDividedProp&) = delete;
  void operator=(const vtkNBufferDividedProp&) = delete;

  vtkActor* GetActor() const { return this->Actor; }

  /// Draw the prop whole, and forget its units, until the next BeginFrame().
  void Release();

  /// Begin a frame. `changed` says whether what the prop draws may have changed, `device` is
  /// nullptr or tests units and makes lists on the graphics device, and the tuning says how units
  /// are made.
  void BeginFrame(bool changed, vtkOpenGLRenderWindow* window, vtkNBufferUnitDevice* device,
    const vtkNBufferTuning& tuning);

  /// Whether the next draw has to be made by Draw(), so that it can read what VTK draws.
  bool IsReading() const { return this->State == Phase::Reading; }

  /// Whether the units can be tested.
  bool IsReady() const { return this->State == Phase::Ready; }

  /// Step 1 for a projection from the coordinates of the mesh.
  void FindKept(const vtkNBufferProjection& projection) { this->Culling.FindKept(projection); }

  /// Step 3. Returns the number of fresh units. If as many units as are worth more than `limit`
  /// props are visible and have not been drawn, far ones may be left to another test after step 4
  /// (HasPostponed()).
  int Test(const vtkNBufferProjection& projection, const Depth& depth, int limit);

  /// Test all units of a translucent prop. Draws of this frame then draw those that are visible.
  void TestAll(const vtkNBufferProjection& projection, const Depth& depth);

  /// Steps 2 and 4: draw what is to be drawn next, by calling `drawWhole`, which draws the actor.
  int Draw(const std::function<int()>& drawWhole);

  /// Draw what step 4 draws, but do not count it as drawn.
  int TryFresh(const std::function<int()>& drawWhole);

  /// Draw the units that have been drawn in this frame once more, in the order of the mesh.
  int DrawAgain(const std::function<int()>& drawWhole);

  /// Draw the actor itself; `drawWhole` calls this function.
  int Render(vtkRenderer* renderer) { return this->Hook.Render(this->Actor, renderer); }

  /// Whether the last draw of units drew all of them, because VTK has changed what it draws.
  bool HasDrawnAll() const { return this->Hook.IsStale(); }

  /// Whether the first draw of this frame has been made.
  bool IsBegun() const { return this->IsDrawn; }

  /// Whether all units have been tested after that draw. No further test is needed then, because
  /// what a test has found hidden stays hidden in this frame, unless TestAgain() says otherwise.
  bool IsSettled() const { return this->Settled; }
  void TestAgain() { this->Settled = false; }

  /// Whether the last test has left visible units to another one.
  bool HasPostponed() const { return this->Postponed; }

  /// Which of its units may be seen, which have been drawn, and which are fresh.
  const vtkNBufferUnitCulling& GetCulling() const { return this->Culling; }

  /// Place `box`, which is that of the actor, around bounds in the coordinates of the mesh. With
  /// `withRounding` its bounds of rounding errors become those of the mesh as well.
  void SetPlace(const vtkNBufferUnits::Box& bounds, bool withRounding, vtkNBufferBox& box) const;

  /// Add the units of this prop to the statistics, except UnitsHidden.
  void AddTo(vtkNBufferStatistics& statistics) const;

  /**
   * Whether the units are blocks of composite data that have changed. In this case the prop has to
   * be drawn whole, and is read again. If blocks change, the time of the data may stay the same.
   * VTK notices such changes when it draws, so that this function is needed only for props that are
   * not drawn. It visits all blocks.
   */
  bool HasChangedBlocks();

  /// See vtkNBufferCuller::GetVerdict(). Requires IsReady().
  vtkNBufferVerdict GetVerdict(int part);

  /// Whether the next draw draws the fresh units.
  bool HasFresh() const { return this->FreshIsNext; }

  /// Whether there are fewer fresh units than units that have been drawn in this frame.
  bool HasFewFresh() const;

  /// Whether the prop has been drawn in this frame, but without some of its units in the view.
  bool IsDrawnInPart() const;

private:
  enum class Phase
  {
    Waiting,
    Reading,
    Building,
    Ready,
    Refused
  };

  bool HasSameData() const;
  void ReadRounding();
  void Build(const vtkNBufferTuning& tuning);
  void Adopt();
  int TestUnits(const vtkNBufferProjection& projection, const Depth& depth);
  bool TestOnDevice(const vtkNBufferProjection& projection, const Depth& depth);
  int DrawList(vtkNBufferDrawHook::List list, const std::vector<unsigned char>& marked,
    const std::function<int()>& drawWhole);

  vtkWeakPointer<vtkActor> Actor;
  vtkSmartPointer<vtkNBufferDrawPass> Pass;
  vtkNBufferDrawHook Hook;
  Phase State = Phase::Waiting;
  int StillFrames = 0;
  vtkMTimeType BlockTime = 0; ///< The newest time of all blocks before they were read.
  bool IsOutdated = false;    ///< HasChangedBlocks() has been true.
  std::future<vtkNBufferUnits> Pending;
  vtkNBufferUnits::Mesh Mesh; ///< Released when the units are made.
  vtkNBufferUnitCulling Culling;
  vtkNBufferUnitAnswers Answers; ///< Of the last test on the device.
  std::size_t MinimumNumberOfUnitsOnDevice = 1;
  bool IsDrawn = false;
  bool FreshIsNext = false;
  bool Settled = false;
  bool Postponed = false;
  bool TestedOnDevice = false; ///< The device has made the last test of this frame.
};

VTK_ABI_NAMESPACE_END
#endif
