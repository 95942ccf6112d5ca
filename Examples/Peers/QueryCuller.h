// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class QueryCuller
 * @brief Occlusion culling by queries of the hardware, each a draw: a peer to compare with.
 *
 * Every plain opaque prop (vtkNBufferCandidate) is drawn by one prop at the end of the renderer's
 * list, which queries and draws by turns (FlatQueries.h, CoherentQueries.h). Caches, frustum test
 * and the order of equal depths are those of vtkNBufferCuller: props that may tie with one drawn
 * after them are drawn once more (vtkNBufferTieOrder.h), so that the image is that of VTK alone,
 * byte for byte.
 *
 * For one renderer without render passes, depth peeling of held props or selection while it is
 * attached: a peer of a study, not a culler to ship. Where queries are missing it draws everything
 * and GetError() says why.
 */
#ifndef QueryCuller_h
#define QueryCuller_h

#include "BoxQueries.h"

#include "vtkCuller.h"

#include <memory>
#include <string>

namespace NBufferPeers
{

enum class QueryMethod
{
  Flat,    ///< One query for each prop, each waited for.
  Coherent ///< Coherent hierarchical culling.
};

/// Of the last frame.
struct QueryStatistics
{
  int InView = 0;        ///< Props that could be culled and are in view.
  int Queries = 0;       ///< Boxes drawn.
  int Waits = 0;         ///< Answers that were not there when they were needed.
  double WaitTime = 0.0; ///< Milliseconds spent in getting answers.
  int Nodes = 0;         ///< Of the tree; 0 without one.
  int Visits = 0;        ///< Of these, those looked at and in view.
  int Drawn = 0;         ///< Of the props in view.
  int Hidden = 0;        ///< Of the props in view; Drawn + Hidden is InView.
  int Redrawn = 0;       ///< Draws for the order of equal depths.
};

class QueryCuller : public vtkCuller
{
public:
  static QueryCuller* New();
  vtkTypeMacro(QueryCuller, vtkCuller);

  /// Flat and Any before they are set.
  void SetMethod(QueryMethod method);
  void SetTarget(QueryTarget target);

  const QueryStatistics& GetStatistics() const;

  /// Why the last frame drew everything; empty if it did not.
  const std::string& GetError() const;

  double Cull(
    vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized) override;

protected:
  QueryCuller();
  ~QueryCuller() override;

private:
  QueryCuller(const QueryCuller&) = delete;
  void operator=(const QueryCuller&) = delete;

  class Internals;
  std::unique_ptr<Internals> Implementation;
};

} // namespace NBufferPeers

#endif
