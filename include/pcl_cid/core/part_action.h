/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a person who chooses the parts of a scan can do.
 */

#pragma once

#include <cstddef>
#include <variant>

/** \brief What a person who chooses the parts of a scan can do to a PartSession. A part
 *  goes by the number of the lowest group in it. */
namespace pcl_cid::part_action {

/** \brief Groups of all points, their merge tree, and the parts where the tree bends
 *  (MergeTree::cutAtElbow()). */
struct Decompose {
  std::size_t groups; ///< K, at least 1; fewer where there are fewer points
};

/** \brief The parts of the merge tree when so many remain; one that stays keeps its
 *  marks. */
struct Cut {
  std::size_t parts; ///< K', 1 to K
};

/** \brief The two that a part was joined of take its place. */
struct Split {
  int part;
};

/** \brief Two parts become one, whatever the tree says; it is dropped only if both
 *  were. */
struct Join {
  int part;
  int with;
};

/** \brief Leave a part out. */
struct Drop {
  int part;
};

/** \brief A part is in again. */
struct Keep {
  int part;
};

/** \brief Mark a part whose hull shall not be made simpler, or take the mark away. */
struct Exact {
  int part;
  bool exact;
};

/** \brief Take back the last step that was not taken back: an action, or cuts one after
 *  another. */
struct Undo {};

/** \brief Do the step again that was taken back last. */
struct Redo {};

} // namespace pcl_cid::part_action

namespace pcl_cid {

using PartAction = std::variant<part_action::Decompose,
                                part_action::Cut,
                                part_action::Split,
                                part_action::Join,
                                part_action::Drop,
                                part_action::Keep,
                                part_action::Exact,
                                part_action::Undo,
                                part_action::Redo>;

} // namespace pcl_cid
