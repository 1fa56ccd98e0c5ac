/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The types of point fields, and their values as bytes and as text.
 */

#include "field_values.h"

#include "text/numbers.h"

#include <type_traits>

namespace pcl_cid {

double
toDouble(const std::uint8_t* bytes, std::uint8_t datatype)
{
  return visitType(datatype, [&](auto type) {
    return static_cast<double>(loadValue<decltype(type)>(bytes));
  });
}

std::size_t
sizeOf(std::uint8_t datatype)
{
  return visitType(datatype, [](auto value) { return sizeof(value); });
}

char
kindOf(std::uint8_t datatype)
{
  if (datatype == pcl::PCLPointField::BOOL)
    return 'B';
  return visitType(datatype, [](auto value) {
    using Value = decltype(value);
    return std::is_floating_point_v<Value> ? 'F' : std::is_signed_v<Value> ? 'I' : 'U';
  });
}

std::uint8_t
datatypeOf(char kind, std::size_t size)
{
  for (const std::uint8_t datatype : {pcl::PCLPointField::INT8,
                                      pcl::PCLPointField::UINT8,
                                      pcl::PCLPointField::BOOL,
                                      pcl::PCLPointField::INT16,
                                      pcl::PCLPointField::UINT16,
                                      pcl::PCLPointField::INT32,
                                      pcl::PCLPointField::UINT32,
                                      pcl::PCLPointField::INT64,
                                      pcl::PCLPointField::UINT64,
                                      pcl::PCLPointField::FLOAT32,
                                      pcl::PCLPointField::FLOAT64})
    if (kindOf(datatype) == kind && sizeOf(datatype) == size)
      return datatype;
  return 0;
}

bool
parseValue(std::string_view text, std::uint8_t datatype, std::uint8_t* bytes)
{
  return visitType(datatype, [&](auto type) {
    const auto value = parseLoosely<decltype(type)>(text);
    if (value)
      std::memcpy(bytes, &*value, sizeof(*value));
    return value.has_value();
  });
}

void
appendValue(const std::uint8_t* bytes, std::uint8_t datatype, std::string& text)
{
  visitType(datatype,
            [&](auto type) { appendNumber(loadValue<decltype(type)>(bytes), text); });
}

const pcl::PCLPointField*
findField(const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.name == name)
      return &field;
  return nullptr;
}

pcl::PCLPointField&
addField(const std::string& name,
         std::uint8_t datatype,
         std::uint32_t count,
         pcl::PCLPointCloud2& cloud)
{
  pcl::PCLPointField field;
  field.name = name;
  field.datatype = datatype;
  field.count = count;
  field.offset = cloud.point_step;
  cloud.point_step += static_cast<pcl::uindex_t>(count * sizeOf(datatype));
  cloud.fields.push_back(field);
  return cloud.fields.back();
}

} // namespace pcl_cid
