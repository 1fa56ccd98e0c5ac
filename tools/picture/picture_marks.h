/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The labels, groups or parts of a picture, which have a color each.
 */

#pragma once

#include "picture.h"

#include <nlohmann/json.hpp>

namespace pcl_cid::tools {

/** \brief What the points of a scan belong to. */
struct PictureMarks {
  /** Of each point of the cloud: 1 and up in the order of labels or parts; 0 for none.
   */
  std::vector<std::uint32_t> index;
  /** Finite points of each index, with 0. */
  std::vector<std::size_t> points;
  /** The label of each index; empty for parts. */
  std::vector<std::uint32_t> labels;
  /** All but 0, those with the most points first. */
  std::vector<std::uint32_t> by_size;
};

/** \param[in] finite indices of the finite points of the cloud */
PictureMarks
marksOf(const Picture& picture, std::size_t cloud_size, const pcl::Indices& finite);

/** \brief The rows of the list, as far as they fit, and what is in none at the end:
 *  `index`, `name`, `points`; for parts, what the report says of them, too.
 *  \param[in] parts of the report; null for labels and groups
 *  \param[in] most_bytes of all rows together */
nlohmann::ordered_json
rowsOf(const PictureMarks& marks,
       const Picture& picture,
       const nlohmann::ordered_json& parts,
       std::size_t most_bytes);

} // namespace pcl_cid::tools
