/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Seeds with their labels, and what follows from them.
 */

#pragma once

#include <pcl_cid/cid_part_parameters.h>
#include <pcl_cid/core/grouping.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace pcl_cid::python {

/** \brief Parts from a scan and its groups, by the settings of the classes. */
class PartMaker : public CIDPartParameters {
public:
  using CIDPartParameters::cutGroups;
  using CIDPartParameters::cutPatches;
  using CIDPartParameters::fitParts;
  using CIDPartParameters::makeParts;
  using CIDPartParameters::partOfEachPoint;
  using CIDPartParameters::simplifyParts;
};

/** \brief A state of the seeds of a scan. It never changes, so that threads may read it
 *  while another one makes the next: what takes long is made when first asked for, and
 *  kept. */
class Seeding {
public:
  using Groups = std::shared_ptr<const std::vector<pcl::index_t>>;

  /** \param[in] labels one for each seed */
  Seeding(Grouping::ConstPtr grouping, std::vector<std::uint32_t> labels)
  : grouping_(std::move(grouping)), labels_(std::move(labels))
  {
  }

  /** \brief The same seeds with other labels. */
  Seeding(const Seeding& other, std::vector<std::uint32_t> labels);

  const Grouping::ConstPtr&
  grouping() const
  {
    return grouping_;
  }

  const std::vector<std::uint32_t>&
  labelsOfSeeds() const
  {
    return labels_;
  }

  /** \brief See Grouping::groups(). */
  Groups
  groups(const ExecutionOptions& execution) const;

  /** \brief The label of the seed of each point; 0 where there is none. */
  std::vector<std::uint32_t>
  labels(bool clean_up, const ExecutionOptions& execution) const;

  /** \brief What makes parts of these groups: it has the tree of the last one that was
   *  kept, with the settings that it had. */
  PartMaker
  partMaker() const;

  void
  keep(const PartMaker& maker) const;

private:
  Grouping::ConstPtr grouping_;
  std::vector<std::uint32_t> labels_;
  /** Of the two below, and never held while something is made: a callback may ask for
   *  it, too. */
  mutable std::mutex mutex_;
  mutable Groups groups_;
  mutable PartMaker part_maker_;
};

} // namespace pcl_cid::python
