/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A field of a cloud put in, or exchanged for another.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace pcl_cid {

/** \brief Give a cloud a field with one value for each point: in the place of the one
 *  of this name, or after all other fields when there is none.
 *  \param[in] datatype that of pcl::PCLPointField
 *  \param[in] store called as store(i, bytes) to write the value of point i, as many
 *  bytes as the type has */
void
exchangeField(const std::string& name,
              std::uint8_t datatype,
              const std::function<void(std::size_t, std::uint8_t*)>& store,
              LabelledCloud& cloud);

} // namespace pcl_cid
