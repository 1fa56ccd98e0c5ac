/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What all classes of pcl_cid share.
 */

#pragma once

#include <pcl_cid/core/cid_parameters.h>
#include <pcl_cid/core/preparation.h>
#include <pcl_cid/exceptions.h>

#include <optional>
#include <string>
#include <vector>

#include <pcl/pcl_base.h>
#include <pcl/point_types.h>

namespace pcl_cid {

/** \brief The input and the preparation that CIDSampler, CIDLabelPropagation and
 *  CIDConvexAbstraction share.
 *
 *  The input cloud and, when set, its indices say which points are grouped. Points that
 *  are not finite are passed over, whatever `is_dense` claims; an index that is given
 *  twice counts once. Coordinates may be at UTM offsets (see PointSet). The unit is the
 *  cloud's; "metres" in this documentation stands for it.
 *
 *  Every result is the same, to the byte, for each number of threads and each run. An
 *  object serves one thread at a time; separate objects may work side by side.
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

  /** \brief The surface S that distances are measured to; null, the default, means the
   *  points that are grouped. */
  void
  setSearchSurface(const PointCloudConstPtr& search_surface)
  {
    search_surface_ = search_surface;
  }

  PointCloudConstPtr
  getSearchSurface() const
  {
    return search_surface_;
  }

  /** \brief What the last verb found out about the density of the input, and did. */
  const DensityDecision&
  getDensityDecision() const
  {
    return density_decision_;
  }

  /** \brief The blind spot that the last verb filled, if any. */
  const std::optional<FilledBlindSpot>&
  getBlindSpot() const
  {
    return blind_spot_;
  }

protected:
  using Base::deinitCompute;
  using Base::indices_;
  using Base::initCompute;
  using Base::input_;

  CIDBase() = default;

  /** \brief Begin a verb: check the input.
   *  \throws CIDException when there is none, or an index is out of range */
  void
  beginCompute();

  /** \brief The finite, selected points, about an origin of their own. */
  PointSet
  gatherPoints() const;

  /** \brief Begin a verb: check the input, draw the working set, find the seeds in it.
   *  \param[in] given_seeds indices of the input cloud; empty for a start */
  Preparation
  prepareCompute(const pcl::Indices& given_seeds);

private:
  /** \brief Colours of the points, from setColors() or the point type; none where the
   *  color weight is 0.
   *  \throws CIDException when there are none and there should be */
  std::vector<ColorRGB>
  gatherColors(const PointSet& points) const;

  /** \brief Where the input was taken from.
   *  \param[in] origin what its points are relative to
   *  \return nothing when the cloud does not say it in finite numbers */
  std::optional<SensorPose>
  sensorPose(const Eigen::Vector3d& origin) const;

  PointCloudConstPtr search_surface_;
  std::optional<FilledBlindSpot> blind_spot_;
  DensityDecision density_decision_;
};

} // namespace pcl_cid

#ifdef PCL_NO_PRECOMPILE
#include <pcl_cid/impl/cid_base.hpp>
#endif
