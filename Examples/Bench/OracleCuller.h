// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class OracleCuller
 * @brief Draws the props that it is told to: the lower bound that no culler can beat.
 *
 * It copies the pointers of the frame over the list and looks at nothing else, so that its own
 * cost is that of the props that it draws. They must be visible props of the renderer, in the
 * order of the renderer's list.
 */
#ifndef OracleCuller_h
#define OracleCuller_h

#include "vtkCuller.h"

#include <vector>

class vtkProp;

namespace NBufferBench
{

class OracleCuller : public vtkCuller
{
public:
  static OracleCuller* New();
  vtkTypeMacro(OracleCuller, vtkCuller);

  /// Not copied: it must live until the frame is drawn.
  void SetProps(const std::vector<vtkProp*>* props) { this->Props = props; }

  double Cull(
    vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized) override;

private:
  const std::vector<vtkProp*>* Props = nullptr;
};

} // namespace NBufferBench

#endif
