/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A field of a cloud put in, or exchanged for another.
 */

#include "field_exchange.h"

#include "field_values.h"

#include <cstring>
#include <utility>

namespace pcl_cid {
namespace {

/** The fields and point size of the result; no data yet. */
pcl::PCLPointCloud2
laidOutWith(const std::string& name,
            std::uint8_t datatype,
            const pcl::PCLPointCloud2& from)
{
  pcl::PCLPointCloud2 to = from;
  to.fields.clear();
  to.point_step = 0;
  for (const pcl::PCLPointField& field : from.fields)
    if (field.name == name)
      addField(name, datatype, 1, to);
    else
      addField(field.name, field.datatype, field.count, to);
  if (!findField(from, name))
    addField(name, datatype, 1, to);
  to.row_step = to.point_step * to.width;
  return to;
}

} // namespace

void
exchangeField(const std::string& name,
              std::uint8_t datatype,
              const std::function<void(std::size_t, std::uint8_t*)>& store,
              LabelledCloud& cloud)
{
  const pcl::PCLPointCloud2& from = cloud.fields;
  pcl::PCLPointCloud2 to = laidOutWith(name, datatype, from);
  to.data.assign(static_cast<std::size_t>(to.point_step) * cloud.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint8_t* const source = from.data.data() + i * from.point_step;
    std::uint8_t* const target = to.data.data() + i * to.point_step;
    for (std::size_t f = 0; f < to.fields.size(); ++f) {
      const pcl::PCLPointField& field = to.fields[f];
      if (field.name == name)
        store(i, target + field.offset);
      else
        std::memcpy(target + field.offset,
                    source + from.fields[f].offset,
                    field.count * sizeOf(field.datatype));
    }
  }
  cloud.fields = std::move(to);
}

} // namespace pcl_cid
