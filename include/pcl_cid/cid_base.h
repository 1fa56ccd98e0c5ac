/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What all classes of pcl_cid share.
 */

#pragma once

#include <pcl_cid/cid_parameters.h>
#include <pcl_cid/exceptions.h>

#include <optional>
#include <vector>

#include <pcl/pcl_base.h>
#include <pcl/point_types.h>

namespace pcl_cid {

/** \brief The input and the preparation that CIDSampler, CIDLabelPropagation and
 *  CIDConvexAbstraction share.
 *
 *  The input cloud and, when set, its indices say which points are grouped. Points that
 *  are not finite are skipped, whatever `is_dense` claims; an index that is given twice
 *  counts once. Coordinates may be at UTM offsets (see PointSet). The unit is the
 *  cloud's; "metres" in this documentation stands for it.
 *
 *  Every result is the same, to the byte, for each number of threads and each run. An
 *  object serves one thread at a time; separate objects may work side by side.
 *
 *  *Verbs* are the calls that work: sample(), segment(), reconstruct() and the like.
 *  The first one prepares the input, once (see CIDParameters). So the points must not
 *  change afterwards; when they have, call setInputCloud() again.
 *
 *  Every setter refuses a bad value at once; every verb throws CIDException when the
 *  input is missing or unusable, CIDCancelled when the progress callback says so, and
 *  then leaves its outputs empty and the object as usable as before.
 *
 *  R. Wang, Y. Xue, B. Surianarayanan, D. Tian, C. Feng: "Concavity-Induced Distance
 *  for Unoriented Point Cloud Decomposition", IEEE Robotics and Automation Letters,
 *  2023.
 *  \ingroup segmentation */
template <typename PointT>
class CIDBase : public pcl::PCLBase<PointT>, public CIDParameters {
  static_assert(pcl::traits::has_xyz_v<PointT>,
                "pcl_cid needs a point type with the fields x, y and z; register yours "
                "with POINT_CLOUD_REGISTER_POINT_STRUCT");

public:
  using Base = pcl::PCLBase<PointT>;
  using typename Base::PointCloud;
  using typename Base::PointCloudConstPtr;
  using typename Base::PointCloudPtr;

  using typename Base::PointIndicesConstPtr;

  void
  setInputCloud(const PointCloudConstPtr& cloud) override;

  void
  setIndices(const pcl::IndicesPtr& indices) override;

  void
  setIndices(const pcl::IndicesConstPtr& indices) override;

  void
  setIndices(const PointIndicesConstPtr& indices) override;

  void
  setIndices(std::size_t row_start,
             std::size_t col_start,
             std::size_t nb_rows,
             std::size_t nb_cols) override;

  /** \brief The surface S that distances are measured to; null, the default, means the
   *  points that are grouped. A setting of the preparation. */
  void
  setSearchSurface(const PointCloudConstPtr& search_surface)
  {
    search_surface_ = search_surface;
    this->forgetScan();
  }

  PointCloudConstPtr
  getSearchSurface() const
  {
    return search_surface_;
  }

protected:
  using Base::indices_;
  using Base::input_;
  using Base::use_indices_;

  CIDBase() = default;

  /** \brief The input cloud, which must be the one that was prepared.
   *  \throws CIDException when there is none, or it has another number of points */
  const PointCloud&
  preparedInput() const;

private:
  RawScan
  gatherScan() const override;

  /** \brief Check the input and its indices.
   *  \throws CIDException when there is no input, or an index is out of range */
  pcl::Indices
  selectedPoints() const;

  /** \brief Colors of the points, from setColors() or the point type; none where the
   *  color weight is 0.
   *  \throws CIDException when there are none and there should be */
  std::vector<ColorRGB>
  gatherColors(const PointSet& points) const;

  /** \brief Where the input was taken from.
   *  \return nothing when the cloud does not say it in finite numbers */
  std::optional<SensorPose>
  sensorPose(const Frame& frame) const;

  PointCloudConstPtr search_surface_;
};

} // namespace pcl_cid

#ifdef PCL_NO_PRECOMPILE
#include <pcl_cid/impl/cid_base.hpp>
#endif
