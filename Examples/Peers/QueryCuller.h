// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class QueryCuller
 * @brief Occlusion culling by hardware occlusion queries, each of which draws a box, to compare
 * vtkNBufferCuller with.
 *
 * One prop at the end of the renderer's list draws all plain opaque props (vtkNBufferCandidate),
 * and alternates between queries and draws (FlatQueries.h, CoherentQueries.h). Caches, frustum test
 * and the order of equal depths are those of vtkNBufferCuller: props that may have the
 * same depth as one drawn after them are drawn once more (vtkNBufferTieOrder.h), so that the image
 * is that of VTK alone, byte for byte.
 *
 * This class serves one renderer without render passes, depth peeling and selection. It is made for
 * comparisons, not for applications. Where queries are missing it draws everything, and GetError()
 * returns the cause.
 */
#ifndef QueryCuller_h
#define QueryCuller_h

#include "BoxQueries.h"
#include "CoherentQueries.h"
#include "DrawStage.h"

#include "vtkNBufferCandidateList.h"

#include "vtkCuller.h"
#include "vtkNew.h"

#include <string>
#include <vector>

namespace NBufferPeers
{

enum class QueryMethod
{
  Flat,    ///< One query for each prop; each answer is awaited (FlatQueries.h).
  Coherent ///< Coherent hierarchical culling (CoherentQueries.h).
};

/// The numbers of the last frame.
struct QueryStatistics
{
  int InView = 0;        ///< Props that could be culled and are in view.
  int Queries = 0;       ///< Boxes that were drawn.
  int Waits = 0;         ///< Answers that had not arrived when they were needed.
  double WaitTime = 0.0; ///< Milliseconds spent in getting answers.
  int Nodes = 0;         ///< Nodes of the tree; 0 without a tree.
  int Visits = 0;        ///< Nodes that were visited and are in view.
  int Drawn = 0;         ///< Props in view that were drawn.
  int Hidden = 0;        ///< Props in view that were not drawn; Drawn + Hidden is InView.
  int Redrawn = 0;       ///< Draws that were repeated for the order of equal depths.
};

class QueryCuller
  : public vtkCuller
  , private QueryHost
{
public:
  static QueryCuller* New();
  vtkTypeMacro(QueryCuller, vtkCuller);

  ///@{
  /// Set the method and the kind of queries. The defaults are Flat and Any.
  void SetMethod(QueryMethod method) { this->Method = method; }
  void SetTarget(QueryTarget target) { this->Target = target; }
  ///@}

  /// Returns the numbers of the last frame.
  const QueryStatistics& GetStatistics() const { return this->Statistics; }

  /// Returns why the last frame drew everything, or an empty text if it did not.
  const std::string& GetError() const { return this->Error; }

  double Cull(
    vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized) override;

protected:
  QueryCuller();

private:
  QueryCuller(const QueryCuller&) = delete;
  void operator=(const QueryCuller&) = delete;

  PlacedBox Place(const vtkNBufferBox& box) override;
  int Query(const PlacedBox& box) override;
  bool HasAnswer(int query) override { return this->Queries.HasAnswer(query); }
  bool IsVisible(int query) override;
  void Draw(int prop) override;

  bool SetView(vtkRenderer* renderer);
  int DrawProps(vtkRenderer* renderer);
  void DrawByTree(bool changed);
  void Redraw();

  QueryMethod Method = QueryMethod::Flat;
  QueryTarget Target = QueryTarget::Any;
  QueryStatistics Statistics;
  std::string Error;
  vtkNew<DrawStage> Stage;
  vtkNBufferProjection Projection;
  vtkNBufferCandidateList Props;
  std::vector<int> Candidates; ///< Places in Props of those that are left to the stage.
  BoxQueries Queries;
  CoherentQueries Tree;
  bool TreeIsOld = true;
  int Samples = 0; ///< The samples per pixel of the framebuffer.
  vtkRenderer* Renderer = nullptr;
  std::vector<vtkNBufferDrawnProp> Drawn;
};

} // namespace NBufferPeers

#endif
