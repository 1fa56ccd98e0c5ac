/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What surfaces of a test room look like: colors and simple textures.
 */

#pragma once

#include "portable_draw.h"

#include <Eigen/Core>

namespace pcl_cid::test {

/** \brief Red, green and blue of sRGB, 0 to 255. */
using Rgb = Eigen::Vector3d;

/** \brief How the two colors of a material share a surface. */
enum class Pattern {
  plain,   ///< the first color alone
  stripes, ///< wood: soft wavy stripes along u
  checks,  ///< squares in turn
  bands,   ///< narrow bands of the second color across u
  blocks   ///< squares of four mixtures, as a print seen from afar
};

/** \brief What a surface looks like. */
struct Material {
  Rgb base{200.0, 200.0, 200.0};
  Rgb second{200.0, 200.0, 200.0};
  Pattern pattern = Pattern::plain;
  /// Length of the pattern in metres, above 0.
  double period = 1.0;
};

/** \brief The color of \a material at a place of a surface, in metres; each channel
 *  lies between those of its two colors. */
Rgb
colorAt(const Material& material, double u, double v);

/** \brief Draws: white or nearly so, a light and unobtrusive color, wood, a dark grey,
 *  a strong color, skin. */
Rgb
drawWhite(RandomGenerator& generator);
Rgb
drawPale(RandomGenerator& generator);
Rgb
drawWood(RandomGenerator& generator);
Rgb
drawDark(RandomGenerator& generator);
Rgb
drawVivid(RandomGenerator& generator);
Rgb
drawSkin(RandomGenerator& generator);

/** \brief Stripes of \a base and a darker shade of it. */
Material
striped(const Rgb& base, double period);

} // namespace pcl_cid::test
