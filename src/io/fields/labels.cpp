/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels of a cloud: any field read as labels, a field of labels written.
 */

#include "base/sentence.h"
#include "field_exchange.h"
#include "field_values.h"
#include "required_fields.h"
#include "text/numbers.h"

#include <pcl_cid/io/cloud_points.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace pcl_cid {
namespace {

constexpr double largest_label = std::numeric_limits<std::uint32_t>::max();

/** \return whether the value stands for no label, as other programs write it */
template <typename Value>
bool
isNone(Value value)
{
  if constexpr (std::is_floating_point_v<Value>)
    return std::isnan(value) || value == -1;
  else
    return std::is_signed_v<Value> && value == static_cast<Value>(-1);
}

/** \return whether the value is a whole number that a label can be */
template <typename Value>
bool
isLabel(Value value)
{
  if constexpr (std::is_floating_point_v<Value>)
    return value >= 0 && static_cast<double>(value) <= largest_label &&
           std::floor(value) == value;
  else
    return value >= 0 && static_cast<std::uint64_t>(value) <=
                             std::numeric_limits<std::uint32_t>::max();
}

std::uint8_t
datatypeOf(LabelType type)
{
  return type == LabelType::U4   ? pcl::PCLPointField::UINT32
         : type == LabelType::I4 ? pcl::PCLPointField::INT32
                                 : pcl::PCLPointField::FLOAT32;
}

void
storeLabel(std::uint32_t label, LabelType type, std::uint8_t* bytes)
{
  const auto as_float = static_cast<float>(label);
  if (type == LabelType::F4)
    std::memcpy(bytes, &as_float, sizeof(as_float));
  else
    std::memcpy(bytes, &label, sizeof(label));
}

} // namespace

bool
hasField(const LabelledCloud& cloud, const std::string& name)
{
  return findField(cloud.fields, name) != nullptr;
}

std::vector<std::uint32_t>
labelsOf(const LabelledCloud& cloud,
         const std::string& field,
         const CloudPoints& points,
         const RemarkCallback& remark)
{
  const pcl::PCLPointField& source = requireField(cloud, field);
  std::vector<std::uint32_t> labels(cloud.size(), 0);
  std::size_t none = 0;
  visitType(source.datatype, [&](auto type) {
    const std::uint8_t* bytes = cloud.fields.data.data() + source.offset;
    for (std::size_t i = 0; i < cloud.size(); ++i, bytes += cloud.fields.point_step) {
      if (!(*points.points)[i].getVector3fMap().allFinite())
        continue;
      const auto value = loadValue<decltype(type)>(bytes);
      if (isNone(value)) {
        ++none;
        continue;
      }
      if (!isLabel(value))
        throw CIDException(
            sentence(cloud.name,
                     ": field '",
                     field,
                     "' of point ",
                     cloud.first_point + i,
                     " is ",
                     +value,
                     "; a label must be a whole number, 0 to 4294967295, or -1 or NaN "
                     "for none"));
      labels[i] = static_cast<std::uint32_t>(value);
    }
  });
  if (none > 0 && remark)
    remark(sentence(cloud.name,
                    ": field '",
                    field,
                    "' is -1 or NaN for ",
                    countOf(none, "point"),
                    "; taken as label 0"));
  return labels;
}

void
requireLabelsFit(const std::vector<std::uint32_t>& labels, LabelType type)
{
  const std::uint32_t largest =
      type == LabelType::U4   ? std::numeric_limits<std::uint32_t>::max()
      : type == LabelType::I4 ? std::numeric_limits<std::int32_t>::max()
                              : 1u << std::numeric_limits<float>::digits;
  for (const std::uint32_t label : labels)
    if (label > largest)
      throw CIDException(sentence("label ",
                                  label,
                                  " does not fit the label type ",
                                  type == LabelType::I4 ? "I4" : "F4",
                                  ", which goes to ",
                                  largest,
                                  "; use U4"));
}

void
setLabels(const std::vector<std::uint32_t>& labels,
          LabelType type,
          LabelledCloud& cloud,
          const std::string& name)
{
  requireOneEach(labels.size(), "labels", cloud);
  requireLabelsFit(labels, type);
  exchangeField(
      name,
      datatypeOf(type),
      [&](std::size_t i, std::uint8_t* bytes) { storeLabel(labels[i], type, bytes); },
      cloud);
}

} // namespace pcl_cid
