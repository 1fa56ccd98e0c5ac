/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pages get: the page, and the scan.
 */

#pragma once

#include "places.h"
#include "server/resource.h"

#include <pcl_cid/core/color.h>
#include <pcl_cid/core/point_set.h>

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::studio {

/** \brief What a page should know of a scan besides its points. */
struct ScanFacts {
  std::string name;
  std::string session;    ///< name of its file
  std::size_t points = 0; ///< of the cloud
  /** Of the positions, in the frame of the file. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::vector<std::string> classes;
  std::vector<std::string> meshes; ///< extensions that parts are exported in
};

/** \brief The page, and a scan at `/api/...` (doc/studio_protocol.md). */
class ScanResources : public Resources {
public:
  /** \param[in] page must outlive this
   *  \param[in] points in the order of \a places
   *  \param[in] colors of the cloud; empty for none */
  ScanResources(const Resources& page,
                const ScanFacts& facts,
                const PointSet& points,
                const Places& places,
                const std::vector<ColorRGB>& colors);

  std::optional<Resource>
  find(std::string_view path) const override;

private:
  const Resources& page_;
  std::string facts_; ///< JSON
  std::vector<Eigen::Vector3f> positions_;
  std::vector<std::uint8_t> colors_;
};

} // namespace pcl_cid::studio
