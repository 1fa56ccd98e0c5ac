/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a person has labelled in a scan, for the writers of datasets.
 */

#pragma once

#include <pcl_cid/core/named_instance.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief The labels of a scan and what they mean. */
struct LabelledInstances {
  /** Of each point of the cloud, in its order; 0 for none. */
  std::vector<std::uint32_t> label;
  /** In any order. One without points is allowed, and no writer writes it. */
  std::vector<NamedInstance> instances;
};

/** \brief Refuse labels that do not belong to a cloud or to the instances.
 *  \param[in] points of the cloud
 *  \param[in] name of the cloud, for the message
 *  \throws CIDException when there is not one label for each point, an instance has the
 *  label 0 or that of another, or a label has no instance */
PCL_CID_IO_EXPORT void
requireConsistent(const LabelledInstances& scan,
                  std::size_t points,
                  const std::string& name);

} // namespace pcl_cid
