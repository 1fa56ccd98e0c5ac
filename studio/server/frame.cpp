/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The frames that go over the socket: a header in JSON and arrays of numbers.
 */

#include "frame.h"

#include <cstring>
#include <limits>
#include <set>
#include <utility>

namespace pcl_cid::studio {
namespace {

using nlohmann::json;

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "numbers are sent as they lie in memory");
static_assert(sizeof(float) == 4 && std::numeric_limits<float>::is_iec559);

constexpr std::size_t length_bytes = sizeof(std::uint32_t);
constexpr std::size_t number_bytes = 4; // of both types

/** What is deeper is no message of ours, and would take the stack of whoever copies it.
 */
constexpr int most_levels = 16;

/** What the header says of an array. */
struct ArrayHead {
  std::string name;
  bool is_float;
  std::size_t length;
};

std::size_t
paddedSize(std::size_t size)
{
  return (size + number_bytes - 1) / number_bytes * number_bytes;
}

std::string_view
headerText(std::string_view bytes, std::size_t most_bytes)
{
  std::uint32_t length = 0;
  if (bytes.size() < length_bytes)
    throw BadFrame("a frame has " + std::to_string(bytes.size()) +
                   " bytes; the length of its header alone takes 4");
  std::memcpy(&length, bytes.data(), length_bytes);
  if (length > most_bytes)
    throw BadFrame("the header of a frame has " + std::to_string(length) +
                   " bytes; at most " + std::to_string(most_bytes) + " are allowed");
  if (paddedSize(length) > bytes.size() - length_bytes)
    throw BadFrame("the header of a frame has " + std::to_string(length) +
                   " bytes, which with the zeros after it is more than the frame");
  return bytes.substr(length_bytes, length);
}

void
requireZeros(std::string_view padding)
{
  if (padding.find_first_not_of('\0') != std::string_view::npos)
    throw BadFrame("the bytes between the header of a frame and its arrays are not 0");
}

bool
isNotTooDeep(int depth, json::parse_event_t /*event*/, json& /*parsed*/)
{
  if (depth > most_levels)
    throw BadFrame("the header of a frame is nested more than " +
                   std::to_string(most_levels) + " deep");
  return true;
}

json
parsedHeader(std::string_view text)
{
  json header;
  try {
    header = json::parse(text.begin(), text.end(), isNotTooDeep);
  }
  catch (const json::exception&) {
    throw BadFrame("the header of a frame is not JSON");
  }
  if (!header.is_object())
    throw BadFrame("the header of a frame is not an object");
  return header;
}

ArrayHead
arrayHead(const json& entry)
{
  const char* const needed = "an array of a frame needs a name, a type (u32 or f32) "
                             "and a length, and nothing else";
  if (!entry.is_object() || entry.size() != 3 || !entry.contains("name") ||
      !entry.contains("type") || !entry.contains("length") ||
      !entry["name"].is_string() || !entry["length"].is_number_unsigned())
    throw BadFrame(needed);
  const json& type = entry["type"];
  if (type != "u32" && type != "f32")
    throw BadFrame(needed);
  return {entry["name"], type == "f32", entry["length"]};
}

/** What the header says of the arrays, which it then no longer does. */
std::vector<ArrayHead>
takeArrayHeads(json& header)
{
  std::vector<ArrayHead> heads;
  const auto listed = header.find("arrays");
  if (listed == header.end())
    return heads;
  if (!listed->is_array())
    throw BadFrame("'arrays' in the header of a frame is not a list");
  std::set<std::string> names;
  for (const json& entry : *listed) {
    heads.push_back(arrayHead(entry));
    if (!names.insert(heads.back().name).second)
      throw BadFrame("two arrays of a frame have the same name");
  }
  header.erase(listed);
  return heads;
}

template <typename Number>
std::vector<Number>
numbers(std::string_view bytes)
{
  std::vector<Number> values(bytes.size() / sizeof(Number));
  if (!values.empty())
    std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

NamedArray
takeArray(ArrayHead head, std::string_view& bytes)
{
  if (head.length > bytes.size() / number_bytes)
    throw BadFrame("the arrays of a frame are longer than the frame");
  const std::string_view own = bytes.substr(0, head.length * number_bytes);
  bytes.remove_prefix(own.size());
  if (head.is_float)
    return {std::move(head.name), numbers<float>(own)};
  return {std::move(head.name), numbers<std::uint32_t>(own)};
}

std::string_view
bytesOf(const NamedArray& array)
{
  return std::visit(
      [](const auto& values) {
        return std::string_view(reinterpret_cast<const char*>(values.data()),
                                values.size() * number_bytes);
      },
      array.values);
}

json
listed(const std::vector<NamedArray>& arrays)
{
  json list = json::array();
  for (const NamedArray& array : arrays)
    list.push_back(
        {{"name", array.name},
         {"type",
          std::holds_alternative<std::vector<float>>(array.values) ? "f32" : "u32"},
         {"length", bytesOf(array).size() / number_bytes}});
  return list;
}

std::string
headOf(const json& header)
{
  const std::string text = header.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > std::numeric_limits<std::uint32_t>::max())
    throw BadFrame("the header of a frame has more than 4 GiB");
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string head(length_bytes + paddedSize(text.size()), '\0');
  std::memcpy(head.data(), &length, length_bytes);
  text.copy(head.data() + length_bytes, text.size());
  return head;
}

} // namespace

Frame
decodeFrame(std::string_view bytes, std::size_t most_bytes)
{
  const std::string_view text = headerText(bytes, most_bytes);
  bytes.remove_prefix(length_bytes + text.size());
  const std::size_t padding = paddedSize(text.size()) - text.size();
  requireZeros(bytes.substr(0, padding));
  bytes.remove_prefix(padding);

  Frame frame;
  frame.header = parsedHeader(text);
  for (ArrayHead& head : takeArrayHeads(frame.header))
    frame.arrays.push_back(takeArray(std::move(head), bytes));
  if (!bytes.empty())
    throw BadFrame("a frame has " + std::to_string(bytes.size()) +
                   " bytes more than its header and its arrays");
  return frame;
}

EncodedFrame::EncodedFrame(Frame frame) : arrays_(std::move(frame.arrays))
{
  if (!arrays_.empty())
    frame.header["arrays"] = listed(arrays_);
  head_ = headOf(frame.header);
  size_ = 0;
  for (const std::string_view piece : pieces())
    size_ += piece.size();
}

std::vector<std::string_view>
EncodedFrame::pieces() const
{
  std::vector<std::string_view> pieces{head_};
  for (const NamedArray& array : arrays_)
    pieces.push_back(bytesOf(array));
  return pieces;
}

} // namespace pcl_cid::studio
