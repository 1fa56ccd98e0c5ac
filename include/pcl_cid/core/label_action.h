/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a person who labels a scan can do.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include <pcl/types.h>

/** \brief What a person who labels a scan can do to a LabelSession. Points and seeds go
 *  by their index in the input cloud, instances by their label: 1 and up; 0 is none. */
namespace pcl_cid::action {

/** \brief An instance that an action makes. */
struct NewInstance {
  std::string class_name; ///< may be empty
  std::string name;       ///< may be empty
  /** Its label, one that no instance has; else the first above all that there were. */
  std::optional<std::uint32_t> label = std::nullopt;
};

/** \brief A label: 0, that of an instance, or a new one's. */
using Answer = std::variant<std::uint32_t, NewInstance>;

/** \brief Ask more questions: Algorithm 1 goes on from the seeds that there are, as far
 *  as there is a point that would gain by being one. */
struct Propose {
  std::size_t seeds; ///< how many more, at least 1
};

/** \brief Answer a question, or change the label of a seed. */
struct Label {
  pcl::index_t seed;
  Answer answer;
};

/** \brief Points become seeds with a label; those that are seeds get it. */
struct Click {
  pcl::Indices points; ///< finite and selected, at least one
  Answer answer;
};

/** \brief Take a seed away. */
struct Remove {
  pcl::index_t seed;
};

/** \brief Points have this label whatever their seeds say. */
struct Paint {
  pcl::Indices points; ///< finite and selected, ascending, at least one
  Answer answer;
};

/** \brief Painted points have the label of their seed again. */
struct Unpaint {
  pcl::Indices points; ///< as for Paint
};

/** \brief Give an instance another class and name. */
struct Edit {
  std::uint32_t label;
  std::string class_name;
  std::string name;
};

/** \brief All of an instance becomes a part of another one. */
struct Merge {
  std::uint32_t from; ///< is gone
  std::uint32_t into;
};

/** \brief An instance is gone, with its seeds; its painted points have the label of
 *  their seed again. */
struct Delete {
  std::uint32_t label;
};

/** \brief Take all questions away: their points go to the seeds that remain. */
struct Settle {};

/** \brief Take back the last action that was not taken back. */
struct Undo {};

/** \brief Do the action again that was taken back last. */
struct Redo {};

} // namespace pcl_cid::action

namespace pcl_cid {

using LabelAction = std::variant<action::Propose,
                                 action::Label,
                                 action::Click,
                                 action::Remove,
                                 action::Paint,
                                 action::Unpaint,
                                 action::Edit,
                                 action::Merge,
                                 action::Delete,
                                 action::Settle,
                                 action::Undo,
                                 action::Redo>;

} // namespace pcl_cid
