/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings by which all classes prepare their input.
 */

#pragma once

#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <pcl/memory.h>
#include <pcl/types.h>

namespace pcl_cid {

/** \brief The color of each point of a cloud. */
using ColorsConstPtr = std::shared_ptr<const std::vector<ColorRGB>>;

/** \brief The settings of the preparation: setting one makes the next verb prepare the
 *  input again.
 *
 *  Every setter refuses a bad value at once with a CIDException and then changes
 *  nothing. Ranges and defaults: the rows of `setting` (settings.h). */
class PCL_CID_EXPORT CIDPreparationParameters {
public:
  using SearchPtr = DistanceField::SearchPtr;

  /** \brief Do as the paper does: every setting whose default is another gets the
   *  paper's (NumberSetting::paper()). The paper's experiments work on 20,000 points
   *  (setSubsample()), which is not a part of the method. */
  virtual void
  setPaperSettings();

  /** \brief Work on a random draw of this many points (the paper: 20,000), and let
   *  every other point follow its Euclidean-nearest one; 0, the default, works on all
   *  of them. */
  void
  setSubsample(int subsample);

  int
  getSubsample() const
  {
    return preparation_.subsample;
  }

  /** \brief Seed of every draw (start, subsample, soft seeds, samples of groups). */
  void
  setRandomSeed(std::uint64_t random_seed);

  std::uint64_t
  getRandomSeed() const
  {
    return preparation_.random_seed;
  }

  /** \brief Begin the traversal at this point of the input cloud instead of a random
   *  one; the verb then requires it to be a finite, selected point. */
  void
  setStartIndex(pcl::index_t start_index);

  /** \brief Begin at a random point again (the default). */
  void
  resetStartIndex();

  std::optional<pcl::index_t>
  getStartIndex() const
  {
    return preparation_.start_index;
  }

  /** \brief The points of the input cloud that may become seeds; null, the default,
   *  means all that are finite and selected. Others are skipped. */
  void
  setSeedCandidates(const pcl::shared_ptr<const pcl::Indices>& seed_candidates);

  pcl::shared_ptr<const pcl::Indices>
  getSeedCandidates() const
  {
    return preparation_.seed_candidates;
  }

  /** \brief Whether CIDs are weighted by `2 / (s(p) + s(q))`, s being the local spacing
   *  of the points: where a scan is sparse, a point is far from the surface without any
   *  concavity. The default, automatic, is on where the spacing is uneven: for a single
   *  depth view or a lidar scan, but not for points drawn evenly. */
  void
  setDensityWeight(DensityWeight density_weight);

  DensityWeight
  getDensityWeight() const
  {
    return preparation_.density;
  }

  /** \brief The power of the spacing in that weight; 0 means off. */
  void
  setDensityPower(float density_power);

  float
  getDensityPower() const
  {
    return preparation_.density_power;
  }

  /** \brief A point with fewer others near it is isolated: it never becomes a seed,
   *  unless it is a start index that was set or a seed that was given, and does not
   * count in the coverage, but belongs to a group like all others. 0: no point is
   * isolated. */
  void
  setIsolatedNeighbors(int isolated_neighbors);

  int
  getIsolatedNeighbors() const
  {
    return preparation_.isolated_neighbors;
  }

  /** \brief What the surfaces at two points add to the cost of the pair when they are
   *  at a right angle, metres: `normal_weight (1 - |n_p . n_q|)`, the normals by PCA of
   *  17 points; default 0.03. 0, the paper, ignores them. */
  void
  setNormalWeight(float normal_weight);

  float
  getNormalWeight() const
  {
    return preparation_.normals;
  }

  /** \brief Whether groups are made connected: a piece of a group that does not hang
   *  together with its seed goes to a group next to it. True by default; false is the
   *  paper. */
  void
  setConnectedGroups(bool connected_groups);

  bool
  getConnectedGroups() const
  {
    return preparation_.connected;
  }

  /** \brief What a difference in color adds to the cost of a pair: metres for a unit of
   *  CIE L*a*b* (black to white: 100), the colors being averaged over neighbors; 0, the
   *  default, ignores colors. Above 0 the verbs need colors: from a point type with
   *  `rgb` or `rgba`, or from setColors(). */
  void
  setColorWeight(float color_weight);

  float
  getColorWeight() const
  {
    return preparation_.color;
  }

  /** \brief Colors of the points of the input cloud, one for each; null, the default,
   *  means those of its point type. */
  void
  setColors(const ColorsConstPtr& colors);

  ColorsConstPtr
  getColors() const
  {
    return colors_;
  }

  /** \brief Whether the floor that a scanner hides from itself is a part of the
   *  surface: a disc under the sensor's origin of the input cloud (`sensor_origin_`,
   *  `sensor_orientation_`), where there is such a hole. Points of it belong to no
   *  group. Default true; of no effect with a search surface. */
  void
  setFillBlindSpot(bool fill_blind_spot);

  bool
  getFillBlindSpot() const
  {
    return preparation_.blind_spot;
  }

  /** \brief What answers nearest-neighbor queries away from the surface; null, the
   *  default, leaves it to pcl_cid and pcl::KdTreeFLANN (see DistanceField). It is
   *  given the surface about a local origin, as PointXYZ; it must be exact and safe for
   *  concurrent queries. */
  void
  setSearchMethod(const SearchPtr& search_method);

  SearchPtr
  getSearchMethod() const
  {
    return preparation_.search_method;
  }

  /** \brief Bytes that the grid of the surface may take (see DistanceField); 0, the
   *  default, means a quarter of the machine's memory. Never changes a result. */
  void
  setMemoryBudget(std::size_t memory_budget = 0);

  std::size_t
  getMemoryBudget() const
  {
    return preparation_.memory_budget;
  }

protected:
  CIDPreparationParameters() = default;
  CIDPreparationParameters(const CIDPreparationParameters&) = default;
  CIDPreparationParameters&
  operator=(const CIDPreparationParameters&) = default;
  virtual ~CIDPreparationParameters() = default;

  /** \brief The input or a setting of the preparation has changed: drop what was
   *  computed. */
  virtual void
  forgetScan() = 0;

  const PreparationSettings&
  preparation() const
  {
    return preparation_;
  }

  /** \brief Take over the settings of a scan that is prepared. */
  void
  adoptPreparation(const PreparationSettings& preparation)
  {
    preparation_ = preparation;
  }

private:
  PreparationSettings preparation_;
  ColorsConstPtr colors_;
};

} // namespace pcl_cid
