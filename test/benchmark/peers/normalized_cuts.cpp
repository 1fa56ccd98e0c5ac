/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Normalised cuts of a graph.
 */

#include "surface_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Dense>

namespace pcl_cid::benchmarks {
namespace {

using Nodes = std::vector<int>;

/** Size of the Krylov space that a second eigenvector is taken from. */
constexpr int krylov_size = 60;

/** A part of a graph with nodes of its own numbering, and its normalised matrix
 *  D^-1/2 W D^-1/2. */
class Part {
public:
  /** \param[in,out] number scratch, one for each node of the graph, all -1; and again
   *  afterwards */
  Part(const Graph& graph, const Nodes& nodes, std::vector<int>& number)
  : edges_(nodes.size()), root_degree_(static_cast<Eigen::Index>(nodes.size()))
  {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      number[static_cast<std::size_t>(nodes[k])] = static_cast<int>(k);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      double degree = 0.0;
      for (const Edge& edge : graph[static_cast<std::size_t>(nodes[k])])
        if (const int to = number[static_cast<std::size_t>(edge.to)]; to >= 0) {
          edges_[k].push_back({to, edge.weight});
          degree += edge.weight;
        }
      root_degree_[static_cast<Eigen::Index>(k)] = std::sqrt(degree);
    }
    for (const int node : nodes)
      number[static_cast<std::size_t>(node)] = -1;
  }

  const std::vector<std::vector<Edge>>&
  edges() const
  {
    return edges_;
  }

  double
  degree(std::size_t k) const
  {
    const double root = root_degree_[static_cast<Eigen::Index>(k)];
    return root * root;
  }

  /** D^-1/2 times the second eigenvector, from a Krylov space that begins with the
   *  order of the nodes by their distance in edges from the first of them. */
  Eigen::VectorXd
  secondEigenvector() const
  {
    const Eigen::VectorXd first = root_degree_.normalized();
    Eigen::VectorXd q = root_degree_.cwiseProduct(stepsFromOneEnd());
    q -= first * first.dot(q);
    const Eigen::Index steps = std::min<Eigen::Index>(krylov_size, q.size() - 1);
    Eigen::MatrixXd basis(q.size(), steps);
    Eigen::VectorXd diagonal(steps);
    Eigen::VectorXd beside(steps);
    Eigen::Index size = 0;
    double length = q.norm();
    const double negligible = 1e-10 * root_degree_.norm();
    while (size < steps && length > negligible) {
      basis.col(size) = q / length;
      q = times(basis.col(size));
      diagonal[size] = basis.col(size).dot(q);
      ++size;
      // Twice, against rounding: a plain Lanczos recursion loses its orthogonality.
      for (int pass = 0; pass < 2; ++pass) {
        q -= first * first.dot(q);
        q -= basis.leftCols(size) * (basis.leftCols(size).transpose() * q);
      }
      length = q.norm();
      beside[size - 1] = length;
    }
    if (size == 0) // all nodes are alike: any order will do
      return Eigen::VectorXd::LinSpaced(q.size(), 0.0, 1.0);
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal.head(size), beside.head(size - 1));
    const Eigen::VectorXd largest = solver.eigenvectors().col(size - 1);
    return (basis.leftCols(size) * largest).cwiseQuotient(root_degree_);
  }

private:
  Eigen::VectorXd
  times(const Eigen::VectorXd& x) const
  {
    const Eigen::VectorXd scaled = x.cwiseQuotient(root_degree_);
    Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
    for (std::size_t k = 0; k < edges_.size(); ++k)
      for (const Edge& edge : edges_[k])
        product[static_cast<Eigen::Index>(k)] += edge.weight * scaled[edge.to];
    return product.cwiseQuotient(root_degree_);
  }

  Eigen::VectorXd
  steps(int from, int& last) const
  {
    Eigen::VectorXd count = Eigen::VectorXd::Constant(root_degree_.size(), -1.0);
    Nodes queue{from};
    count[from] = 0.0;
    for (std::size_t head = 0; head < queue.size(); ++head)
      for (const Edge& edge : edges_[static_cast<std::size_t>(queue[head])])
        if (count[edge.to] < 0.0) {
          count[edge.to] = count[queue[head]] + 1.0;
          queue.push_back(edge.to);
        }
    last = queue.back();
    return count;
  }

  Eigen::VectorXd
  stepsFromOneEnd() const
  {
    int end = 0;
    steps(0, end);
    int other_end = 0;
    return steps(end, other_end);
  }

  std::vector<std::vector<Edge>> edges_;
  Eigen::VectorXd root_degree_;
};

/** How many of the nodes, in ascending order of their value, are cut off where the
 *  normalised cut is least. */
std::size_t
leastCut(const Part& part, const Eigen::VectorXd& value, const Nodes& order)
{
  double all = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k)
    all += part.degree(k);
  double within = 0.0;
  double cut = 0.0;
  double least = std::numeric_limits<double>::infinity();
  std::size_t best = 1;
  std::vector<char> inside(order.size(), 0);
  for (std::size_t n = 0; n + 1 < order.size(); ++n) {
    const auto k = static_cast<std::size_t>(order[n]);
    for (const Edge& edge : part.edges()[k])
      cut += inside[static_cast<std::size_t>(edge.to)] ? -edge.weight : edge.weight;
    inside[k] = 1;
    within += part.degree(k);
    const double normalised = cut / within + cut / (all - within);
    // Equal values belong together.
    if (normalised < least && value[order[n]] < value[order[n + 1]]) {
      least = normalised;
      best = n + 1;
    }
  }
  return best;
}

/** Connected pieces of some of the nodes. */
std::vector<Nodes>
connectedPieces(const Graph& graph, const Nodes& nodes, std::vector<int>& number)
{
  for (const int node : nodes)
    number[static_cast<std::size_t>(node)] = 0;
  std::vector<Nodes> pieces;
  for (const int node : nodes) {
    if (number[static_cast<std::size_t>(node)] != 0)
      continue;
    Nodes piece{node};
    number[static_cast<std::size_t>(node)] = 1;
    for (std::size_t head = 0; head < piece.size(); ++head)
      for (const Edge& edge : graph[static_cast<std::size_t>(piece[head])])
        if (int& mark = number[static_cast<std::size_t>(edge.to)]; mark == 0) {
          mark = 1;
          piece.push_back(edge.to);
        }
    std::sort(piece.begin(), piece.end());
    pieces.push_back(std::move(piece));
  }
  for (const int node : nodes)
    number[static_cast<std::size_t>(node)] = -1;
  return pieces;
}

std::vector<Nodes>
cutInTwo(const Graph& graph, const Nodes& nodes, std::vector<int>& number)
{
  const Part part(graph, nodes, number);
  const Eigen::VectorXd value = part.secondEigenvector();
  Nodes order(nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
      order.begin(), order.end(), [&](int a, int b) { return value[a] < value[b]; });
  const std::size_t cut = leastCut(part, value, order);
  std::vector<Nodes> sides(2);
  for (std::size_t n = 0; n < order.size(); ++n)
    sides[n < cut ? 0 : 1].push_back(nodes[static_cast<std::size_t>(order[n])]);
  std::vector<Nodes> pieces;
  for (Nodes& side : sides) {
    std::sort(side.begin(), side.end());
    for (Nodes& piece : connectedPieces(graph, side, number))
      pieces.push_back(std::move(piece));
  }
  return pieces;
}

} // namespace

std::vector<int>
cutIntoPatches(const Graph& graph, std::size_t patches)
{
  std::vector<int> number(graph.size(), -1);
  Nodes all(graph.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<Nodes> pieces = connectedPieces(graph, all, number);
  const auto is_smaller = [](const Nodes& a, const Nodes& b) {
    return std::pair(a.size(), b.front()) < std::pair(b.size(), a.front());
  };
  std::make_heap(pieces.begin(), pieces.end(), is_smaller);
  while (pieces.size() < patches && pieces.front().size() > 1) {
    std::pop_heap(pieces.begin(), pieces.end(), is_smaller);
    const Nodes largest = std::move(pieces.back());
    pieces.pop_back();
    for (Nodes& piece : cutInTwo(graph, largest, number)) {
      pieces.push_back(std::move(piece));
      std::push_heap(pieces.begin(), pieces.end(), is_smaller);
    }
  }
  std::vector<int> patch(graph.size());
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (const int node : pieces[k])
      patch[static_cast<std::size_t>(node)] = static_cast<int>(k);
  return patch;
}

} // namespace pcl_cid::benchmarks
