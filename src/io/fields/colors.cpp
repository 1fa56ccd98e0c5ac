/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors of a cloud.
 */

#include "base/sentence.h"
#include "field_values.h"
#include "required_fields.h"

namespace pcl_cid {

std::vector<ColorRGB>
colorsOf(const LabelledCloud& cloud)
{
  const char* const name = findField(cloud.fields, "rgb") ? "rgb" : "rgba";
  if (!findField(cloud.fields, name))
    throw CIDException(cloud.name + ": has no colors, in a field 'rgb' or 'rgba'; " +
                       "its fields are " + listOfFields(cloud));
  const pcl::PCLPointField& field = requireField(cloud, name);
  if (sizeOf(field.datatype) != sizeof(std::uint32_t))
    throw CIDException(sentence(cloud.name,
                                ": field '",
                                name,
                                "' has ",
                                sizeOf(field.datatype),
                                " bytes; colors must have 4"));
  std::vector<ColorRGB> colors;
  colors.reserve(cloud.size());
  const std::uint8_t* bytes = cloud.fields.data.data() + field.offset;
  for (std::size_t i = 0; i < cloud.size(); ++i, bytes += cloud.fields.point_step)
    colors.push_back(unpackColor(loadValue<std::uint32_t>(bytes)));
  return colors;
}

} // namespace pcl_cid
