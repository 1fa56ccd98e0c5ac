/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The least width of a convex polytope, over all directions.
 */

#include "hull_width.h"

#include "hull_mesh.h"

#include <algorithm>
#include <vector>

namespace pcl_cid {
namespace {

/** \brief The vertices of a convex mesh, each with those that it shares an edge with.
 *
 *  A vertex with no neighbor farther along a direction is the farthest of all: so
 *  looking for that one is a short walk. */
class VertexGraph {
public:
  VertexGraph(const TriangleMesh& hull, const std::vector<HullEdge>& edges)
  : vertices_(hull.vertices), neighbors_(hull.vertices.size())
  {
    for (const HullEdge& edge : edges) {
      neighbors_[edge.begin].push_back(edge.end);
      neighbors_[edge.end].push_back(edge.begin);
    }
  }

  const Eigen::Vector3d&
  position(std::uint32_t vertex) const
  {
    return vertices_[vertex];
  }

  const std::vector<std::uint32_t>&
  neighborsOf(std::uint32_t vertex) const
  {
    return neighbors_[vertex];
  }

  /** \brief The vertex farthest along a direction. */
  std::uint32_t
  farthest(const Eigen::Vector3d& direction, std::uint32_t start) const
  {
    std::uint32_t best = start;
    double height = direction.dot(vertices_[start]);
    for (bool climbed = true; climbed;) {
      climbed = false;
      for (const std::uint32_t v : neighbors_[best])
        if (const double other = direction.dot(vertices_[v]); other > height) {
          height = other;
          best = v;
          climbed = true;
          break;
        }
    }
    return best;
  }

private:
  const std::vector<Eigen::Vector3d>& vertices_;
  std::vector<std::vector<std::uint32_t>> neighbors_;
};

void
takeIfLess(const Width& width, Width& least)
{
  if (width.width < least.width)
    least = width;
}

/** The vertex that lies opposite each face, and the least of the widths between. */
std::vector<std::uint32_t>
oppositeVertices(const std::vector<HalfSpace>& faces,
                 const VertexGraph& graph,
                 Width& least)
{
  std::vector<std::uint32_t> opposite;
  opposite.reserve(faces.size());
  for (const HalfSpace& face : faces) {
    const std::uint32_t start = opposite.empty() ? 0 : opposite.back();
    opposite.push_back(graph.farthest(-face.normal, start));
    takeIfLess({face.normal, -face.excess(graph.position(opposite.back()))}, least);
  }
  return opposite;
}

/** The smaller of the distances between two points along two directions. Along all
 *  directions between these, it is no smaller: a cosine, where it is positive, is
 *  concave. */
double
leastBetween(const Eigen::Vector3d& from_to,
             const Eigen::Vector3d& one,
             const Eigen::Vector3d& other)
{
  return std::min(from_to.dot(one), from_to.dot(other));
}

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** \brief A hull seen along one of its edges: a polygon, with the edge as a corner.
 *
 *  Between the normals of the edge's two faces, the width is that between this corner
 *  and the polygon's other side. It is least along one of the two normals, or across a
 *  side of the polygon; those are visited as by rotating calipers. */
class ViewAlongEdge {
public:
  ViewAlongEdge(const VertexGraph& graph,
                const HullEdge& edge,
                const std::vector<HalfSpace>& faces)
  : graph_(graph)
  , corner_(edge.begin)
  , x_axis_(faces[edge.triangle].normal)
  , y_axis_(faces[edge.neighbor].normal)
  {
    const Eigen::Vector3d second_normal = y_axis_;
    y_axis_ -= y_axis_.dot(x_axis_) * x_axis_;
    y_axis_.normalize();
    last_ = {second_normal.dot(x_axis_), second_normal.dot(y_axis_)};
  }

  /** \brief Lower \a least, if the hull is thinner somewhere between the normals.
   *  \param[in] opposite the vertex opposite the first face
   *  \param[in] most_steps more than the corners there can be */
  void
  improve(std::uint32_t opposite, std::size_t most_steps, Width& least) const
  {
    std::uint32_t at = opposite;
    for (std::size_t step = 0; step < most_steps; ++step) {
      const std::uint32_t next = nextCorner(at);
      const Eigen::Vector2d side = seen(at, next);
      const Eigen::Vector2d direction(-side.y(), side.x());
      if (!(cross(direction, last_) > 0.0))
        return;
      takeIfLess(widthAlong(direction, at), least);
      at = next;
    }
  }

private:
  /** The way from one vertex to another, as it is seen. */
  Eigen::Vector2d
  seen(std::uint32_t from, std::uint32_t to) const
  {
    const Eigen::Vector3d way = graph_.position(to) - graph_.position(from);
    return {way.dot(x_axis_), way.dot(y_axis_)};
  }

  /** The next corner, counter-clockwise: all vertices lie to the left of the way there.
   *  It shares an edge with this one. */
  std::uint32_t
  nextCorner(std::uint32_t at) const
  {
    std::uint32_t best = at;
    Eigen::Vector2d best_way = Eigen::Vector2d::Zero();
    for (const std::uint32_t v : graph_.neighborsOf(at)) {
      const Eigen::Vector2d way = seen(at, v);
      const double turn = cross(best_way, way);
      if (turn < 0.0 || (turn == 0.0 && way.squaredNorm() > best_way.squaredNorm())) {
        best = v;
        best_way = way;
      }
    }
    return best;
  }

  Width
  widthAlong(const Eigen::Vector2d& seen_direction, std::uint32_t opposite) const
  {
    const Eigen::Vector3d direction =
        (seen_direction.x() * x_axis_ + seen_direction.y() * y_axis_).normalized();
    const std::uint32_t high = graph_.farthest(direction, corner_);
    const std::uint32_t low = graph_.farthest(-direction, opposite);
    return {direction, direction.dot(graph_.position(high) - graph_.position(low))};
  }

  const VertexGraph& graph_;
  std::uint32_t corner_;
  Eigen::Vector3d x_axis_; ///< the first normal
  Eigen::Vector3d y_axis_;
  Eigen::Vector2d last_; ///< the second normal
};

} // namespace

Width
leastWidth(const TriangleMesh& hull)
{
  const std::vector<HalfSpace> faces = halfSpacesOf(hull);
  const std::vector<HullEdge> edges = edgesOf(hull);
  const VertexGraph graph(hull, edges);
  Width least;
  const std::vector<std::uint32_t> opposite = oppositeVertices(faces, graph, least);
  for (const HullEdge& edge : edges) {
    const Eigen::Vector3d& first = faces[edge.triangle].normal;
    const Eigen::Vector3d& second = faces[edge.neighbor].normal;
    const auto bound = [&](std::uint32_t vertex) {
      return leastBetween(
          graph.position(edge.begin) - graph.position(vertex), first, second);
    };
    if (std::max(bound(opposite[edge.triangle]), bound(opposite[edge.neighbor])) <
        least.width)
      ViewAlongEdge(graph, edge, faces)
          .improve(opposite[edge.triangle], hull.vertices.size(), least);
  }
  return least;
}

} // namespace pcl_cid
