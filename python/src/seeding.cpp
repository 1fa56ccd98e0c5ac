/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Seeds with their labels, and what follows from them.
 */

#include "seeding.h"

#include <pcl_cid/core/label_cleaning.h>

namespace pcl_cid::python {

Seeding::Seeding(const Seeding& other, std::vector<std::uint32_t> labels)
: grouping_(other.grouping_), labels_(std::move(labels))
{
  const std::lock_guard<std::mutex> lock(other.mutex_);
  groups_ = other.groups_;
  part_maker_ = other.part_maker_;
}

Seeding::Groups
Seeding::groups(const ExecutionOptions& execution) const
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (groups_)
      return groups_;
  }
  auto made =
      std::make_shared<const std::vector<pcl::index_t>>(grouping_->groups(execution));
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!groups_)
    groups_ = std::move(made);
  return groups_;
}

std::vector<std::uint32_t>
Seeding::labels(bool clean_up, const ExecutionOptions& execution) const
{
  if (clean_up)
    return cleanBoundaries(*grouping_, labels_, {}, execution);
  const Groups groups = this->groups(execution);
  std::vector<std::uint32_t> labels(groups->size(), 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (const pcl::index_t group = (*groups)[i]; group >= 0)
      labels[i] = labels_[static_cast<std::size_t>(group)];
  return labels;
}

PartMaker
Seeding::partMaker() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return part_maker_;
}

void
Seeding::keep(const PartMaker& maker) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  part_maker_ = maker;
}

} // namespace pcl_cid::python
