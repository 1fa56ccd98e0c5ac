/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The first line of a session file.
 */

#include "settings_json.h"
#include "json_fields.h"

#include <charconv>

namespace pcl_cid {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

constexpr const char* format = "pcl_cid session";
constexpr int version = 1;

/** Call `visit(row, value)` for each setting that labels depend on; the same list
 *  writes and reads. */
template <typename Settings, typename Visit>
void
forEachRow(Settings& settings, const Visit& visit)
{
  auto& preparation = settings.preparation;
  visit(setting::samples, settings.grouping.samples);
  visit(setting::seeding, settings.grouping.seeding);
  visit(setting::random_seed, preparation.random_seed);
  visit(setting::density, preparation.density);
  visit(setting::density_power, preparation.density_power);
  visit(setting::isolated_neighbors, preparation.isolated_neighbors);
  visit(setting::color, preparation.color);
  visit(setting::normals, preparation.normals);
  visit(setting::connected, preparation.connected);
  visit(setting::blind_spot, preparation.blind_spot);
}

struct SettingWriter {
  OrderedJson& json;

  template <typename Value>
  void
  operator()(const NumberSetting<Value>& row, const Value& value) const
  {
    if constexpr (std::is_same_v<Value, float>)
      json[row.name] = asWritten(value);
    else
      json[row.name] = value;
  }

  template <typename Value, std::size_t Count>
  void
  operator()(const ChoiceSetting<Value, Count>& row, const Value& value) const
  {
    json[row.name] = row.wordOf(value);
  }
};

struct SettingReader {
  const Json& json;

  template <typename Value>
  void
  operator()(const NumberSetting<Value>& row, Value& value) const
  {
    const Json& given = field(json, row.name);
    if constexpr (std::is_integral_v<Value>)
      value = wholeNumber<Value>(given, row.name);
    else if (given.is_number())
      value = given.get<Value>();
    else
      throw CIDException("'" + std::string(row.name) + "' is not a number");
    require(row, value);
  }

  template <typename Value, std::size_t Count>
  void
  operator()(const ChoiceSetting<Value, Count>& row, Value& value) const
  {
    const std::string word = textIn(json, row.name);
    const std::optional<Value> known = row.valueOf(word);
    if (!known)
      throw CIDException("'" + std::string(row.name) + "' is '" + word +
                         "', which it cannot be");
    value = *known;
  }
};

std::string
hexadecimal(std::uint64_t number)
{
  char text[16];
  const auto end = std::to_chars(text, text + sizeof text, number, 16).ptr;
  return {text, end};
}

std::uint64_t
fromHexadecimal(const std::string& text)
{
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number, 16);
  if (read.ec != std::errc() || read.ptr != end)
    throw CIDException("'checksum' is '" + text + "'; it must be a hexadecimal number");
  return number;
}

} // namespace

OrderedJson
headerOf(const ScanIdentity& scan, const SessionSettings& settings)
{
  OrderedJson rows;
  forEachRow(settings, SettingWriter{rows});
  if (settings.preparation.start_index)
    rows[setting::start_index.name] = *settings.preparation.start_index;
  rows["keep_zeros"] = settings.keep_zeros;
  if (!settings.imported.empty())
    rows["imported"] = settings.imported;
  return {{"format", format},
          {"version", version},
          {"scan",
           {{"name", scan.name},
            {"points", scan.points},
            {"checksum", hexadecimal(scan.checksum)}}},
          {"settings", std::move(rows)}};
}

SessionRecord
recordFrom(const Json& header)
{
  if (textIn(header, "format") != format)
    throw CIDException("it is not a session of pcl_cid");
  if (const int found = wholeNumberIn<int>(header, "version"); found != version)
    throw CIDException("it is version " + std::to_string(found) +
                       " of a session; this program knows version " +
                       std::to_string(version));
  SessionRecord record;
  const Json& scan = field(header, "scan");
  record.scan = {textIn(scan, "name"),
                 wholeNumberIn<std::size_t>(scan, "points"),
                 fromHexadecimal(textIn(scan, "checksum"))};
  const Json& rows = field(header, "settings");
  forEachRow(record.settings, SettingReader{rows});
  if (rows.contains(setting::start_index.name))
    record.settings.preparation.start_index =
        wholeNumberIn<pcl::index_t>(rows, setting::start_index.name);
  const Json& keep_zeros = field(rows, "keep_zeros");
  if (!keep_zeros.is_boolean())
    throw CIDException("'keep_zeros' must be true or false");
  record.settings.keep_zeros = keep_zeros.get<bool>();
  if (rows.contains("imported"))
    record.settings.imported = textIn(rows, "imported");
  return record;
}

} // namespace pcl_cid
