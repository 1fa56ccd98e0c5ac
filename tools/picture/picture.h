/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan and what was made of it as one page for the browser.
 */

#pragma once

#include "run/command_line.h"
#include "run/loaded_scan.h"
#include "run/run.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/named_instance.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief Most points of a picture. */
constexpr std::size_t most_picture_points = 200'000;

/** \brief Most bytes of a picture's page. */
constexpr std::size_t most_picture_bytes = 8'000'000;

/** \brief What a picture shows of a scan besides its points and their colors: labels,
 *  parts or values, and null for the others. They are not copied and must live until
 *  savePicture(). */
struct Picture {
  enum class Kind { labels, groups, parts, values };

  Kind kind;
  /** Of labels and groups: one for each point of the cloud; 0 for none. */
  const std::vector<std::uint32_t>* labels = nullptr;
  /** What is known of labels; may be empty. */
  std::vector<NamedInstance> instances{};
  /** In the frame of the file. */
  const std::vector<ConvexPart>* parts = nullptr;
  /** One for each point of the cloud, metres, and what they are. */
  const std::vector<float>* values = nullptr;
  std::string values_text{};
};

/** \brief A picture of parts. */
inline Picture
pictureOf(const std::vector<ConvexPart>& parts)
{
  return {Picture::Kind::parts, nullptr, {}, &parts};
}

/** \brief A picture of values, and what they are. */
inline Picture
pictureOf(const std::vector<float>& values, const std::string& text)
{
  return {Picture::Kind::values, nullptr, {}, nullptr, &values, text};
}

/** \brief Declare `--html`. */
void
declarePictureOption(std::string& html, CommandLine& line);

/** \brief Announce a picture, when one is asked for.
 *  \throws CIDException when it cannot be written, or this program has no page for it
 */
void
announcePicture(const std::string& html, OutputFiles& outputs);

/** \brief Refuse a scan that cannot be shown, before the work, when a picture is asked
 *  for.
 *  \throws CIDException when its colors cannot be read */
void
requirePictureOf(const std::string& html, const LoadedScan& scan);

/** \brief Write a picture, when one is asked for: of at most most_picture_points
 * points, spread evenly, with the figures of the report, but for times and the number
 * of threads. Where all hulls and all rows of the list would take more than
 *  most_picture_bytes, those with the most points are in it.
 *  \param[in] html was announced
 *  \param[in] run its report is complete but for the steps that are to come */
void
savePicture(const std::string& html,
            const Picture& picture,
            const LoadedScan& scan,
            Run& run);

} // namespace pcl_cid::tools
