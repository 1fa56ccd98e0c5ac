/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How many places that a robot could use hulls refuse, and what else they get wrong.
 */

#include "refused_places.h"

#include "base/parallel_for.h"
#include "base/sentence.h"
#include "hull/hull_samples.h"
#include "portable_draw.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl_cid::benchmarks {
namespace {

/** Call \a body(i) for each item; what it writes must belong to the item. */
template <typename Body>
void
forEachItem(std::size_t count, std::size_t grain, unsigned threads, const Body& body)
{
  Progress progress({});
  parallelFor(count,
              grain,
              threadCount(threads),
              progress,
              {0.0, 1.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                  body(i);
              });
}

DistanceField::Options
fieldWith(unsigned threads)
{
  DistanceField::Options options;
  options.execution.threads = threads;
  return options;
}

std::vector<Eigen::Vector3d>
inFrame(std::vector<Eigen::Vector3d> places, const Frame& frame)
{
  for (Eigen::Vector3d& place : places)
    place = frame.toLocal(place);
  return places;
}

/** Samples of a hull: as many as its share of the volume of all, but some. */
std::vector<Eigen::Vector3d>
samplesOf(const TriangleMesh& hull, double volume_of_all)
{
  constexpr double samples_of_all = 1 << 18;
  constexpr double fewest = 64;
  const double share = volumeOf(hull) / volume_of_all;
  return volumeSamples(
      hull, static_cast<std::size_t>(std::max(fewest, samples_of_all * share)));
}

/** The share of a hull that is in none of those before it, and the part of this share
 *  that is free. */
struct OwnShare {
  double all = 0.0;
  double free = 0.0;
};

OwnShare
ownShareOf(std::size_t number,
           const std::vector<Eigen::Vector3d>& samples,
           const std::vector<ConvexBody>& bodies,
           const SeenSpace& space)
{
  const auto end = bodies.begin() + static_cast<std::ptrdiff_t>(number);
  const double weight = 1.0 / static_cast<double>(samples.size());
  OwnShare share;
  for (const Eigen::Vector3d& x : samples) {
    if (std::any_of(
            bodies.begin(), end, [&](const ConvexBody& b) { return b.contains(x); }))
      continue;
    share.all += weight;
    share.free += space.isFree(x) ? weight : 0.0;
  }
  return share;
}

} // namespace

RefusedPlaces::RefusedPlaces(const PointSet& scan,
                             const std::vector<Eigen::Vector3d>& viewpoints,
                             const PlaceOptions& options)
: options_(options)
, scan_(scan)
, field_(scan.points, fieldWith(options.sight.threads))
, space_(scan.points, inFrame(viewpoints, scan.frame), options.sight)
, places_(drawPlaces())
{
}

bool
RefusedPlaces::isPlace(const Eigen::Vector3f& x) const
{
  return space_.isFree(x.cast<double>()) &&
         static_cast<double>(field_.distance(x)) >= options_.robot_radius;
}

Points
RefusedPlaces::drawPlaces() const
{
  constexpr std::size_t at_once = 1 << 14;
  constexpr std::size_t most_draws = 1000; // for a place
  const std::size_t most_rounds = 1 + options_.places * most_draws / at_once;
  RandomGenerator generator(options_.random_seed);
  const Eigen::Vector3d& low = space_.box().min();
  const Eigen::Vector3d& high = space_.box().max();
  Points places;
  for (std::size_t round = 0; round < most_rounds; ++round) {
    Points drawn(at_once);
    for (Eigen::Vector3f& x : drawn)
      for (int axis = 0; axis < 3; ++axis)
        x[axis] =
            static_cast<float>(test::drawWithin(generator, {low[axis], high[axis]}));
    std::vector<char> is_place(at_once);
    forEachItem(at_once, 256, options_.sight.threads, [&](std::size_t i) {
      is_place[i] = isPlace(drawn[i]);
    });
    for (std::size_t i = 0; i < at_once && places.size() < options_.places; ++i)
      if (is_place[i])
        places.push_back(drawn[i]);
    if (places.size() == options_.places)
      return places;
  }
  throw CIDException(sentence("of ",
                              at_once * most_rounds,
                              " places in the box of the scan, ",
                              places.size(),
                              " are free and ",
                              options_.robot_radius,
                              " metres from every point; there must be ",
                              options_.places,
                              ": a smaller radius or other viewpoints may find them"));
}

RefusalFigures
RefusedPlaces::measure(const std::vector<ConvexPart>& hulls) const
{
  RefusalFigures figures;
  std::vector<TriangleMesh> meshes;
  for (const ConvexPart& part : hulls) {
    meshes.push_back({inFrame(part.hull.vertices, scan_.frame), part.hull.triangles});
    figures.volume_sum += part.volume;
  }
  figures.hulls = hulls.size();
  const std::vector<ConvexBody> bodies(meshes.begin(), meshes.end());
  figures.refused = refusedShare(bodies);
  countMissed(bodies, figures);
  measureVolumes(meshes, bodies, figures);
  figures.deepest = deepestIn(bodies);
  return figures;
}

double
RefusedPlaces::refusedShare(const std::vector<ConvexBody>& bodies) const
{
  const double radius = options_.robot_radius;
  std::vector<char> is_refused(places_.size());
  forEachItem(places_.size(), 64, options_.sight.threads, [&](std::size_t i) {
    is_refused[i] = distanceUpTo(radius, bodies, places_[i].cast<double>()) < radius;
  });
  return static_cast<double>(std::count(is_refused.begin(), is_refused.end(), 1)) /
         static_cast<double>(is_refused.size());
}

void
RefusedPlaces::countMissed(const std::vector<ConvexBody>& bodies,
                           RefusalFigures& figures) const
{
  constexpr double beyond_all = 2.0 * miss_distances.back();
  const Points& points = scan_.points;
  std::vector<double> distance(points.size());
  forEachItem(points.size(), 256, options_.sight.threads, [&](std::size_t i) {
    distance[i] = distanceUpTo(beyond_all, bodies, points[i].cast<double>());
  });
  for (std::size_t k = 0; k < miss_distances.size(); ++k)
    figures.missed[k] = static_cast<std::size_t>(
        std::count_if(distance.begin(), distance.end(), [&](double d) {
          return d > miss_distances[k];
        }));
}

void
RefusedPlaces::measureVolumes(const std::vector<TriangleMesh>& hulls,
                              const std::vector<ConvexBody>& bodies,
                              RefusalFigures& figures) const
{
  std::vector<OwnShare> shares(hulls.size());
  forEachItem(hulls.size(), 1, options_.sight.threads, [&](std::size_t k) {
    shares[k] = ownShareOf(k, samplesOf(hulls[k], figures.volume_sum), bodies, space_);
  });
  for (std::size_t k = 0; k < hulls.size(); ++k) {
    const double volume = volumeOf(hulls[k]);
    figures.union_volume += shares[k].all * volume;
    figures.free_volume += shares[k].free * volume;
  }
}

double
RefusedPlaces::deepestIn(const std::vector<ConvexBody>& bodies) const
{
  constexpr std::size_t at_once = 4096;
  std::vector<float> deepest((space_.size() + at_once - 1) / at_once, 0.0f);
  forEachItem(space_.size(), at_once, options_.sight.threads, [&](std::size_t voxel) {
    float& known = deepest[voxel / at_once];
    if (!space_.isFree(voxel))
      return;
    const Eigen::Vector3d center = space_.grid().centerOf(voxel);
    const Eigen::Vector3f x = center.cast<float>();
    if (field_.bounds(x).high > known && containedIn(bodies, center))
      known = std::max(known, field_.distance(x));
  });
  return static_cast<double>(*std::max_element(deepest.begin(), deepest.end()));
}

} // namespace pcl_cid::benchmarks
