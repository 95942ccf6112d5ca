// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferParallelDepthExchange
 * @brief Exchanges the depth of a renderer between the processes of a vtkMultiProcessController.
 *
 * It is used like vtkSynchronizedRenderers, on every process, and together with it:
 *
 * @code
 * vtkNew<vtkNBufferParallelDepthExchange> exchange;
 * exchange->SetController(controller);
 * exchange->SetRenderer(renderer);
 * vtkNew<vtkNBufferCuller> culler;
 * culler->SetDepthExchange(exchange);
 * renderer->AddCuller(culler);
 * @endcode
 *
 * The module depends on VTK::ParallelCore and not on MPI: the application links VTK::ParallelMPI
 * and makes a vtkMPIController. If a process ends early, its MPI ends the others, too, as MPI does
 * in any collective communication.
 *
 * @sa vtkNBufferDepthExchange vtkNBufferCuller vtkSynchronizedRenderers
 */
#ifndef vtkNBufferParallelDepthExchange_h
#define vtkNBufferParallelDepthExchange_h

#include "vtkNBufferDepthExchange.h"
#include "vtkNBufferParallelModule.h" // For export macro
#include "vtkSmartPointer.h"          // For the controller

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class VTKNBUFFERPARALLEL_EXPORT vtkNBufferParallelDepthExchange : public vtkNBufferDepthExchange
{
public:
  static vtkNBufferParallelDepthExchange* New();
  vtkTypeMacro(vtkNBufferParallelDepthExchange, vtkNBufferDepthExchange);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The processes that draw the renderer, all of them. Without a controller, or with one process,
  /// nothing is exchanged. Default: nullptr.
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  int GetNumberOfRanks() override;
  int GetRank() override;
  /// By vtkMultiProcessController::AllReduce().
  bool ReduceToMinimum(const float* values, float* minima, int count) override;

protected:
  vtkNBufferParallelDepthExchange();
  ~vtkNBufferParallelDepthExchange() override;

private:
  vtkNBufferParallelDepthExchange(const vtkNBufferParallelDepthExchange&) = delete;
  void operator=(const vtkNBufferParallelDepthExchange&) = delete;

  vtkSmartPointer<vtkMultiProcessController> Controller;
};

VTK_ABI_NAMESPACE_END
#endif
