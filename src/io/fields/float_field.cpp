/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A float field of a cloud, such as CID from a point.
 */

#include "field_exchange.h"
#include "required_fields.h"

#include <pcl_cid/io/float_field.h>

#include <cstring>

namespace pcl_cid {

void
setFloats(const std::vector<float>& values,
          const std::string& name,
          LabelledCloud& cloud)
{
  requireOneEach(values.size(), "values", cloud);
  if (name == "x" || name == "y" || name == "z")
    throw CIDException(cloud.name + ": the field " + name +
                       " is a coordinate; choose another name");
  exchangeField(
      name,
      pcl::PCLPointField::FLOAT32,
      [&](std::size_t i, std::uint8_t* bytes) {
        std::memcpy(bytes, &values[i], sizeof(float));
      },
      cloud);
}

} // namespace pcl_cid
