// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SameList.h
 * @brief What vtkNBufferCuller draws of composite data, drawn without any tests.
 *
 * It shows which part of a frame is the cost of the tests, and which part is that of VTK's mapper,
 * which visits all blocks however few of them are drawn.
 */
#ifndef SameList_h
#define SameList_h

#include "Mode.h"
#include "Session.h"

#include "vtkActor.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace NBufferBench
{
class BlockListPass;

class SameList
{
public:
  SameList();
  ~SameList();
  SameList(const SameList&) = delete;
  void operator=(const SameList&) = delete;

  /**
   * Walks the path with a mode nbuffer, when that has divided the composite data, and records for
   * every pose what it draws. Returns the props of each pose. A prop of composite data is replaced
   * by a copy that keeps all of its blocks, but draws only those of the list. Each pose has been
   * drawn once, so that its lists are made. Throws std::runtime_error if there is no composite data
   * of which this version of VTK can draw a list.
   */
  std::vector<std::vector<vtkProp*>> Record(
    Session& session, const NBufferExamples::CameraPath& path, const std::string& backend);

  /// Lets the copies draw the list of this pose.
  void SetFrame(std::size_t frame);

  /// Returns how many blocks are in the lists of each pose.
  std::vector<double> CountBlocks() const;

private:
  struct Copy
  {
    vtkSmartPointer<vtkActor> Actor;
    vtkSmartPointer<BlockListPass> Pass;
    std::vector<std::set<unsigned int>> Lists; ///< The flat indices of the blocks of each pose.
  };

  void AddCopy(vtkActor* actor);
  void AddLists(vtkNBufferCuller* culler);

  std::map<vtkProp*, Copy> Copies; ///< By the original.
};

} // namespace NBufferBench

#endif
