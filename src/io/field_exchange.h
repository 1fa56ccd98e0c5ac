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

/** \brief Give a cloud a field of one value a point, in the place of one that it has of
 *  this name, else after all other fields.
 *  \param[in] store called as store(i, bytes) to write the value of point i, as many
 *  bytes as the type has */
void
exchangeField(const std::string& name,
              std::uint8_t datatype,
              const std::function<void(std::size_t, std::uint8_t*)>& store,
              LabelledCloud& cloud);

/** \brief Refuse values that are not one for each point.
 *  \param[in] things what the user calls them: labels
 *  \throws CIDException */
void
requireOneEach(std::size_t count, const char* things, const LabelledCloud& cloud);

} // namespace pcl_cid
