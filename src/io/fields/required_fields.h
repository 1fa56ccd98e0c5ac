/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Fields of a cloud by their names, or a message that says what is missing.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <string>

namespace pcl_cid {

/** \brief The names of all fields: "x, y, z". */
std::string
listOfFields(const LabelledCloud& cloud);

/** \brief A field with one value for each point.
 *  \throws CIDException when there is none of this name, or it has several values */
const pcl::PCLPointField&
requireField(const LabelledCloud& cloud, const std::string& name);

/** \brief Refuse a cloud without a single x, y and z.
 *  \throws CIDException */
void
requireCoordinates(const LabelledCloud& cloud);

/** \brief Refuse a cloud with two fields of one name.
 *  \throws CIDException */
void
requireDistinctFields(const LabelledCloud& cloud);

/** \brief Refuse values that are not one for each point.
 *  \param[in] things what the user calls them: "labels"
 *  \throws CIDException */
void
requireOneEach(std::size_t count, const char* things, const LabelledCloud& cloud);

} // namespace pcl_cid
