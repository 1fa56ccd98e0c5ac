/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labelled scans as annotations and predictions of ScanNet.
 */

#pragma once

#include <pcl_cid/core/instance_overlaps.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/io/labelled_instances.h>
#include <pcl_cid/io/output_files.h>

#include <cstdint>
#include <string>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Where an annotation of ScanNet goes. */
struct ScannetPlace {
  /** Where the files `<id>...` are. */
  std::string folder;
  /** `scene0000_00`. */
  std::string id;
  /** The table scannetv2-labels.combined.tsv, whose `raw_category` are then the
   *  classes; without it they are nyu40Classes(). */
  std::string class_table;
};

/** \brief Groups cut where labels part: a segment for each pair of group and label that
 *  there is, numbered from 0 by their first points.
 *  \param[in] group of each point, -1 for none; when empty, all points are in one
 *  \throws CIDException when there is not one group for each label */
PCL_CID_IO_EXPORT std::vector<std::uint32_t>
segmentsOfLabels(const pcl::Indices& group, const std::vector<std::uint32_t>& label);

/** \brief Write a labelled scan as an annotation of ScanNet, which readScannetScan()
 *  and its tools open beside the mesh: `<id>_vh_clean_2.0.010000.segs.json` with
 *  segmentsOfLabels(), and `<id>.aggregation.json` with the segments and the class of
 *  each instance. Object ids count from 0 in the order of the labels.
 *  \param[in] group of each point, such as those that were labelled; may be empty
 *  \param[in,out] outputs announced and written; the caller commits them
 *  \throws CIDException when requireConsistent() or \a outputs refuses, when there is
 * not one group for each point, and when ScanNet does not have a class: all of these
 * are named, each with those that are spelled nearly alike */
PCL_CID_IO_EXPORT void
writeScannetAnnotation(const LabelledInstances& scan,
                       const pcl::Indices& group,
                       const ScannetPlace& place,
                       OutputFiles& outputs);

/** \brief The instances with ScanNet's numbers of their classes (`nyu40id`), for
 *  writeScannetSubmission(): in the order of the labels, with confidence 1.
 *  \param[in] class_table see ScannetPlace
 *  \throws CIDException as writeScannetAnnotation() */
PCL_CID_IO_EXPORT std::vector<PredictedInstance>
scannetInstances(const LabelledInstances& scan, const std::string& class_table = "");

/** \brief Those of the classes that ScanNet's benchmark counts; it takes no others. */
PCL_CID_IO_EXPORT std::vector<PredictedInstance>
ofBenchmarkClasses(std::vector<PredictedInstance> instances);

/** \brief Announce what writeScannetSubmission() writes, as far as it is known before
 *  there are instances.
 *  \param[in] folder is made when it is missing */
PCL_CID_IO_EXPORT void
announceScannetSubmission(const std::string& folder,
                          const std::string& scan_id,
                          OutputFiles& outputs);

/** \brief Write predictions of a scan for ScanNet's benchmark: the list `<id>.txt` and
 * a mask for each in `pred_mask`. Masks of this scan that an earlier run left there are
 *  removed.
 *  \param[in] label of each point
 *  \param[in] instances see ofBenchmarkClasses()
 *  \param[in,out] outputs knows them by announceScannetSubmission(); the caller commits
 *  them */
PCL_CID_IO_EXPORT void
writeScannetSubmission(const std::string& folder,
                       const std::string& scan_id,
                       const std::vector<std::uint32_t>& label,
                       const std::vector<PredictedInstance>& instances,
                       OutputFiles& outputs);

} // namespace pcl_cid
