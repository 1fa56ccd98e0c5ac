/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What surfaces of a test room look like: + - * / and floor only.
 */

#include "material.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_cid::test {
namespace {

/// 0 at whole numbers, 1 halfway between them.
double
triangleWave(double x)
{
  return 1.0 - std::abs(2.0 * (x - std::floor(x)) - 1.0);
}

bool
isOdd(double whole)
{
  return whole - 2.0 * std::floor(whole / 2.0) > 0.5;
}

/// One of 0, 1/3, 2/3 and 1 for each square, without an order that one could see.
double
shareOfBlock(double column, double row)
{
  const auto mixed =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(column)) *
          0x9E3779B97F4A7C15u +
      static_cast<std::uint64_t>(static_cast<std::int64_t>(row)) * 0xC2B2AE3D27D4EB4Fu;
  return static_cast<double>(((mixed ^ (mixed >> 29)) >> 13) & 3u) / 3.0;
}

/// How much of the second color there is.
double
shareOfSecond(const Material& material, double u, double v)
{
  const double a = u / material.period;
  const double b = v / material.period;
  switch (material.pattern) {
  case Pattern::stripes:
    return triangleWave(b + 0.4 * triangleWave(a / 9.0));
  case Pattern::checks:
    return isOdd(std::floor(a) + std::floor(b)) ? 1.0 : 0.0;
  case Pattern::bands:
    return triangleWave(a) > 0.7 ? 1.0 : 0.0;
  case Pattern::blocks:
    return shareOfBlock(std::floor(a), std::floor(b));
  default:
    return 0.0;
  }
}

/// Each channel on its own, between those of two colors.
Rgb
drawBetween(RandomGenerator& generator, const Rgb& low, const Rgb& high)
{
  return {drawWithin(generator, {low.x(), high.x()}),
          drawWithin(generator, {low.y(), high.y()}),
          drawWithin(generator, {low.z(), high.z()})};
}

} // namespace

Rgb
colorAt(const Material& material, double u, double v)
{
  const double share = shareOfSecond(material, u, v);
  return (1.0 - share) * material.base + share * material.second;
}

Rgb
drawWhite(RandomGenerator& generator)
{
  return Rgb::Constant(drawWithin(generator, {230.0, 250.0}));
}

Rgb
drawPale(RandomGenerator& generator)
{
  return drawBetween(generator, {195.0, 190.0, 170.0}, {240.0, 235.0, 230.0});
}

Rgb
drawWood(RandomGenerator& generator)
{
  const double light = drawWithin(generator, {0.5, 1.0});
  return light * drawBetween(generator, {190.0, 130.0, 70.0}, {225.0, 165.0, 110.0});
}

Rgb
drawDark(RandomGenerator& generator)
{
  return Rgb::Constant(drawWithin(generator, {35.0, 90.0}));
}

Rgb
drawVivid(RandomGenerator& generator)
{
  const double value = drawWithin(generator, {120.0, 230.0});
  const double saturation = drawWithin(generator, {0.5, 0.9});
  const double hue = drawWithin(generator, {0.0, 6.0});
  Rgb color;
  for (int channel = 0; channel < 3; ++channel) {
    const double turned = hue + 2.0 * channel;
    const double around = turned - 6.0 * std::floor(turned / 6.0);
    const double fullness = std::clamp(std::abs(around - 3.0) - 1.0, 0.0, 1.0);
    color[channel] = value * (1.0 - saturation * (1.0 - fullness));
  }
  return color;
}

Rgb
drawSkin(RandomGenerator& generator)
{
  const double light = drawWithin(generator, {0.45, 1.0});
  return light * Rgb(232.0, 185.0, 155.0);
}

Material
striped(const Rgb& base, double period)
{
  return {base, 0.8 * base, Pattern::stripes, period};
}

} // namespace pcl_cid::test
