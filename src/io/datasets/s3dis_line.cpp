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
#include <limits>

namespace pcl_cid {
namespace {

constexpr float largest_coordinate = std::numeric_limits<float>::max();
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

template <typename Coordinate>
std::optional<S3DISPoint<Coordinate>>
parseS3DISLine(std::string_view line)
{
  Coordinate coordinates[3];
  for (Coordinate& coordinate : coordinates) {
    // Numbers too small for the type are as good as 0.
    const auto number = parseLoosely<Coordinate>(takeWord(line, blanks));
    if (!number || !(std::abs(*number) <= largest_coordinate))
      return std::nullopt;
    coordinate = *number;
  }
  float color[3];
  for (float& channel : color) {
    const auto number = parseNumber<float>(takeWord(line, blanks));
    if (!number || !(*number >= 0.0f && *number <= 255.0f))
      return std::nullopt;
    channel = *number;
  }
  if (!takeWord(line, blanks).empty())
    return std::nullopt;
  return S3DISPoint<Coordinate>{
      coordinates[0], coordinates[1], coordinates[2], packed(color)};
}

template std::optional<S3DISPoint<float>> parseS3DISLine(std::string_view);
template std::optional<S3DISPoint<double>> parseS3DISLine(std::string_view);

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
