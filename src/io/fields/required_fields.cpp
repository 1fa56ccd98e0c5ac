/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Fields of a cloud by their names, or a message that says what is missing.
 */

#include "required_fields.h"

#include "base/sentence.h"
#include "field_values.h"

#include <set>

namespace pcl_cid {

std::string
listOfFields(const LabelledCloud& cloud)
{
  std::string names;
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    names += (names.empty() ? "" : ", ") + field.name;
  return names;
}

const pcl::PCLPointField&
requireField(const LabelledCloud& cloud, const std::string& name)
{
  const pcl::PCLPointField* const field = findField(cloud.fields, name);
  if (!field)
    throw CIDException(sentence(cloud.name,
                                ": has no field '",
                                name,
                                "'; its fields are ",
                                listOfFields(cloud)));
  if (field->count != 1)
    throw CIDException(sentence(cloud.name,
                                ": field '",
                                name,
                                "' has ",
                                field->count,
                                " values for each point; it must have 1"));
  return *field;
}

void
requireCoordinates(const LabelledCloud& cloud)
{
  for (const char* const axis : {"x", "y", "z"})
    requireField(cloud, axis);
}

void
requireDistinctFields(const LabelledCloud& cloud)
{
  std::set<std::string> names;
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    if (!names.insert(field.name).second)
      throw CIDException(sentence(
          cloud.name, ": has two fields named '", field.name, "'; names must differ"));
}

void
requireOneEach(std::size_t count, const char* things, const LabelledCloud& cloud)
{
  if (count != cloud.size())
    throw CIDException(sentence(cloud.name,
                                ": there are ",
                                count,
                                " ",
                                things,
                                "; there must be one for each of the ",
                                cloud.size(),
                                " points"));
}

} // namespace pcl_cid
