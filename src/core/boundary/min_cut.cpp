/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A minimum cut of a graph with a source and a sink.
 */

#include "min_cut.h"

#include <utility>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

namespace pcl_cid {
namespace {

using Arcs = boost::compressed_sparse_row_graph<boost::directedS>;
using Arc = Arcs::edge_descriptor;
using Ends = std::pair<std::size_t, std::size_t>;

/** The graph as Boost wants it: an arc there and one back for each edge, sorted by
 *  where they begin. */
class FlowGraph {
public:
  explicit FlowGraph(const CutGraph& graph)
  : nodes_(graph.from_source.size()), next_(nodes_ + 2, 0)
  {
    visitEdges(graph, [&](std::size_t a, std::size_t b, std::int64_t, std::int64_t) {
      ++next_[a];
      ++next_[b];
    });
    std::size_t arcs = 0;
    for (std::size_t& next : next_)
      arcs += std::exchange(next, arcs);
    ends_.resize(arcs);
    capacity_.resize(arcs);
    reverse_.resize(arcs);
    visitEdges(
        graph,
        [&](std::size_t a, std::size_t b, std::int64_t there, std::int64_t back) {
          const std::size_t forth = next_[a]++;
          const std::size_t home = next_[b]++;
          add(forth, {a, b}, there, home);
          add(home, {b, a}, back, forth);
        });
  }

  /** What can be reached from the source when the flow is largest. */
  std::vector<bool>
  reachedBySource()
  {
    Arcs arcs(boost::edges_are_sorted, ends_.begin(), ends_.end(), nodes_ + 2);
    const auto of_arc = get(boost::edge_index, arcs);
    const auto of_node = get(boost::vertex_index, arcs);
    std::vector<std::int64_t> rest(ends_.size());
    std::vector<Arc> parent(nodes_ + 2);
    std::vector<boost::default_color_type> tree(nodes_ + 2);
    std::vector<long> distance(nodes_ + 2);
    boost::boykov_kolmogorov_max_flow(
        arcs,
        boost::make_iterator_property_map(capacity_.begin(), of_arc),
        boost::make_iterator_property_map(rest.begin(), of_arc),
        boost::make_iterator_property_map(reverse_.begin(), of_arc),
        boost::make_iterator_property_map(parent.begin(), of_node),
        boost::make_iterator_property_map(tree.begin(), of_node),
        boost::make_iterator_property_map(distance.begin(), of_node),
        of_node,
        source(),
        sink());
    std::vector<bool> reached(nodes_);
    for (std::size_t node = 0; node < nodes_; ++node)
      reached[node] = tree[node] == boost::black_color;
    return reached;
  }

private:
  std::size_t
  source() const
  {
    return nodes_;
  }

  std::size_t
  sink() const
  {
    return nodes_ + 1;
  }

  /** Arcs to the terminals come first, as they are looked for. */
  template <typename Visit>
  void
  visitEdges(const CutGraph& graph, const Visit& visit) const
  {
    for (std::size_t node = 0; node < nodes_; ++node) {
      const std::int64_t capacity = graph.from_source[node];
      if (capacity > 0)
        visit(source(), node, capacity, 0);
      else if (capacity < 0)
        visit(node, sink(), -capacity, 0);
    }
    for (const CutGraph::Edge& edge : graph.edges)
      visit(edge.first, edge.second, edge.capacity, edge.capacity);
  }

  void
  add(std::size_t arc, Ends ends, std::int64_t capacity, std::size_t reverse)
  {
    ends_[arc] = ends;
    capacity_[arc] = capacity;
    reverse_[arc] = Arc(ends.second, reverse);
  }

  std::size_t nodes_;
  std::vector<std::size_t> next_; ///< of each node: where its next arc goes
  std::vector<Ends> ends_;
  std::vector<std::int64_t> capacity_;
  std::vector<Arc> reverse_;
};

} // namespace

std::vector<bool>
smallestSourceSide(const CutGraph& graph)
{
  return FlowGraph(graph).reachedBySource();
}

} // namespace pcl_cid
