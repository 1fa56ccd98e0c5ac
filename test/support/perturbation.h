/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan as a worse sensor would have seen it: noise and fewer points.
 */

#pragma once

#include <cstdint>

#include <pcl/PCLPointCloud2.h>

namespace pcl_cid::test {

/** \brief What is done to a scan. */
struct Perturbation {
  /// Standard deviation of what is added to each coordinate, in their unit.
  double noise = 0.0;
  /// Each point is kept with this probability, independently.
  double keep = 1.0;
  std::uint64_t seed = 0;
};

/** \brief Nearly normal noise (drawNormal()) on x, y and z, and random thinning.
 *
 *  Every point has its own draws: for one seed a point moves in the same direction
 *  whatever is kept, in proportion to the noise, and what a smaller \a keep keeps, a
 *  greater one keeps, too.
 *  \param[in] cloud float or double x, y, z; points without gaps between them
 *  \param[in] perturbation noise of at least 0, keep above 0 and at most 1
 *  \return the points kept, in order, with all their fields; width and height stay
 * where all are kept. The same on every machine. \throw CIDException when no point is
 * kept, or x, y or z is missing or of another type */
pcl::PCLPointCloud2
perturbed(const pcl::PCLPointCloud2& cloud, const Perturbation& perturbation);

} // namespace pcl_cid::test
