/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls with as few vertices as the error allows.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/pcl_cid_export.h>

#include <memory>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief The bound that padded hulls keep when they keep one without their padding: a
 *  corner of a hull goes outward by up to sqrt(3) times the padding. Metres. */
PCL_CID_EXPORT double
paddedBound(double max_error, double padding);

/** \brief The bound T on the error of hulls, asked of one body at a time: as fitHulls()
 *  keeps it. Thread safety: const calls may run concurrently. */
class PCL_CID_EXPORT ErrorBound {
public:
  /** \param[in] scan not null
   *  \param[in] max_error T, metres, above 0
   *  \param[in] viewpoints see HullFittingSettings
   *  \param[in] execution threads and progress; never change an answer
   *  \throws CIDException for a bound out of its range, a viewpoint that is not finite,
   *  or without a scan; CIDCancelled */
  ErrorBound(const PreparedScan::ConstPtr& scan,
             double max_error,
             const std::vector<Eigen::Vector3d>& viewpoints = {},
             const ExecutionOptions& execution = {});
  ~ErrorBound();

  /** \brief Whether no place of a convex body is farther than T from the scan. Without
   *  viewpoints yes is certain, and no may also be said of a body that comes within 5 %
   *  of T. With them only seen places count: the corners of the body, and those of a
   *  grid of at most T / 3.
   *  \param[in] body its vertices count, in the frame of the input cloud of the scan */
  bool
  isKeptBy(const TriangleMesh& body) const;

  /** \brief T, metres. */
  double
  maxError() const
  {
    return max_error_;
  }

private:
  struct SeenPlaces;

  PreparedScan::ConstPtr scan_;
  double max_error_;
  std::unique_ptr<const SeenPlaces> seen_; ///< null: all places count
};

/** \brief Share of a hull's diagonal by which a simpler one may stand out of it. */
constexpr double simplification_share = 0.01;

/** \brief Put simpler bodies in the place of hulls: outer approximations with as few
 *  vertices as one bound allows, of which there are two.
 *
 *  With \a bound the body must keep it, and no place of it may be farther than T from
 *  the hull, as there may be space that does not count. Without, no place of it may be
 *  farther than simplification_share of the hull's diagonal from the hull.
 *
 *  A body is found from the hull's principal box, of which faces of the hull cut what
 *  is farthest outside; then planes go that it can do without. A hull that no body of
 *  fewer vertices may stand for stays as it is, to the bit, and so does one of 8
 *  vertices or less. What hulls guarantee (see findBrokenGuarantee()) they guarantee
 *  still, as the hull is in the body.
 *  \param[in,out] parts in the frame of the input cloud
 *  \param[in] frame of the scan that they are parts of
 *  \param[in] bound null for none
 *  \param[in] execution threads and progress; never change the result
 *  \throws CIDCancelled
 *  \note Cost: for each hull as many bodies as it needs cuts. */
PCL_CID_EXPORT void
simplifyHulls(std::vector<ConvexPart>& parts,
              const Frame& frame,
              const ErrorBound* bound,
              const ExecutionOptions& execution = {});

} // namespace pcl_cid
