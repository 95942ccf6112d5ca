// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class Mode
 * @brief A set of cullers, or a render pass, that takes its turn in the one renderer that all modes
 * share.
 *
 * All modes share props, buffers and textures. Each mode has its own cullers, which know only the
 * frames of their mode, and its own render pass, if it has one. Enter() restores the cullers in the
 * order that they had at Leave().
 */
#ifndef Mode_h
#define Mode_h

#include "VisibleProps.h"

#include "QueryCuller.h"

#include "vtkNBufferCuller.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRenderPass;
class vtkRenderer;

namespace NBufferBench
{

class Mode
{
public:
  /// stock: VTK's default culler. none: no culler. nbuffer: the default culler and
  /// vtkNBufferCuller, added as a user adds it, or with settings, see ModeSettings.h. oracle:
  /// exactly the props that own a pixel. in-view: exactly the props in the view frustum.
  /// same-list: what nbuffer draws of composite data (SameList.h), without tests. queries,
  /// queries-conservative, queries-count: an occlusion query for each prop, of the exact, the
  /// conservative or the counting kind; the mode waits for each answer. chc: coherent hierarchical
  /// culling by exact queries. early-depth: stock, each prop first without colours; with the
  /// suffix -nbuffer together with vtkNBufferCuller. The back-end of nbuffer is auto, opengl or
  /// cpu. Throws std::runtime_error for an unknown name.
  explicit Mode(const std::string& name, const std::string& backend = "auto");

  const std::string& GetName() const { return this->Name; }
  /// Returns why the current context cannot run a mode, or an empty text if it can.
  static std::string WhyNot(const std::string& name);

  ///@{
  /// Return nullptr in modes that have no such culler.
  vtkNBufferCuller* GetNBufferCuller() { return this->NBuffer; }
  /// The culler of oracle, in-view and same-list, which must be given the props of each frame.
  OracleCuller* GetOracleCuller() { return this->Oracle; }
  NBufferPeers::QueryCuller* GetQueryCuller() { return this->Queries; }
  ///@}

  /// Returns the number of props that the last frame drew. The renderer does not count those that a
  /// pass has drawn.
  int CountDrawn(vtkRenderer* renderer) const;

  void Enter(vtkRenderer* renderer);
  void Leave(vtkRenderer* renderer);

private:
  std::string Name;
  std::vector<vtkSmartPointer<vtkCuller>> Cullers;
  vtkSmartPointer<vtkNBufferCuller> NBuffer;
  vtkSmartPointer<OracleCuller> Oracle;
  vtkSmartPointer<NBufferPeers::QueryCuller> Queries;
  vtkSmartPointer<vtkRenderPass> Pass; ///< Of the renderer, or nullptr.
};

} // namespace NBufferBench

#endif
