/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The one table of settings: ranges in words, and their check.
 */

#include "sentence.h"

#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>

#include <charconv>
#include <type_traits>

namespace pcl_cid {
namespace {

template <typename Value>
std::string
wholeNumberRange(const NumberSetting<Value>& setting)
{
  if (setting.most == std::numeric_limits<Value>::max() && setting.least != Value{0})
    return sentence("a whole number, at least ", setting.least);
  if (setting.most == std::numeric_limits<Value>::max() && std::is_same_v<Value, int>)
    return "a whole number, 0 or more";
  return sentence("a whole number, ", setting.least, " to ", setting.most);
}

template <typename Value>
std::string
realNumberRange(const NumberSetting<Value>& setting)
{
  const std::string number =
      *setting.unit ? sentence("a number of ", setting.unit) : "a number";
  const bool is_open = setting.most == std::numeric_limits<Value>::max();
  if (is_open && setting.least == Value{0})
    return number + ", 0 or more";
  if (setting.least == std::numeric_limits<Value>::min())
    return number + " above 0" + (is_open ? "" : sentence(", at most ", setting.most));
  return sentence(number, ", ", setting.least, " to ", setting.most);
}

} // namespace

template <typename Value>
std::string
rangeOf(const NumberSetting<Value>& setting)
{
  std::string range;
  if constexpr (std::is_integral_v<Value>)
    range = wholeNumberRange(setting);
  else
    range = realNumberRange(setting);
  const bool zero_is_beside = setting.zero && setting.least > Value{0};
  return zero_is_beside ? sentence(range, ", or 0 ", setting.zero) : range;
}

template <typename Value>
void
require(const NumberSetting<Value>& setting, Value value)
{
  if (!setting.allows(value))
    throw CIDException(sentence(
        "the ", setting.title, " is ", value, "; it must be ", rangeOf(setting)));
}

double
asWritten(float value)
{
  char text[32];
  const char* const end = std::to_chars(text, text + sizeof text, value).ptr;
  double read = 0.0;
  std::from_chars(text, end, read);
  return read;
}

#define PCL_CID_INSTANTIATE_SETTING(Value)                                             \
  template PCL_CID_EXPORT std::string rangeOf(const NumberSetting<Value>&);            \
  template PCL_CID_EXPORT void require(const NumberSetting<Value>&, Value);

PCL_CID_INSTANTIATE_SETTING(int)
PCL_CID_INSTANTIATE_SETTING(unsigned int)
PCL_CID_INSTANTIATE_SETTING(std::uint64_t)
PCL_CID_INSTANTIATE_SETTING(float)
PCL_CID_INSTANTIATE_SETTING(double)

#undef PCL_CID_INSTANTIATE_SETTING

} // namespace pcl_cid
