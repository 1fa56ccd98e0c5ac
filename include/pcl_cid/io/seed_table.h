/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The table in which an annotator labels seeds.
 */

#pragma once

#include <pcl_cid/pcl_cid_io_export.h>

#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

struct CloudPoints;

/** \brief Seeds with their labels; see CIDLabelPropagation::setSeeds(). */
struct SeedTable {
  /** Points, by their place in CloudPoints::points. */
  pcl::Indices seeds;
  /** One for each seed; 0 means "asked, and it is none". */
  std::vector<std::uint32_t> labels;
  /** Names of those labels that are classes in the table. */
  std::map<std::uint32_t, std::string> names;
};

/** \brief Write a table for an annotator: columns `index,x,y,z,label`, a row for each
 *  seed in order; the index is that in the file.
 *  \param[in] seeds finite points, by their place in CloudPoints::points
 *  \param[in] points coordinates of the cloud; written in the frame and the unit of its
 *  file (CloudPoints::metres_per_unit), with as many digits as they have
 *  \param[in] labels one for each seed; an empty one stands for "not asked", and none
 *  at all for as many of these */
PCL_CID_IO_EXPORT void
writeSeedTable(std::ostream& stream,
               const pcl::Indices& seeds,
               const CloudPoints& points,
               const std::vector<std::optional<std::uint32_t>>& labels = {});

/** \brief Read a table that an annotator has filled in.
 *
 *  Separated by commas, semicolons or tabs, or what a first line `sep=` says, with a
 *  header that names at least `index` and `label`, in any order; more columns are
 *  passed over. Rows may be removed, added and reordered. An empty label means "not
 *  asked": the row is no seed. Label 0 means "asked, and it is none". A label may be
 *  the name of a class, which gets a number: 1, 2, ... in the order of the rows,
 *  without those that are labels already. Blank lines, spaces, quotes, every line end,
 *  decimal commas between semicolons, 1.0 for 1, and UTF-16 are fine. Coordinates may
 *  be empty; where they are given, they must be those of the point, to within 1/1000 of
 *  the cloud's diagonal: else the table belongs to another cloud.
 *  \throws CIDException with file, line and value when a column is missing, an index is
 *  no finite point or stands twice with two labels, an index is not a whole number, a
 *  label neither one (0 to 4294967295) nor a name, or coordinates differ; and when
 *  there is no label at all */
PCL_CID_IO_EXPORT SeedTable
readSeedTable(const std::string& path, const CloudPoints& points);

/** \brief Whether a file is a seed table in which at least one label is filled in; not
 *  when it cannot be read, or is something else. */
PCL_CID_IO_EXPORT bool
holdsLabels(const std::string& path);

} // namespace pcl_cid
