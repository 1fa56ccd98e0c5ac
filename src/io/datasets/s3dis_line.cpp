/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One line of a file of S3DIS.
 */

#include "s3dis_line.h"

#include "text/numbers.h"
#include "text/words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl_cid {
namespace {

constexpr std::size_t columns = 6;
constexpr std::string_view blanks = " \t";

bool
isControlByte(char byte)
{
  return static_cast<unsigned char>(byte) < 0x20 && byte != '\t';
}

/** Blue is the lowest byte. */
std::uint32_t
packed(const float* color)
{
  std::uint32_t rgb = 0;
  for (int channel = 0; channel < 3; ++channel)
    rgb = rgb << 8 | static_cast<std::uint32_t>(std::lround(color[channel]));
  return rgb;
}

} // namespace

std::optional<S3DISPoint>
parseS3DISLine(std::string_view line)
{
  float values[columns];
  for (float& value : values) {
    const auto number = parseNumber<float>(takeWord(line, blanks));
    if (!number || !std::isfinite(*number))
      return std::nullopt;
    value = *number;
  }
  const float* const color = values + 3;
  if (!takeWord(line, blanks).empty() ||
      !std::all_of(color, color + 3, [](float channel) {
        return channel >= 0.0f && channel <= 255.0f;
      }))
    return std::nullopt;
  return S3DISPoint{values[0], values[1], values[2], packed(color)};
}

bool
hasControlByte(std::string_view line)
{
  return std::any_of(line.begin(), line.end(), isControlByte);
}

std::string
withLostBits(std::string_view line)
{
  constexpr char lost_bit = 0x20;
  const std::string_view possible = "0123456789+-. ";
  std::string whole(line);
  for (char& byte : whole)
    if (isControlByte(byte)) {
      const char before = static_cast<char>(byte | lost_bit);
      if (possible.find(before) != std::string_view::npos)
        byte = before;
    }
  return whole;
}

std::string
printable(std::string_view line)
{
  constexpr std::size_t most = 64;
  std::string text;
  for (const char byte : line.substr(0, most))
    if (isControlByte(byte)) {
      char escaped[5];
      std::snprintf(
          escaped, sizeof(escaped), "\\x%02x", static_cast<unsigned int>(byte));
      text += escaped;
    }
    else
      text += byte;
  return text;
}

} // namespace pcl_cid
