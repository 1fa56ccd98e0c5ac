/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels with ragged boundaries mended: a small energy over the points near them.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief The rows of what cleanBoundaries() is told; none is an option of a tool. */
namespace cleaning_setting {

// clang-format off

inline constexpr NumberSetting<float> reach{
    "Labels", "reach", "reach of a boundary", "R", "spacings", 2.0f, 0.0f, 100.0f,
    "points this near to another label may change theirs, in medians of the distance "
    "from a point to its eighth neighbor"};

inline constexpr NumberSetting<float> most_loss{
    "Labels", "most_loss", "most that a label may lose", "R", "metres", 0.1f,
    setting::above_zero, 100.0f,
    "a label that costs more than the best one counts as costing this much more"};

inline constexpr NumberSetting<float> pull{
    "Labels", "pull", "pull of neighbors", "R", "metres", 0.01f, 0.0f, 100.0f,
    "what two neighbors cost whose labels differ, though normals and colors agree"};

inline constexpr NumberSetting<float> normal_scale{
    "Labels", "normal_scale", "scale of normals", "S", "", 0.1f, 1e-6f, 1e6f,
    "the pull falls to 1/e where 1 - |cosine| of the normals is this"};

inline constexpr NumberSetting<float> color_scale{
    "Labels", "color_scale", "scale of colors", "S", "units of L*a*b*", 8.0f, 1e-6f, 1e6f,
    "the pull falls to 1/e where the colors differ by this"};

inline constexpr NumberSetting<int> most_cycles{
    "Labels", "most_cycles", "most cycles", "N", "", 20, 0, setting::any_number,
    "how often all labels are tried, unless nothing changes before"};

// clang-format on

} // namespace cleaning_setting

/** \brief Which points may change, and what they weigh against each other. */
struct CleaningSettings {
  /** See the rows of `cleaning_setting` with these names. */
  float reach = cleaning_setting::reach.initial;
  float most_loss = cleaning_setting::most_loss.initial;
  float pull = cleaning_setting::pull.initial;
  float normal_scale = cleaning_setting::normal_scale.initial;
  float color_scale = cleaning_setting::color_scale.initial;
  int most_cycles = cleaning_setting::most_cycles.initial;
};

/** \brief The label of each point's seed (section IV.A), with the boundaries between
 *  labels mended (*ours*).
 *
 *  A point is *free* when it is no seed, has a label other than 0, and another such
 *  label is within the reach of it; only free points may change, and only to labels
 *  within their reach. They share an energy: what the label of a point costs it more
 *  than its best one, at most `most_loss`, the cost of a label being the smallest cost
 *  of the point and a seed with it; and for each pair of neighbors (one is among the
 *  eight nearest of the other) with different labels, `pull * exp(-(1 - |n . m|) /
 *  normal_scale - |Lab - Lab'| / color_scale)`, from their normals and, where the scan
 *  was prepared with a color weight, from their colors. A term that is not known is
 *  left out.
 *
 *  Alpha expansion (Boykov, Veksler and Zabih, 2001) lowers it: label by label, in
 *  ascending order, the best set of points takes the label, until no label gains any.
 *  Where sets are equally good the smallest is taken, so a point keeps its label unless
 *  the energy falls. Terms are whole multiples of 2^-20 metres: the result is the same
 *  for every number of threads.
 *  \param[in] grouping seeds and groups; points that are not worked on follow as they
 *  do there
 *  \param[in] label_of_seed one for each seed; 0 is none, and its points keep it
 *  \param[in] execution threads and progress; never change the result
 *  \return one for each point of the cloud; 0 for a point that is not finite or not
 *  selected
 *  \throws CIDException when there are not as many labels as seeds or a setting is out
 *  of its range, CIDCancelled
 *  \note Cost: the neighbors of all points, the normals and the CIDs of free points to
 *  the seeds of labels within reach, and a few minimum cuts for each label. */
PCL_CID_EXPORT std::vector<std::uint32_t>
cleanBoundaries(const Grouping& grouping,
                const std::vector<std::uint32_t>& label_of_seed,
                const CleaningSettings& settings = {},
                const ExecutionOptions& execution = {});

} // namespace pcl_cid
