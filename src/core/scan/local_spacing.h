/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How far apart the points of a cloud are, from place to place.
 */

#pragma once

#include "nearest_neighbors.h"
#include <pcl_cid/core/settings.h>

#include <vector>

namespace pcl_cid {

/** Smaller spacings count as this share of the median: a sensor held close to an object
 *  resolves more than its shape needs. */
constexpr float least_spacing = 0.2f;

/** Larger spacings count as this multiple of the median. */
constexpr float most_spacing = 100.0f;

/** DensityWeight::automatic is on from this spread of the spacing. Points that are
 *  drawn evenly from surfaces have 0.7 to 0.9, whatever the surfaces, and vertices of
 *  meshes hardly more. */
constexpr float uneven_spread = 0.92f;

/** \brief The spacing of a cloud, metres: the median of the distances from a point to
 *  its eighth neighbor, the lower one of an even number; 0 without points. */
float
medianReach(const NearestNeighbors& neighbors);

/** \brief s(p) of each point: the distance to its eighth neighbor over the median of
 *  the cloud, within `least_spacing` and `most_spacing`, to a power.
 *  \param[in] neighbors of the points
 *  \param[in] power 0 for 1 everywhere (the paper), 1 for the spacing itself; 0 to 4
 *  \return above 0; 1 for each point of a cloud that has no spacing
 *  \throws CIDException when the power is out of its range */
std::vector<float>
localSpacing(const NearestNeighbors& neighbors, float power);

/** \brief How uneven the spacing is: how much more it differs between regions than
 *  within one. A region is about a four hundredth of the points; its spacing is their
 *  median. Both differences are ratios, of the 90 % quantile to the 10 % quantile.
 *
 *  What a sensor sees gets sparse and noisy with the range, and so from region to
 *  region. Spacing that changes from point to point and is the same everywhere on the
 *  whole, as that of the vertices of a mesh, says nothing about that.
 *
 *  Each point stands for an area, the square of its spacing: counted by points, nearby
 *  surfaces would outweigh distant ones. The sparsest 2 % of the points do not count:
 *  stray points are few, but each would stand for a large area.
 *  \param[in] neighbors of the points
 *  \param[in] isolated further points that do not count (see isolatedPoints()),
 *  ascending
 *  \return above 0; 0 for a cloud that has no spacing */
float
spacingSpread(const NearestNeighbors& neighbors, const pcl::Indices& isolated);

} // namespace pcl_cid
