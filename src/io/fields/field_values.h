/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The types of point fields, and their values as bytes and as text.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <pcl/PCLPointCloud2.h>

namespace pcl_cid {

/** \brief What files name the bytes between fields that hold no values. */
constexpr const char* padding_name = "_";

/** \brief Call \a visit with a value of the type that a field's `datatype` stands for.
 *  \return what \a visit returns */
template <typename Visitor>
auto
visitType(std::uint8_t datatype, Visitor&& visit)
{
  switch (datatype) {
  case pcl::PCLPointField::INT8:
    return visit(std::int8_t());
  case pcl::PCLPointField::UINT8:
  case pcl::PCLPointField::BOOL:
    return visit(std::uint8_t());
  case pcl::PCLPointField::INT16:
    return visit(std::int16_t());
  case pcl::PCLPointField::UINT16:
    return visit(std::uint16_t());
  case pcl::PCLPointField::INT32:
    return visit(std::int32_t());
  case pcl::PCLPointField::UINT32:
    return visit(std::uint32_t());
  case pcl::PCLPointField::INT64:
    return visit(std::int64_t());
  case pcl::PCLPointField::UINT64:
    return visit(std::uint64_t());
  case pcl::PCLPointField::FLOAT32:
    return visit(float());
  default:
    return visit(double());
  }
}

/** \brief A value from bytes that need not be aligned. */
template <typename Value>
Value
loadValue(const std::uint8_t* bytes)
{
  Value value;
  std::memcpy(&value, bytes, sizeof(Value));
  return value;
}

/** \brief A value of any type. Whole numbers of more than 53 bits are rounded. */
double
toDouble(const std::uint8_t* bytes, std::uint8_t datatype);

/** \brief Bytes of one value. */
std::size_t
sizeOf(std::uint8_t datatype);

/** \brief 'I', 'U', 'F' or 'B', as PCD calls it. */
char
kindOf(std::uint8_t datatype);

/** \brief The datatype of a PCD's TYPE and SIZE; 0 when there is none. */
std::uint8_t
datatypeOf(char kind, std::size_t size);

/** \brief Read a value of a type from text, all of it.
 *  \param[out] bytes sizeOf(datatype) of them
 *  \return whether the text is a value of the type */
bool
parseValue(std::string_view text, std::uint8_t datatype, std::uint8_t* bytes);

/** \brief Append a value as the shortest text that gives the same bits again. */
void
appendValue(const std::uint8_t* bytes, std::uint8_t datatype, std::string& text);

/** \brief The field of this name, null when there is none. */
const pcl::PCLPointField*
findField(const pcl::PCLPointCloud2& cloud, const std::string& name);

/** \brief Add a field after those that there are; the data are not touched.
 *  \param[in,out] cloud fields and point_step */
pcl::PCLPointField&
addField(const std::string& name,
         std::uint8_t datatype,
         std::uint32_t count,
         pcl::PCLPointCloud2& cloud);

} // namespace pcl_cid
