/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Cells, joined by the hull that comes out.
 */

#include "cell.h"
#include "hull_cover.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace pcl_cid {
namespace {

/** Pairs that are compared in parallel, when the next join depends on one of them. */
constexpr std::size_t compared_at_once = 16;

/** Places that are counted at least. */
constexpr double least_limit = 64.0;

/** What a cubic metre of a hull costs, as a share of a cubic metre of free places: what
 *  nobody can use shall stay empty, too. */
constexpr double volume_weight = 0.01;

/** The corners of a hull that are farthest in one of 26 directions. */
std::vector<Eigen::Vector3d>
extremesOf(const FastHull& hull)
{
  std::set<std::size_t> chosen;
  for (int d = 0; d < 27; ++d) {
    const Eigen::Vector3d direction(d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1);
    const auto farthest =
        std::max_element(hull.vertices.begin(),
                         hull.vertices.end(),
                         [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                           return direction.dot(a) < direction.dot(b);
                         });
    if (farthest != hull.vertices.end())
      chosen.insert(static_cast<std::size_t>(farthest - hull.vertices.begin()));
  }
  std::vector<Eigen::Vector3d> extremes;
  for (const std::size_t v : chosen)
    extremes.push_back(hull.vertices[v]);
  return extremes;
}

Eigen::AlignedBox3d
grown(const Eigen::AlignedBox3d& box, double margin)
{
  const Eigen::Vector3d by = Eigen::Vector3d::Constant(margin);
  return {box.min() - by, box.max() + by};
}

/** Joins parts of a scan two at a time. The number of places that some part takes is
 * the sum of what each join takes anew, as a hull holds the hulls that it was made of.
 *
 *  The cost of a pair is a guess at first: that of a pair inside. When it is among the
 *  lowest, a few corners of both parts bound it from below, and only when it still is,
 *  their hull is made. From then on the cost is an upper bound, as places that another
 *  part takes in the meantime are taken already. */
class Merging {
public:
  Merging(const std::vector<Cell>& cells, const FittingScene& scene, Progress& progress)
  : scene_(scene), progress_(progress), taken_(scene.space.size()), left_(cells.size())
  {
    for (const Cell& cell : cells) {
      parts_.push_back({cell, extremesOf(cell.hull), {}, true});
      take(cell);
    }
    Eigen::AlignedBox3d all;
    for (const Part& part : parts_)
      all.extend(boxOf(part.cell.hull));
    extent_ = all.diagonal().norm();
    gap_ = firstGap();
    linkNeighbors();
  }

  std::vector<Cell>
  run(std::size_t parts, ProgressSpan span)
  {
    const std::size_t begun_with = left_;
    while (left_ > parts) {
      const std::vector<Pair> cheapest = findCheapest(1 + (left_ - parts) / 128);
      if (cheapest.empty() && !linkFarther())
        break;
      for (const Pair& pair : cheapest)
        join(pair);
      progress_.check(span.begin + (span.end - span.begin) *
                                       static_cast<double>(begun_with - left_) /
                                       static_cast<double>(begun_with));
    }
    std::vector<Cell> result;
    for (Part& part : parts_)
      if (part.is_alive)
        result.push_back(std::move(part.cell));
    return result;
  }

private:
  static constexpr double impossible = std::numeric_limits<double>::infinity();

  struct Part {
    Cell cell;
    std::vector<Eigen::Vector3d> extremes; ///< a few corners of the hull
    std::set<std::size_t> neighbors;
    bool is_alive;
  };

  /** What is known of a cost. */
  enum class Known { guess, bound, cost };

  struct Pair {
    double cost;
    Known known;
    std::size_t a;
    std::size_t b; ///< above a

    /** Comes later in the queue. */
    bool
    operator<(const Pair& other) const
    {
      return std::tie(other.cost, other.known, other.a, other.b) <
             std::tie(cost, known, a, b);
    }
  };

  void
  take(const Cell& cell)
  {
    for (const PlaceRange& range : cell.near)
      std::fill(taken_.begin() + range.begin, taken_.begin() + range.end, 1);
  }

  void
  link(std::size_t a, std::size_t b, double guess)
  {
    parts_[a].neighbors.insert(b);
    parts_[b].neighbors.insert(a);
    queue_.push({guess, Known::guess, std::min(a, b), std::max(a, b)});
  }

  /** A robot cannot pass between neighbors; or, where the robot is large, they are
   * nearer than a small share of the scan. */
  double
  firstGap() const
  {
    return std::min(std::max(1.5 * scene_.robot_radius, scene_.space.step()),
                    extent_ / 30.0);
  }

  /** Link parts whose boxes are nearer than the gap and that are no neighbors yet. */
  bool
  linkNeighbors()
  {
    std::vector<std::size_t> alive;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (std::size_t a = 0; a < parts_.size(); ++a)
      if (parts_[a].is_alive) {
        alive.push_back(a);
        boxes.push_back(grown(boxOf(parts_[a].cell.hull), 0.5 * gap_));
      }
    bool any = false;
    for (std::size_t i = 0; i < alive.size(); ++i)
      for (std::size_t j = i + 1; j < alive.size(); ++j)
        if (boxes[i].intersects(boxes[j]) &&
            parts_[alive[i]].neighbors.count(alive[j]) == 0) {
          link(alive[i], alive[j], 0.0);
          any = true;
        }
    return any;
  }

  /** When no neighbors are left to join: look for some farther away. False when there
   * are none anywhere. */
  bool
  linkFarther()
  {
    while (gap_ < extent_) {
      gap_ *= 2.0;
      if (linkNeighbors())
        return true;
    }
    return false;
  }

  FastHull
  hullOf(std::size_t a, std::size_t b) const
  {
    return hullOfBoth(parts_[a].cell.hull.vertices, parts_[b].cell.hull.vertices);
  }

  static FastHull
  hullOfBoth(std::vector<Eigen::Vector3d> vertices,
             const std::vector<Eigen::Vector3d>& others)
  {
    vertices.insert(vertices.end(), others.begin(), others.end());
    return fastHull(vertices);
  }

  /** Find out more about the cost of a pair. */
  void
  look(Pair& pair, double limit) const
  {
    if (pair.known == Known::guess) {
      const FastHull inner =
          hullOfBoth(parts_[pair.a].extremes, parts_[pair.b].extremes);
      const double guess = pair.cost;
      if (!inner.faces.empty())
        setCost(pair, inner, limit);
      pair.cost = std::max(pair.cost, guess);
      pair.known = pair.cost == impossible ? Known::cost : Known::bound;
    }
    else {
      const FastHull hull = hullOf(pair.a, pair.b);
      setCost(pair, hull, limit);
      // To certify the bound for all of space takes longer than to count places.
      if (pair.known == Known::cost && !scene_.deep && !scene_.keepsBound(hull))
        pair.cost = impossible;
    }
  }

  /** What a hull takes anew: places, and volume. Counting ends where it exceeds a
   *  limit; the cost is a bound then. */
  void
  setCost(Pair& pair, const FastHull& hull, double limit) const
  {
    // First, as places that no hull may hold are found before the others are counted.
    if (hull.faces.empty() || (scene_.deep && !scene_.keepsBound(hull))) {
      pair = {impossible, Known::cost, pair.a, pair.b};
      return;
    }
    const double volume =
        hull.volume - parts_[pair.a].cell.hull.volume - parts_[pair.b].cell.hull.volume;
    pair.cost = volume_weight * volume / scene_.space.placeVolume();
    const bool is_counted = visitPlacesNear(
        hull, scene_.space, scene_.robot_radius, [&](const PlaceRange& range) {
          pair.cost += static_cast<double>(
              std::count(taken_.begin() + range.begin, taken_.begin() + range.end, 0));
          return pair.cost <= limit;
        });
    pair.known = is_counted ? Known::cost : Known::bound;
  }

  /** Beyond this a pair is not looked at closely: there are much cheaper ones. The cost
   *  of hulls that overlap is below 0, as their volumes are counted twice. */
  double
  limitOf(const std::vector<Pair>& pairs) const
  {
    double cheapest = queue_.empty() ? 0.0 : std::max(queue_.top().cost, 0.0);
    for (const Pair& pair : pairs)
      cheapest = std::max(cheapest, pair.cost);
    return cheapest == impossible ? impossible : least_limit + 2.0 * cheapest;
  }

  bool
  isCurrent(const Pair& pair) const
  {
    return parts_[pair.a].is_alive && parts_[pair.b].is_alive;
  }

  /** The cheapest pairs that have no part in common, in order: at most so many, and
   * none after one that has. */
  std::vector<Pair>
  findCheapest(std::size_t most)
  {
    std::vector<Pair> cheapest;
    std::set<std::size_t> used;
    while (cheapest.size() < most && lookAtCheapest()) {
      const Pair pair = queue_.top();
      if (pair.cost == impossible || used.count(pair.a) != 0 || used.count(pair.b) != 0)
        break;
      queue_.pop();
      cheapest.push_back(pair);
      used.insert({pair.a, pair.b});
    }
    return cheapest;
  }

  /** Look at pairs until the cost of the first one in the queue is known; false when
   *  there is none. */
  bool
  lookAtCheapest()
  {
    for (;;) {
      std::vector<Pair> guesses;
      while (!queue_.empty() && guesses.size() < compared_at_once) {
        const Pair pair = queue_.top();
        if (isCurrent(pair) && pair.known == Known::cost)
          break;
        queue_.pop();
        if (isCurrent(pair))
          guesses.push_back(pair);
      }
      if (guesses.empty())
        return !queue_.empty();
      compare(guesses);
    }
  }

  void
  compare(std::vector<Pair>& pairs)
  {
    const double limit = limitOf(pairs);
    parallelForEach(pairs.size(), scene_.threads, progress_, {}, [&](std::size_t i) {
      look(pairs[i], limit);
    });
    for (const Pair& pair : pairs) {
      known_[{pair.a, pair.b}] = pair.cost;
      queue_.push(pair);
    }
  }

  double
  guess(std::size_t a, std::size_t b) const
  {
    const auto known = known_.find(std::minmax(a, b));
    return known == known_.end() ? 0.0 : known->second;
  }

  void
  join(const Pair& pair)
  {
    Cell cell;
    cell.hull = hullOf(pair.a, pair.b);
    cell.near = placesNear(cell.hull, scene_.space, scene_.robot_radius);
    take(cell);
    const std::size_t made = parts_.size();
    std::vector<Eigen::Vector3d> extremes = extremesOf(cell.hull);
    parts_.push_back({std::move(cell), std::move(extremes), {}, true});
    for (const std::size_t old : {pair.a, pair.b}) {
      parts_[old].is_alive = false;
      const pcl::Indices& points = parts_[old].cell.points;
      pcl::Indices& all = parts_[made].cell.points;
      all.insert(all.end(), points.begin(), points.end());
    }
    std::set<std::size_t> neighbors = parts_[pair.a].neighbors;
    neighbors.insert(parts_[pair.b].neighbors.begin(), parts_[pair.b].neighbors.end());
    for (const std::size_t other : neighbors)
      if (parts_[other].is_alive)
        link(made, other, std::max(guess(pair.a, other), guess(pair.b, other)));
    for (const std::size_t old : {pair.a, pair.b})
      parts_[old].cell = Cell();
    --left_;
  }

  const FittingScene& scene_;
  Progress& progress_;
  std::vector<unsigned char> taken_; ///< for each place, whether a part takes it
  std::size_t left_;
  double extent_ = 0.0;     ///< of the scan, metres
  double gap_ = 0.0;        ///< between neighbors, metres
  std::vector<Part> parts_; ///< the cells, then what was joined, in order
  std::priority_queue<Pair> queue_;
  std::map<std::pair<std::size_t, std::size_t>, double> known_;
};

} // namespace

std::vector<Cell>
mergeCells(const std::vector<Cell>& cells,
           std::size_t parts,
           const FittingScene& scene,
           Progress& progress,
           ProgressSpan span)
{
  return Merging(cells, scene, progress).run(parts, span);
}

} // namespace pcl_cid
