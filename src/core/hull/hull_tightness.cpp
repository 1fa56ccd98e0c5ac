/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How tightly hulls fit the scan that they represent.
 */

#include "base/parallel_for.h"
#include "base/requirements.h"
#include "hull_mesh.h"
#include "hull_samples.h"

#include <pcl_cid/core/hull_tightness.h>

#include <algorithm>
#include <cmath>

namespace pcl_cid {
namespace {

constexpr std::size_t samples_at_once = 4096;

Eigen::AlignedBox3d
boxOf(const PointSet& scan)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : scan.points)
    box.extend(p.cast<double>().eval());
  return box;
}

/** The field can be cancelled; the progress begins after it. */
DistanceField::Options
fieldOptions(const TightnessOptions& options)
{
  DistanceField::Options field_options;
  field_options.execution.threads = options.execution.threads;
  if (const ProgressCallback& progress = options.execution.progress)
    field_options.execution.progress = [&progress](double) { return progress(0.0); };
  return field_options;
}

void
requireValid(const TightnessOptions& options)
{
  require(setting::free_distance, options.free_distance);
  requireAtLeast<std::size_t>("number of hull samples", options.hull_samples, 1);
  requireAtLeast<std::size_t>("number of box samples", options.box_samples, 1);
}

/** The options, checked before any work. */
const TightnessOptions&
valid(const TightnessOptions& options)
{
  requireValid(options);
  return options;
}

const PreparedScan&
notNull(const PreparedScan::ConstPtr& scan)
{
  if (!scan)
    throw CIDException("there is no prepared scan to measure against; give one");
  return *scan;
}

/** The field of the scan, where its surface is exactly its points; the pointer keeps
 *  the scan alive. */
std::shared_ptr<const DistanceField>
fieldOfPoints(const PreparedScan::ConstPtr& scan, const TightnessOptions& options)
{
  if (valid(options); notNull(scan).pointsAreSurface())
    return {scan, &scan->field()};
  return std::make_shared<const DistanceField>(scan->points().points,
                                               fieldOptions(options));
}

/** \brief Tells which points are inside a hull. */
class Inside {
public:
  explicit Inside(const TriangleMesh& hull)
  : box_(boxOf(hull)), half_spaces_(halfSpacesOf(hull))
  {
  }

  bool
  operator()(const Eigen::Vector3d& p) const
  {
    return box_.contains(p) && isInside(half_spaces_, p);
  }

private:
  Eigen::AlignedBox3d box_;
  std::vector<HalfSpace> half_spaces_;
};

/** The hulls in the local frame of the scan. */
std::vector<TriangleMesh>
localHulls(const std::vector<ConvexPart>& parts, const Frame& frame)
{
  std::vector<TriangleMesh> hulls;
  hulls.reserve(parts.size());
  for (const ConvexPart& part : parts) {
    hulls.push_back(part.hull);
    for (Eigen::Vector3d& v : hulls.back().vertices)
      v = frame.toLocal(v);
  }
  return hulls;
}

} // namespace

TightnessMeter::TightnessMeter(const PointSet& scan, const TightnessOptions& options)
: TightnessMeter(
      scan,
      std::make_shared<const DistanceField>(scan.points, fieldOptions(valid(options))),
      options)
{
}

TightnessMeter::TightnessMeter(const PreparedScan::ConstPtr& scan,
                               const TightnessOptions& options)
: TightnessMeter(notNull(scan).points(), fieldOfPoints(scan, options), options)
{
}

TightnessMeter::TightnessMeter(const PointSet& scan,
                               std::shared_ptr<const DistanceField> field,
                               const TightnessOptions& options)
: options_(options)
, frame_(scan.frame)
, box_(boxOf(scan))
, field_(std::move(field))
, box_sample_is_free_(options.box_samples)
{
  Progress progress(options.execution.progress);
  parallelFor(options.box_samples,
              samples_at_once,
              threadCount(options.execution.threads),
              progress,
              {0.0, 1.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t n = begin; n < end; ++n)
                  box_sample_is_free_[n] = isFree(boxSample(n));
              });
}

bool
TightnessMeter::isFree(const Eigen::Vector3d& local) const
{
  const Eigen::Vector3f x = local.cast<float>();
  const DistanceBounds bounds = field_->bounds(x);
  if (static_cast<double>(bounds.low) > options_.free_distance)
    return true;
  return static_cast<double>(bounds.high) > options_.free_distance &&
         static_cast<double>(field_->distance(x)) > options_.free_distance;
}

Eigen::Vector3d
TightnessMeter::boxSample(std::size_t number) const
{
  return box_.min() + evenInCube(number).cwiseProduct(box_.sizes());
}

HullTightness
TightnessMeter::tightnessOf(const TriangleMesh& local) const
{
  const auto count = static_cast<double>(options_.hull_samples);
  HullTightness tightness;
  for (const Eigen::Vector3d& x : surfaceSamples(local, options_.hull_samples)) {
    const auto distance = static_cast<double>(field_->distance(x.cast<float>()));
    tightness.max_concavity = std::max(tightness.max_concavity, distance);
    tightness.mean_concavity += distance / count;
  }
  for (const Eigen::Vector3d& x : volumeSamples(local, options_.hull_samples))
    tightness.free_share += isFree(x) ? 1.0 / count : 0.0;
  return tightness;
}

void
TightnessMeter::measureUnion(const std::vector<TriangleMesh>& local,
                             Progress& progress,
                             Tightness& tightness) const
{
  const std::vector<Inside> inside(local.begin(), local.end());
  std::vector<unsigned char> is_in_union(options_.box_samples);
  parallelFor(options_.box_samples,
              samples_at_once,
              threadCount(options_.execution.threads),
              progress,
              {0.5, 1.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t n = begin; n < end; ++n)
                  is_in_union[n] = std::any_of(
                      inside.begin(),
                      inside.end(),
                      [x = boxSample(n)](const Inside& hull) { return hull(x); });
              });
  std::size_t in_union = 0;
  std::size_t free = 0;
  for (std::size_t n = 0; n < is_in_union.size(); ++n) {
    in_union += is_in_union[n];
    free += is_in_union[n] & box_sample_is_free_[n];
  }
  const double sample_volume =
      box_.volume() / static_cast<double>(options_.box_samples);
  tightness.volume = sample_volume * static_cast<double>(in_union);
  tightness.free_volume = sample_volume * static_cast<double>(free);
  tightness.all.free_share =
      in_union > 0 ? static_cast<double>(free) / static_cast<double>(in_union) : 0.0;
}

Tightness
TightnessMeter::measure(const std::vector<ConvexPart>& parts) const
{
  const std::vector<TriangleMesh> local = localHulls(parts, frame_);
  Tightness tightness;
  tightness.hulls.resize(local.size());
  Progress progress(options_.execution.progress);
  parallelForEach(local.size(),
                  threadCount(options_.execution.threads),
                  progress,
                  {0.0, 0.5},
                  [&](std::size_t k) { tightness.hulls[k] = tightnessOf(local[k]); });
  double area = 0.0;
  for (std::size_t k = 0; k < local.size(); ++k) {
    const HullTightness& hull = tightness.hulls[k];
    const double hull_area = areaOf(local[k]);
    tightness.all.max_concavity =
        std::max(tightness.all.max_concavity, hull.max_concavity);
    tightness.all.mean_concavity += hull.mean_concavity * hull_area;
    area += hull_area;
  }
  if (area > 0.0)
    tightness.all.mean_concavity /= area;
  measureUnion(local, progress, tightness);
  return tightness;
}

} // namespace pcl_cid
