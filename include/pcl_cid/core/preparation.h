/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * From a cloud's points and the settings to the run of Algorithm 1.
 */

#pragma once

#include <pcl_cid/core/blind_spot.h>
#include <pcl_cid/core/cid_parameters.h>
#include <pcl_cid/core/pair_cost.h>
#include <pcl_cid/core/working_set.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pcl_cid {

/** \brief A scan as it comes in. */
struct RawScan {
  /** Finite points that are grouped, `source` ascending. */
  PointSet points;
  SurfacePoints surface;
  /** Of the points; empty where the color weight is 0. */
  std::vector<ColorRGB> colors;
  /** Relative to the same origin; none: there is no blind spot to look for. */
  std::optional<SensorPose> sensor;
};

/** \brief What was found out about the density of a scan, and decided. */
struct DensityDecision {
  /** Whether CIDs are weighted by the local spacing. */
  bool weighted = false;
  /** See spacingSpread(); 0 where no setting needs it. */
  float spread = 0.0f;
  /** Points that were worked on, and were isolated. */
  std::size_t isolated_points = 0;
};

/** \brief A blind spot that is a part of the surface now (see findBlindSpot()). */
struct FilledBlindSpot {
  /** In the frame of the input cloud. */
  Eigen::Vector3d centre;
  /** Metres. */
  float radius;
  /** Points that were added to the surface. */
  std::size_t points;
};

/** \brief What a verb works on, and the seeds that it begins with. */
struct Preparation {
  std::unique_ptr<WorkingSet> working;
  /** The start, or all of the seeds given; indices among working->points(). */
  pcl::Indices seeds;
  /** See SeedProposalOptions. */
  pcl::Indices candidates;
  /** Never all of the candidates. */
  pcl::Indices isolated;
  std::uint64_t soft_seed = 0;
  PairCosts costs;
  DensityDecision density;
  std::optional<FilledBlindSpot> blind_spot;

  /** \brief The costs, or null where they are the CIDs. */
  const PairCosts*
  pairCosts() const
  {
    return costs.spacing.empty() && costs.color.empty() ? nullptr : &costs;
  }
};

/** \brief Draw the working set, with the start or the given seeds in it, and look at it
 *  as a scan: blind spot, spacing, isolated points, colours.
 *  \param[in] scan its points are taken over
 *  \param[in] given_seeds indices of the input cloud; empty for a start, given or drawn
 *  \param[in] parameters see CIDParameters
 *  \param[in] execution threads and progress
 *  \throws CIDException when there is no finite point, when a seed, the start or a
 *  candidate is not one of them, or when coordinates are too large to square */
PCL_CID_EXPORT Preparation
prepare(RawScan scan,
        const pcl::Indices& given_seeds,
        const CIDParameters& parameters,
        const ExecutionOptions& execution);

/** \brief Algorithm 1 on the working set, from the start of the preparation; warns with
 *  PCL_WARN when fewer seeds than asked for come back.
 *  \param[in] keep_cid see SeedProposalOptions
 *  \param[in] caller name of the class and verb, for the warning */
PCL_CID_EXPORT SeedProposal
propose(const Preparation& preparation,
        const CIDParameters& parameters,
        bool keep_cid,
        const ExecutionOptions& execution,
        const char* caller);

/** \brief Group the points of the working set by the seeds of the preparation, which
 *  were given.
 *  \param[in] keep_cid see GroupingOptions */
PCL_CID_EXPORT SeedProposal
group(const Preparation& preparation,
      const CIDParameters& parameters,
      bool keep_cid,
      const ExecutionOptions& execution);

/** \brief Go on with a proposal that propose() made with its CIDs, up to the number of
 *  seeds that the parameters ask for now. */
PCL_CID_EXPORT void
extend(const Preparation& preparation,
       const CIDParameters& parameters,
       const ExecutionOptions& execution,
       const char* caller,
       SeedProposal& proposal);

} // namespace pcl_cid
