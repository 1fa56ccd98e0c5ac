/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A small, nasty cloud with settings, all drawn from one number.
 */

#include "torture_case.h"

#include "base/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <pcl/search/kdtree.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {
namespace {

constexpr float no_coordinate = std::numeric_limits<float>::quiet_NaN();

/** Draws in the words of the case. */
class Dice {
public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}

  std::size_t
  below(std::size_t count)
  {
    return drawBelow(generator_, count);
  }

  int
  between(int least, int most)
  {
    return least + static_cast<int>(below(static_cast<std::size_t>(most - least) + 1));
  }

  bool
  oneIn(std::size_t count)
  {
    return below(count) == 0;
  }

  /** 0 to 1, on a fine grid. */
  float
  share()
  {
    return static_cast<float>(below(1u << 20)) / static_cast<float>(1u << 20);
  }

  Eigen::Vector3f
  inCube()
  {
    const float x = share();
    const float y = share();
    const float z = share();
    return {x, y, z};
  }

  /** Of any of the orders of magnitude, base 2. */
  float
  magnitude(int least, int most)
  {
    return std::ldexp(1.0f + share(), between(least, most));
  }

private:
  RandomGenerator generator_;
};

using Shape = Eigen::Vector3f (*)(Dice&);

struct NamedShape {
  const char* name;
  Shape draw;
};

Eigen::Vector3f
onBox(Dice& dice)
{
  Eigen::Vector3f p = dice.inCube();
  p[dice.between(0, 2)] = dice.oneIn(2) ? 0.0f : 1.0f;
  return p;
}

const std::array<NamedShape, 9> shapes = {{
    {"cube", [](Dice& dice) { return dice.inCube(); }},
    {"two boxes",
     [](Dice& dice) -> Eigen::Vector3f {
       return onBox(dice) + (dice.oneIn(2) ? 2.5f : 0.0f) * Eigen::Vector3f(1, 0, 0.1f);
     }},
    {"flat",
     [](Dice& dice) -> Eigen::Vector3f {
       return dice.inCube().cwiseProduct(Eigen::Vector3f(1, 1, 0));
     }},
    {"tilted",
     [](Dice& dice) {
       const Eigen::Vector3f p = dice.inCube();
       return Eigen::Vector3f(p.x(), p.y(), 0.3f * p.x() + 0.7f * p.y());
     }},
    {"line",
     [](Dice& dice) -> Eigen::Vector3f {
       return dice.share() * Eigen::Vector3f(0.3f, -0.2f, 0.7f);
     }},
    {"one place", [](Dice&) { return Eigen::Vector3f(0.3f, -0.2f, 0.7f); }},
    {"grid",
     [](Dice& dice) -> Eigen::Vector3f {
       return (4.0f * dice.inCube()).array().floor();
     }},
    {"huge and tiny",
     [](Dice& dice) -> Eigen::Vector3f {
       return dice.inCube() * (dice.oneIn(9) ? 500.0f : 1e-4f);
     }},
    {"every size",
     [](Dice& dice) -> Eigen::Vector3f {
       return (dice.inCube() - Eigen::Vector3f::Constant(0.5f)) *
              std::ldexp(1.0f, -dice.between(0, 90));
     }},
}};

std::size_t
drawCount(Dice& dice)
{
  switch (dice.below(10)) {
  case 0:
    return 1 + dice.below(5);
  case 1:
    return 100 + dice.below(200);
  default:
    return 6 + dice.below(70);
  }
}

/** Where the cloud is, and how large. */
struct Place {
  float scale = 1.0f;
  Eigen::Vector3f offset = Eigen::Vector3f::Zero();
};

Place
drawPlace(Dice& dice)
{
  Place place;
  if (dice.oneIn(3))
    place.scale = dice.magnitude(-12, 12);
  if (dice.oneIn(12))
    place.scale = dice.magnitude(-120, 60);
  if (dice.oneIn(3))
    place.offset = (dice.inCube() - Eigen::Vector3f::Constant(0.5f)) * place.scale *
                   std::ldexp(1.0f, dice.between(0, 20));
  return place;
}

TortureCloud::Ptr
drawCloud(const NamedShape& shape, const Place& place, std::size_t count, Dice& dice)
{
  auto cloud = pcl::make_shared<TortureCloud>();
  const bool repeats = dice.oneIn(4);
  for (std::size_t i = 0; i < count; ++i) {
    if (repeats && i > 0 && dice.oneIn(2)) {
      cloud->push_back((*cloud)[dice.below(i)]);
      continue;
    }
    TorturePoint point;
    point.getVector3fMap() = place.scale * shape.draw(dice) + place.offset;
    point.r = static_cast<std::uint8_t>(dice.below(256));
    point.g = static_cast<std::uint8_t>(dice.below(3));
    point.b = static_cast<std::uint8_t>(dice.oneIn(2) ? 255 : 0);
    cloud->push_back(point);
  }
  return cloud;
}

void
spoil(TortureCloud& cloud, Dice& dice)
{
  constexpr std::array<float, 3> bad = {no_coordinate,
                                        std::numeric_limits<float>::infinity(),
                                        -std::numeric_limits<float>::infinity()};
  for (TorturePoint& point : cloud)
    if (dice.oneIn(8))
      point.data[dice.below(3)] = bad[dice.below(bad.size())];
  cloud.is_dense = false;
}

void
drawPose(TortureCloud& cloud, const Place& place, Dice& dice)
{
  if (dice.oneIn(2))
    return;
  cloud.sensor_origin_.head<3>() = place.offset + place.scale * dice.inCube();
  cloud.sensor_orientation_ = Eigen::Quaternionf(
      dice.share(), dice.share(), dice.share() - 0.5f, dice.share() - 0.5f);
  if (dice.oneIn(8))
    cloud.sensor_orientation_.coeffs().setZero();
  if (dice.oneIn(8))
    cloud.sensor_orientation_.x() = no_coordinate;
  if (dice.oneIn(8))
    cloud.sensor_origin_.y() = no_coordinate;
}

/** In any order, some twice. */
pcl::Indices
drawIndices(std::size_t points, Dice& dice)
{
  pcl::Indices indices;
  for (std::size_t n = 1 + dice.below(2 * points); n > 0; --n)
    indices.push_back(static_cast<pcl::index_t>(dice.below(points)));
  return indices;
}

PreparationSettings
drawPreparation(std::size_t points, float size, Dice& dice)
{
  PreparationSettings settings;
  settings.random_seed = dice.below(1000);
  if (dice.oneIn(4))
    settings.subsample = dice.between(1, static_cast<int>(points) + 3);
  if (dice.oneIn(3))
    settings.start_index = static_cast<pcl::index_t>(dice.below(points));
  if (dice.oneIn(4))
    settings.seed_candidates =
        pcl::make_shared<pcl::Indices>(drawIndices(points, dice));
  constexpr std::array<DensityWeight, 3> densities = {
      DensityWeight::automatic, DensityWeight::on, DensityWeight::off};
  settings.density = densities[dice.below(3)];
  settings.density_power = dice.oneIn(2) ? 1.0f : 4.0f * dice.share();
  settings.isolated_neighbors = dice.between(0, 8);
  if (dice.oneIn(3))
    settings.color = size * dice.magnitude(-12, 2);
  if (dice.oneIn(3))
    settings.normals = size * dice.magnitude(-12, 2);
  settings.connected = dice.oneIn(3);
  settings.blind_spot = dice.oneIn(2);
  settings.memory_budget = dice.oneIn(3) ? dice.below(20000) : 0;
  return settings;
}

MergeCut
drawCut(float size, Dice& dice)
{
  using Rule = MergeCut::Rule;
  constexpr std::array<Rule, 4> rules = {
      Rule::elbow, Rule::merges, Rule::parts, Rule::threshold};
  MergeCut cut;
  cut.rule = rules[dice.below(rules.size())];
  cut.count = 1 + dice.below(8);
  cut.height = static_cast<double>(size * dice.magnitude(-9, 1));
  return cut;
}

ConvexPartOptions
drawHull(float size, Dice& dice)
{
  ConvexPartOptions hull;
  if (dice.oneIn(2))
    hull.min_thickness = std::min(
        std::max(static_cast<double>(size * dice.magnitude(-30, 3)), 1e-15), 1e15);
  if (dice.oneIn(2))
    hull.max_vertices = 4 + dice.below(20);
  if (dice.oneIn(3))
    hull.padding = static_cast<double>(size * dice.magnitude(-12, 1));
  if (dice.oneIn(3))
    hull.trim_distance = static_cast<double>(size * dice.magnitude(-8, 0));
  return hull;
}

/** Above, at and below the least thickness; below the spacing; or generous. */
double
drawBound(float size, double thickness, Dice& dice)
{
  double bound = static_cast<double>(size * dice.magnitude(-4, 1));
  if (dice.oneIn(4))
    bound = static_cast<double>(size * dice.magnitude(-14, -5));
  if (dice.oneIn(4))
    bound = thickness * (dice.oneIn(4) ? 1.0 : dice.magnitude(-1, 4));
  return std::clamp(bound, setting::max_error.least, setting::max_error.most);
}

double
drawRobot(float size, Dice& dice)
{
  switch (dice.below(4)) {
  case 0:
    return 0.0;
  case 1:
    return static_cast<double>(size * dice.magnitude(-30, -6));
  case 2:
    return std::min(static_cast<double>(size * dice.magnitude(1, 30)), 1e15);
  default:
    return static_cast<double>(size * dice.magnitude(-6, 0));
  }
}

/** In a point, inside of the cloud, outside, far away, or nowhere. */
Eigen::Vector3d
drawViewpoint(const TortureCloud& cloud, const Place& place, Dice& dice)
{
  const auto about = [&](float size) -> Eigen::Vector3d {
    const Eigen::Vector3f p = dice.inCube() - Eigen::Vector3f::Constant(0.3f);
    return (place.offset + place.scale * size * p).cast<double>();
  };
  switch (dice.below(8)) {
  case 0:
    return cloud[dice.below(cloud.size())].getVector3fMap().cast<double>();
  case 1:
    return about(4.0f);
  case 2:
    return about(dice.magnitude(4, 50));
  case 3:
    return about(1.0f) * (dice.oneIn(4) ? 1e300 : 1.0);
  case 4:
    return dice.oneIn(4) ? Eigen::Vector3d(0.0, double{no_coordinate}, 0.0)
                         : about(1.0f);
  default:
    return about(1.0f);
  }
}

/** The longest side of the box around the finite points. */
double
extentOf(const TortureCloud& cloud)
{
  Eigen::AlignedBox3d box;
  for (const TorturePoint& point : cloud)
    if (point.getVector3fMap().allFinite())
      box.extend(point.getVector3fMap().cast<double>());
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

FittingCase
drawFitting(const TortureCloud& cloud,
            const Place& place,
            float size,
            double thickness,
            Dice& dice)
{
  FittingCase fitting{};
  HullFittingSettings& settings = fitting.settings;
  // It takes long next to all else: not in every case, seldom of many points, and
  // seldom with a bound.
  fitting.is_checked = dice.oneIn(cloud.size() > 80 ? 24 : 3);
  fitting.has_parts = !dice.oneIn(8);
  settings.parts = 1 + dice.below(dice.oneIn(4) ? 80 : 6);
  settings.robot_radius = drawRobot(size, dice);
  // Small robots in large clouds have many places, which take long.
  const double extent = extentOf(cloud);
  const double least = std::min((dice.oneIn(16) ? 0.03 : 0.25) * extent, 1e15);
  if (least > setting::free_distance.initial)
    settings.robot_radius = std::max(settings.robot_radius, least);
  // Each hull takes very many places where it is thicker than that.
  settings.min_thickness = std::min(
      thickness, std::max(settings.robot_radius, setting::free_distance.initial));
  if (!fitting.has_parts ? !dice.oneIn(8) : dice.oneIn(6))
    settings.max_error = drawBound(size, settings.min_thickness, dice);
  if (dice.oneIn(2))
    for (std::size_t n = 1 + dice.below(3); n > 0; --n)
      settings.viewpoints.push_back(drawViewpoint(cloud, place, dice));
  fitting.threads = static_cast<unsigned int>(dice.between(2, 3));
  return fitting;
}

} // namespace

TortureCase::TortureCase(std::uint64_t case_number) : number(case_number)
{
  Dice dice(number);
  const NamedShape& shape = shapes[dice.below(shapes.size())];
  const std::size_t count = drawCount(dice);
  const Place place = drawPlace(dice);
  const float size = std::min(place.scale, 1e14f);
  kind = shape.name;
  cloud = drawCloud(shape, place, count, dice);
  if (dice.oneIn(4))
    spoil(*cloud, dice);
  drawPose(*cloud, place, dice);
  if (dice.oneIn(4)) {
    const NamedShape& other = dice.oneIn(2) ? shape : shapes[dice.below(shapes.size())];
    const Place there = dice.oneIn(4) ? drawPlace(dice) : place;
    surface = drawCloud(other, there, drawCount(dice), dice);
    if (dice.oneIn(4))
      spoil(*surface, dice);
  }
  if (dice.oneIn(3))
    indices = pcl::make_shared<pcl::Indices>(drawIndices(count, dice));
  preparation = drawPreparation(count, size, dice);
  seeds = dice.between(1, 10);
  coverage = dice.oneIn(4) ? std::max(size * dice.magnitude(-10, 0), 1e-37f) : 0.0f;
  samples = dice.between(2, dice.oneIn(2) ? 6 : 33);
  seeding = dice.oneIn(3) ? SeedingRule::soft : SeedingRule::farthest;
  cut = drawCut(size, dice);
  stop_at_cut = dice.oneIn(2);
  group_samples = dice.between(1, 40);
  min_points = dice.oneIn(3) ? dice.between(1, 9) : 1;
  hull = drawHull(size, dice);
  own_search = dice.oneIn(6);
  fitting = drawFitting(*cloud, place, size, hull.min_thickness, dice);
}

CIDConvexAbstraction<TorturePoint>
TortureCase::abstraction(unsigned int threads) const
{
  CIDConvexAbstraction<TorturePoint> abstraction;
  abstraction.setInputCloud(cloud);
  if (indices)
    abstraction.setIndices(indices);
  if (surface)
    abstraction.setSearchSurface(surface);
  abstraction.setSubsample(preparation.subsample);
  abstraction.setRandomSeed(preparation.random_seed);
  if (preparation.start_index)
    abstraction.setStartIndex(*preparation.start_index);
  abstraction.setSeedCandidates(preparation.seed_candidates);
  abstraction.setDensityWeight(preparation.density);
  abstraction.setDensityPower(preparation.density_power);
  abstraction.setIsolatedNeighbors(preparation.isolated_neighbors);
  abstraction.setColorWeight(preparation.color);
  abstraction.setFillBlindSpot(preparation.blind_spot);
  if (own_search)
    abstraction.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  abstraction.setMemoryBudget(preparation.memory_budget);
  abstraction.setNumberOfSeeds(seeds);
  abstraction.setCoverage(coverage);
  abstraction.setNumberOfSamples(samples);
  abstraction.setSeedingRule(seeding);
  abstraction.setNumberOfThreads(threads);
  if (cut.rule == MergeCut::Rule::merges)
    abstraction.setNumberOfMerges(static_cast<int>(cut.count));
  else if (cut.rule == MergeCut::Rule::parts)
    abstraction.setNumberOfParts(static_cast<int>(cut.count));
  else if (cut.rule == MergeCut::Rule::threshold)
    abstraction.setMergeThreshold(cut.height);
  abstraction.setStopAtCut(stop_at_cut);
  abstraction.setGroupSampleSize(group_samples);
  abstraction.setMinPoints(min_points);
  abstraction.setHullOptions(hull);
  return abstraction;
}

namespace {

void
print(std::ostream& out, const FittingCase& fitting)
{
  const HullFittingSettings& settings = fitting.settings;
  if (!fitting.is_checked)
    return;
  out << "  by hull: ";
  if (fitting.has_parts)
    out << settings.parts << " parts, ";
  out << "bound " << settings.max_error << ", thickness " << settings.min_thickness
      << ", robot " << settings.robot_radius << ", on " << fitting.threads
      << " threads, seen from";
  if (settings.viewpoints.empty())
    out << " anywhere";
  for (const Eigen::Vector3d& viewpoint : settings.viewpoints)
    out << ' ' << viewpoint.transpose() << ';';
  out << '\n';
}

void
print(std::ostream& out, const char* name, const pcl::Indices* indices)
{
  out << "  " << name << ':';
  if (!indices)
    out << " all";
  else
    for (const pcl::index_t index : *indices)
      out << ' ' << index;
  out << '\n';
}

void
print(std::ostream& out, const char* name, const TortureCloud& cloud)
{
  out << "  " << name << ", sensor at " << cloud.sensor_origin_.head<3>().transpose()
      << " turned " << cloud.sensor_orientation_.coeffs().transpose() << ":\n";
  for (std::size_t i = 0; i < cloud.size(); ++i)
    out << "    " << i << ": " << cloud[i].x << ' ' << cloud[i].y << ' ' << cloud[i].z
        << " color " << int{cloud[i].r} << ' ' << int{cloud[i].g} << ' '
        << int{cloud[i].b} << '\n';
}

} // namespace

std::ostream&
operator<<(std::ostream& out, const TortureCase& one)
{
  const PreparationSettings& preparation = one.preparation;
  out.precision(9);
  out << "case " << one.number << ": " << one.cloud->size() << " points, " << one.kind
      << "\n  seeds " << one.seeds << ", coverage " << one.coverage << ", samples "
      << one.samples << (one.seeding == SeedingRule::soft ? ", soft" : "")
      << "\n  subsample " << preparation.subsample << ", random seed "
      << preparation.random_seed << ", start " << preparation.start_index.value_or(-1)
      << ", density " << static_cast<int>(preparation.density) << " to the power "
      << preparation.density_power << ", isolated " << preparation.isolated_neighbors
      << ", color " << preparation.color << ", blind spot " << preparation.blind_spot
      << ", memory " << preparation.memory_budget
      << (one.own_search ? ", a search of its own" : "") << "\n  cut "
      << static_cast<int>(one.cut.rule) << " count " << one.cut.count << " height "
      << one.cut.height << (one.stop_at_cut ? ", stops there" : "")
      << ", group samples " << one.group_samples << ", min points " << one.min_points
      << "\n  thickness " << one.hull.min_thickness << ", vertices "
      << one.hull.max_vertices << ", padding " << one.hull.padding << ", trim "
      << one.hull.trim_distance << '\n';
  print(out, one.fitting);
  print(out, "indices", one.indices.get());
  print(out, "candidates", preparation.seed_candidates.get());
  print(out, "cloud", *one.cloud);
  if (one.surface)
    print(out, "surface", *one.surface);
  return out;
}

} // namespace pcl_cid::test
