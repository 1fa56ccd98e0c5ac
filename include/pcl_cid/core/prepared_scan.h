/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan made ready for CID: once, for everything that follows.
 */

#pragma once

#include <pcl_cid/core/color.h>
#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <pcl/memory.h>
#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl_cid {

class SurfaceGraph;
class WorkingPoints;
class WorkingSet;
struct PairCosts;

/** \brief Where a scan was taken from. */
struct SensorPose {
  /** In the frame of the points; finite. */
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  /** Of length 1. */
  Eigen::Vector3f down = -Eigen::Vector3f::UnitZ();
};

/** \brief A scan before it is prepared. */
struct RawScan {
  /** Finite points that are grouped, `source` ascending. */
  PointSet points;
  /** Points of the cloud that these were selected from; results have an entry for each.
   */
  std::size_t cloud_size = 0;
  /** The surface S, about the origin of the points; empty: the points are S. */
  Points surface;
  /** Of the points; empty where the color weight is 0. */
  std::vector<ColorRGB> colors;
  /** Relative to the same origin; none: no blind spot is looked for. */
  std::optional<SensorPose> sensor;
};

/** \brief The settings that decide how a scan is made ready. A change of any of them
 *  means another PreparedScan; all other settings belong to the verbs. */
struct PreparationSettings {
  /** See the rows of `setting` with these names. */
  int subsample = setting::subsample.initial;
  std::uint64_t random_seed = setting::random_seed.initial;
  DensityWeight density = setting::density.initial;
  float density_power = setting::density_power.initial;
  int isolated_neighbors = setting::isolated_neighbors.initial;
  float color = setting::color.initial;
  float normals = setting::normals.initial;
  bool connected = setting::connected.initial;
  bool blind_spot = setting::blind_spot.initial;
  /** The first seed, an index of the cloud; none: it is drawn. */
  std::optional<pcl::index_t> start_index;
  /** Points of the cloud that may become seeds; null means all. */
  pcl::shared_ptr<const pcl::Indices> seed_candidates;
  /** Points of the cloud that a subsample must hold, such as seeds that will be added;
   *  the first of them is the start then. Of no effect without a subsample. */
  pcl::Indices required;
  /** See DistanceField::Options. */
  DistanceField::SearchPtr search_method;
  std::size_t memory_budget = 0;

  /** \brief What the rows of these settings say of the paper, see
   *  NumberSetting::paper(). */
  void
  setPaperSettings()
  {
    density = setting::density.paper();
    isolated_neighbors = setting::isolated_neighbors.paper();
    color = setting::color.paper();
    normals = setting::normals.paper();
    connected = setting::connected.paper();
    blind_spot = setting::blind_spot.paper();
  }
};

/** \brief What was measured about the density of a scan, and decided. */
struct DensityDecision {
  /** Whether CIDs are weighted by the local spacing. */
  bool weighted = false;
  /** How much more the spacing differs between regions than within one (see
   *  doc/core/prepared_scan.md); 0 where no setting needs it, and for one place. */
  float spread = 0.0f;
  /** Points that are worked on, and are isolated. */
  std::size_t isolated_points = 0;
};

/** \brief A disc of floor that a scanner hid from itself, and that was made a part of
 *  the surface. */
struct FilledBlindSpot {
  /** In the frame of the input cloud. */
  Eigen::Vector3d center;
  /** Metres. */
  float radius;
  /** Points that were added to the surface. */
  std::size_t points;
};

/** \brief A scan made ready for CID: its points about a local origin, the surface S and
 *  its distance field, the spacing and the costs of pairs, isolated points, the blind
 *  spot, and the seed that Algorithm 1 begins with.
 *
 *  Made once, and shared: groupings, merge trees, tightness and CIDs from a point all
 *  work on the same one. Immutable; any number of threads may read it. */
class PCL_CID_EXPORT PreparedScan {
public:
  using ConstPtr = std::shared_ptr<const PreparedScan>;

  /** \param[in] scan its points are moved from
   *  \param[in] settings see PreparationSettings
   *  \param[in] execution threads and progress; never change the result
   *  \throws CIDException when there is no point, when one is not finite, when indices
   *  or colors are not those of the points, when the start, a required point or every
   *  candidate is not one of them, when a setting is out of its range, or when
   *  coordinates are too large, or the cloud too small, to square; CIDCancelled
   *  \note Cost: O(N log N); about 150 bytes a point (see DistanceField). */
  PreparedScan(RawScan scan,
               const PreparationSettings& settings,
               const ExecutionOptions& execution = {});
  ~PreparedScan();
  PreparedScan(const PreparedScan&) = delete;
  PreparedScan&
  operator=(const PreparedScan&) = delete;

  const PreparationSettings&
  settings() const
  {
    return settings_;
  }

  /** \brief Points of the cloud that the scan was selected from. */
  std::size_t
  cloudSize() const
  {
    return cloud_size_;
  }

  /** \brief All points that are grouped, about a local origin. */
  const PointSet&
  points() const;

  /** \brief d(x; S), in the frame of points(). */
  const DistanceField&
  field() const;

  const DensityDecision&
  density() const
  {
    return density_;
  }

  const std::optional<FilledBlindSpot>&
  blindSpot() const
  {
    return blind_spot_;
  }

  /** \brief Whether S is all of points(), and nothing else. */
  bool
  pointsAreSurface() const;

  /** \brief The points that are worked on: points(), or a draw of them. */
  const WorkingPoints&
  working() const
  {
    return *working_;
  }

  /** \brief Which of points() are worked on, and which of these each other point
   *  follows. */
  const WorkingSet&
  workingSet() const
  {
    return *set_;
  }

  /** \brief Which of the points that are worked on are next to each other; null where
   *  groups need not be connected. */
  const SurfaceGraph*
  graph() const
  {
    return graph_.get();
  }

  /** \brief The first seed of Algorithm 1, an index among the points that are worked
   *  on. */
  pcl::index_t
  start() const
  {
    return start_;
  }

  /** \brief The points that may become seeds, indices like start(); empty: all. */
  const pcl::Indices&
  candidates() const
  {
    return candidates_;
  }

  /** \brief The points that are not proposed and do not count in the coverage, indices
   *  like start(); never all of the candidates. */
  const pcl::Indices&
  isolated() const
  {
    return isolated_;
  }

  /** \brief The random seed of the draws of SeedingRule::soft. */
  std::uint64_t
  softSeed() const
  {
    return soft_seed_;
  }

  /** \brief The index among the points that are worked on of a point of the cloud.
   *  \param[in] name what it is, for the message: "seed"
   *  \throws CIDException when it is not a finite, selected point, or was not drawn */
  pcl::index_t
  workingIndex(pcl::index_t cloud_index, const char* name) const;

private:
  class Maker;

  PreparationSettings settings_;
  std::size_t cloud_size_;
  std::unique_ptr<WorkingSet> set_;
  std::unique_ptr<PairCosts> costs_;
  std::unique_ptr<WorkingPoints> working_;
  std::unique_ptr<SurfaceGraph> graph_; ///< null without PreparationSettings::connected
  bool points_are_surface_ = false;
  pcl::index_t start_ = 0;
  pcl::Indices candidates_;
  pcl::Indices isolated_;
  std::uint64_t soft_seed_ = 0;
  DensityDecision density_;
  std::optional<FilledBlindSpot> blind_spot_;
};

} // namespace pcl_cid
