/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Numbers as text, and back.
 */

#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace pcl_cid {

/** \brief The number that a text is, all of it; none when it is something else, or a
 *  number that the type cannot hold. */
template <typename Number>
std::optional<Number>
parseNumber(std::string_view text)
{
  if (!text.empty() && text.front() == '+')
    text.remove_prefix(1);
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end)
    return std::nullopt;
  return number;
}

/** \brief The same for data of other programs, which write a whole number as 3.0, and
 *  numbers that are too small for the type: these are rounded. */
template <typename Number>
std::optional<Number>
parseLoosely(std::string_view text)
{
  if (const auto number = parseNumber<Number>(text))
    return number;
  const auto wide = parseNumber<long double>(text); // holds all integers of 64 bits
  if (!wide)
    return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>) {
    if (!(std::abs(*wide) < 1))
      return std::nullopt;
  }
  else {
    using Limits = std::numeric_limits<Number>;
    if (!(*wide >= Limits::min() && *wide <= static_cast<long double>(Limits::max())) ||
        std::floor(*wide) != *wide)
      return std::nullopt;
  }
  return static_cast<Number>(*wide);
}

/** \brief Append the shortest text that gives the same bits again. */
template <typename Number>
void
appendNumber(Number number, std::string& text)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), number);
  text.append(buffer, result.ptr);
}

/** \brief "3400 points", "1 point". */
inline std::string
countOf(std::size_t count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

} // namespace pcl_cid
