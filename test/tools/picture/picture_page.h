/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page of a picture, taken apart.
 */

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <Eigen/Core>

namespace pcl_cid::test {

/** \brief What is in the page of a picture. */
struct PicturePage {
  /** \param[in] page its text
   *  \throws std::runtime_error when an element is not there once */
  explicit PicturePage(const std::string& page);

  /** \brief In the frame of the file. */
  Eigen::Vector3d
  position(std::size_t point) const;

  Eigen::Vector3d
  hullVertex(std::size_t vertex) const;

  nlohmann::json facts;
  std::vector<float> positions;      ///< about the origin of the facts
  std::vector<unsigned char> colors; ///< three for each point, or none
  std::vector<std::uint32_t> labels; ///< indices of marks
  std::vector<float> values;
  std::vector<float> hull_vertices;
  std::vector<std::uint32_t> hull_triangles;
};

/** \brief How often a text is in another. */
std::size_t
timesIn(const std::string& text, const std::string& part);

} // namespace pcl_cid::test
