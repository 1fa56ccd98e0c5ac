/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What tools made for ScanNet read: superpoints, and predictions for its benchmark.
 */

#pragma once

#include <pcl_cid/core/instance_overlaps.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Write groups as a `segs.json`: superpoints for nets that expect the
 *  segmentation of a mesh.
 *  \param[in] scan_id written as `sceneId`
 *  \param[in] group of each point, from 0; points in none (-1) share a segment of their
 *  own, numbered after the last group */
PCL_CID_IO_EXPORT void
writeSuperpoints(std::ostream& stream,
                 const std::string& scan_id,
                 const pcl::Indices& group);

/** \brief Write segments as a `segs.json`.
 *  \param[in] scan_id written as `sceneId`
 *  \param[in] segments of each point */
PCL_CID_IO_EXPORT void
writeSegments(std::ostream& stream,
              const std::string& scan_id,
              const std::vector<std::uint32_t>& segments);

/** \brief The instances that were predicted when an annotator who knows the truth
 *  labeled the seeds: one for each label but 0. Its class is that of the true instance
 *  with this label, by the rule of overlapsOf().
 *  \param[in] labels predicted, one for each point
 *  \param[in] true_labels the same numbers, as the annotator saw them
 *  \param[in] true_classes of each point, 0 for none
 *  \return in the order of the labels; a label that the truth does not have gets the
 *  class 0
 *  \throws CIDException when the three are not of one size */
PCL_CID_IO_EXPORT std::vector<PredictedInstance>
instancesWithTrueClass(const std::vector<std::uint32_t>& labels,
                       const std::vector<std::uint32_t>& true_labels,
                       const std::vector<std::uint32_t>& true_classes);

/** \brief Folder of the masks, beside the list of predictions. */
constexpr const char* mask_folder = "pred_mask";

/** \brief `scene0000_00_000.txt`.
 *  \param[in] number of the instance, from 0 */
PCL_CID_IO_EXPORT std::string
maskFileName(const std::string& scan_id, std::size_t number);

/** \brief Whether maskFileName() gives this name to some instance of the scan. */
PCL_CID_IO_EXPORT bool
isMaskFileName(const std::string& name, const std::string& scan_id);

/** \brief Write the predictions of a scan, `<id>.txt`: a line
 *  `pred_mask/<id>_NNN.txt <class> <confidence>` for each.
 *  \param[in] instances their classes are numbers of nyu40Classes(), their confidences
 *  above 0, to 1 */
PCL_CID_IO_EXPORT void
writePredictions(std::ostream& stream,
                 const std::string& scan_id,
                 const std::vector<PredictedInstance>& instances);

/** \brief Write a mask: a line for each point, 1 when it has the label, else 0. */
PCL_CID_IO_EXPORT void
writeMask(std::ostream& stream,
          const std::vector<std::uint32_t>& labels,
          std::uint32_t label);

} // namespace pcl_cid
