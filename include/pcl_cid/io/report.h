/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a run did, as JSON.
 */

#pragma once

#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/core/hull_tightness.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl_cid {

struct CloudPoints;
struct ConvexPart;
class MergeTree;
class SmoothPatches;
struct SeedProposal;

/** \brief How many labels are those that a cloud came with. */
struct LabelScore {
  /** Field of the cloud that holds the true labels. */
  std::string field;
  /** Finite points, and those of them whose label is right. */
  std::size_t points = 0;
  std::size_t right = 0;
  /** The same for points whose true label is not 0. */
  std::size_t labelled_points = 0;
  std::size_t right_labelled = 0;

  /** \brief Share of the points whose label is right; 0 when there are none. */
  double
  share() const
  {
    return points == 0 ? 0.0 : static_cast<double>(right) / static_cast<double>(points);
  }

  /** \brief Share of the points with a true label that is not 0 whose label is
   *  right. */
  double
  shareOfLabelled() const
  {
    return labelled_points == 0 ? 0.0
                                : static_cast<double>(right_labelled) /
                                      static_cast<double>(labelled_points);
  }
};

/** \brief Compare labels with the true ones over the finite points.
 *  \param[in] field of the cloud that the true labels come from
 *  \param[in] labels one for each point
 *  \param[in] truth one for each point
 *  \param[in] points tell which are finite */
PCL_CID_IO_EXPORT LabelScore
scoreLabels(const std::string& field,
            const std::vector<std::uint32_t>& labels,
            const std::vector<std::uint32_t>& truth,
            const CloudPoints& points);

/** \brief Free places of a scan, and those that hulls refuse to a robot. */
struct RefusedPlaces {
  std::size_t free = 0;
  std::size_t refused = 0;

  /** \brief Share of the free places that are refused; 0 when there are none. */
  double
  refusedShare() const
  {
    return free == 0 ? 0.0 : static_cast<double>(refused) / static_cast<double>(free);
  }
};

/** \brief What a part that was made of the points of voxels has of the input. */
struct FollowedPart {
  /** Points of the input in it, and those that are not, as they follow a point of a
   *  voxel that was trimmed. */
  std::size_t points = 0;
  std::size_t trimmed_points = 0;
  /** Indices in the input of the points of voxels that were trimmed, ascending. */
  pcl::Indices trimmed;
};

/** \brief What a run did; what does not apply stays empty. */
struct Report {
  /** A parameter as it was used; no value means "none". */
  struct Parameter {
    std::string name;
    std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string>
        value;
  };
  /** A step of the run, and how long it took. */
  struct Step {
    std::string name;
    double seconds;
  };

  std::string tool;
  std::string input;
  /** What was repaired, left out or assumed when the input was read. */
  std::vector<std::string> remarks;
  std::vector<Parameter> parameters;
  /** Points of the input, those of them that are finite, and those in a group. */
  std::size_t points_in = 0;
  std::size_t points_finite = 0;
  std::size_t points_grouped = 0;
  /** Voxels, one point of each of which was worked on; empty when all points were. */
  std::optional<std::size_t> voxels;
  /** What was found out about the density. */
  std::optional<DensityDecision> density;
  /** The blind spot that was filled, its center in the frame of the file. */
  std::optional<FilledBlindSpot> blind_spot;
  /** Indices of the seeds in the input, and r_k for each in meters (see
   *  SeedProposal). */
  pcl::Indices seeds;
  std::vector<float> coverage;
  /** Coordinates of the seeds in the frame of the file. */
  std::vector<Eigen::Vector3d> seed_positions;
  /** Labels of the seeds where they have any. */
  std::vector<std::uint32_t> seed_labels;
  /** Points of each group. */
  std::vector<std::size_t> group_sizes;
  /** Points that each patch grew over; empty where groups are those of seeds. */
  std::vector<std::size_t> grown_sizes;
  std::optional<LabelScore> score;
  /** The parts. They are not copied and must live until toJson(); null when there are
   *  none. */
  const std::vector<ConvexPart>* parts = nullptr;
  /** One for each part, where parts were made of the points of voxels. */
  std::vector<FollowedPart> followed_parts;
  /** Vertices of all hulls before they were simplified; empty when they were not. */
  std::optional<std::size_t> exact_vertices;
  /** What stands for each hull in scenes; empty when primitives were not asked for. */
  std::vector<std::optional<HullPrimitive>> primitives;
  /** Points of parts that were dropped for being small: no hull covers them. */
  std::size_t dropped_points = 0;
  /** What the hulls cost a robot; empty when parts were not chosen by their hulls. */
  std::optional<RefusedPlaces> places;
  /** How tightly their hulls fit; empty when it was not measured. */
  std::optional<Tightness> tightness;
  std::vector<Step> steps;
};

/** \brief Fill in what a proposal says: points, seeds, coverage, groups.
 *  \param[in] proposal for all points of the cloud
 *  \param[in] points coordinates of the cloud
 *  \param[in,out] report what it said about these before is replaced */
PCL_CID_IO_EXPORT void
describeProposal(const SeedProposal& proposal,
                 const CloudPoints& points,
                 Report& report);

/** \brief The same for patches: points and groups; there are no seeds.
 *  \param[in] points coordinates of the cloud */
PCL_CID_IO_EXPORT void
describePatches(const SmoothPatches& patches,
                const CloudPoints& points,
                Report& report);

/** \brief The report with the library's version and the peak memory of this process so
 *  far, as JSON. */
PCL_CID_IO_EXPORT std::string
toJson(const Report& report);

/** \brief A merge tree as JSON: `group_sizes`, and `steps` with `first`, `second`,
 *  `height` (meters) and `size` (points). */
PCL_CID_IO_EXPORT std::string
toJson(const MergeTree& tree);

} // namespace pcl_cid
