/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings that do not depend on the point type.
 */

#pragma once

#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/lab_color.h>
#include <pcl_cid/core/local_spacing.h>
#include <pcl_cid/core/seed_proposal.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief The settings for raw scans (*ours*): what a pair of points costs, which
 *  points become seeds, and what belongs to the surface unseen. */
struct PCL_CID_EXPORT RawScanSettings {
  DensityWeight density_weight = DensityWeight::automatic;
  float density_power = 1.0f;
  int isolated_neighbors = 4;
  SeedingRule seeding_rule = SeedingRule::farthest;
  float color_weight = 0.0f;
  bool fill_blind_spot = true;

  bool
  operator==(const RawScanSettings& other) const;
};

/** \brief The colour of each point of a cloud. */
using ColorsConstPtr = std::shared_ptr<const std::vector<ColorRGB>>;

/** \brief The settings that all classes of pcl_cid share. Every setter refuses a bad
 *  value at once with a CIDException and then changes nothing. */
class PCL_CID_EXPORT CIDParameters {
public:
  using Search = DistanceField::Search;

  /** \brief K, the number of seeds: at least 1; default 100, as in the paper. Fewer
   *  come back when the cloud has fewer distinct points. */
  void
  setNumberOfSeeds(int number_of_seeds);

  int
  getNumberOfSeeds() const
  {
    return number_of_seeds_;
  }

  /** \brief Stop adding seeds as soon as every point is within this CID of its seed
   *  (*ours*): metres, 0 or more; default 0. Whichever of the two stops comes first
   *  counts, so ask for as many seeds as the guarantee may cost. */
  void
  setCoverage(float coverage);

  float
  getCoverage() const
  {
    return coverage_;
  }

  /** \brief M, the samples on a segment (Eq. 2): 2 to 1,048,576; default 100, as in the
   *  paper. */
  void
  setNumberOfSamples(int number_of_samples);

  int
  getNumberOfSamples() const
  {
    return number_of_samples_;
  }

  /** \brief Work on a random draw of this many points (the paper: 20,000), and let
   *  every other point follow its Euclidean-nearest one; 0, the default, works on all
   *  of them. */
  void
  setSubsample(int subsample);

  int
  getSubsample() const
  {
    return subsample_;
  }

  /** \brief Seed of every draw (start, subsample, samples of groups); default 0. */
  void
  setRandomSeed(std::uint64_t random_seed)
  {
    random_seed_ = random_seed;
  }

  std::uint64_t
  getRandomSeed() const
  {
    return random_seed_;
  }

  /** \brief Begin the traversal at this point of the input cloud instead of a random
   *  one: 0 or more; the verb then requires it to be a finite, selected point. */
  void
  setStartIndex(pcl::index_t start_index);

  /** \brief Begin at a random point again (the default). */
  void
  resetStartIndex()
  {
    start_index_.reset();
  }

  std::optional<pcl::index_t>
  getStartIndex() const
  {
    return start_index_;
  }

  /** \brief The points of the input cloud that may become seeds; null, the default,
   *  means all that are grouped. Those that are not grouped are passed over. */
  void
  setSeedCandidates(const pcl::IndicesConstPtr& seed_candidates)
  {
    seed_candidates_ = seed_candidates;
  }

  pcl::IndicesConstPtr
  getSeedCandidates() const
  {
    return seed_candidates_;
  }

  /** \brief Whether CIDs are weighted by `2 / (s(p) + s(q))`, s being the local spacing
   *  of the points (see localSpacing()): where a scan is sparse, a point is far from
   * the surface without any concavity. The default, automatic, is on where the spacing
   * is uneven (see spacingSpread() and `uneven_spread`): for a single depth view, a
   * lidar scan, but not for points drawn evenly. */
  void
  setDensityWeight(DensityWeight density_weight)
  {
    raw_scan_.density_weight = density_weight;
  }

  DensityWeight
  getDensityWeight() const
  {
    return raw_scan_.density_weight;
  }

  /** \brief The power of the spacing in that weight: 0 (as if off) to 4; default 1. */
  void
  setDensityPower(float density_power);

  float
  getDensityPower() const
  {
    return raw_scan_.density_power;
  }

  /** \brief A point with fewer others near it is isolated (see isolatedPoints()): it
   *  never becomes a seed, unless it is the start or a seed that was given, and does
   * not count in the coverage, but belongs to a group like all others. 0 (no point is
   *  isolated) to NearestNeighbors::most; default 4. */
  void
  setIsolatedNeighbors(int isolated_neighbors);

  int
  getIsolatedNeighbors() const
  {
    return raw_scan_.isolated_neighbors;
  }

  /** \brief How the next seed is chosen; default SeedingRule::farthest, the paper. */
  void
  setSeedingRule(SeedingRule seeding_rule)
  {
    raw_scan_.seeding_rule = seeding_rule;
  }

  SeedingRule
  getSeedingRule() const
  {
    return raw_scan_.seeding_rule;
  }

  /** \brief What a difference in colour adds to the cost of a pair: metres for a unit
   * of CIE L*a*b* (black to white: 100), the colours being smooth (see smoothLab()); 0
   * or more; default 0, for no look at colours. Above 0 the verbs need colours: from a
   *  point type with `rgb` or `rgba`, or from setColors(). */
  void
  setColorWeight(float color_weight);

  float
  getColorWeight() const
  {
    return raw_scan_.color_weight;
  }

  /** \brief Colours of the points of the input cloud, one for each; null, the default,
   *  means those of its point type. */
  void
  setColors(const ColorsConstPtr& colors)
  {
    colors_ = colors;
  }

  ColorsConstPtr
  getColors() const
  {
    return colors_;
  }

  /** \brief Whether the floor that a scanner hides from itself is a part of the surface
   *  (see findBlindSpot()): a disc under the sensor's origin of the input cloud
   *  (`sensor_origin_`, `sensor_orientation_`), where there is such a hole. Points of
   * it belong to no group. Default true; of no effect with a search surface. */
  void
  setFillBlindSpot(bool fill_blind_spot)
  {
    raw_scan_.fill_blind_spot = fill_blind_spot;
  }

  bool
  getFillBlindSpot() const
  {
    return raw_scan_.fill_blind_spot;
  }

  const RawScanSettings&
  getRawScanSettings() const
  {
    return raw_scan_;
  }

  /** \brief Who answers nearest-neighbour queries away from the surface; null, the
   *  default, leaves it to pcl_cid and pcl::KdTreeFLANN (see DistanceField). It is
   *  given the surface about a local origin, as PointXYZ; it must be exact and safe for
   *  concurrent queries. */
  void
  setSearchMethod(const Search::Ptr& search_method)
  {
    search_method_ = search_method;
  }

  Search::Ptr
  getSearchMethod() const
  {
    return search_method_;
  }

  /** \brief Bytes that the grid of the surface may take (see DistanceField); 0, the
   *  default, means a quarter of the machine's memory. Never changes a result. */
  void
  setMemoryBudget(std::size_t memory_budget = 0)
  {
    memory_budget_ = memory_budget;
  }

  std::size_t
  getMemoryBudget() const
  {
    return memory_budget_;
  }

  /** \brief Number of threads, at most 1024; 0, the default, means all. */
  void
  setNumberOfThreads(unsigned int number_of_threads = 0);

  unsigned int
  getNumberOfThreads() const
  {
    return number_of_threads_;
  }

  /** \brief Called during every verb (see ProgressCallback); empty, the default, means
   *  nobody is told. A verb that was cancelled throws CIDCancelled. */
  void
  setProgressCallback(const ProgressCallback& progress)
  {
    progress_ = progress;
  }

  ProgressCallback
  getProgressCallback() const
  {
    return progress_;
  }

protected:
  /** \brief Threads, and the callback told fractions from \a begin to \a end: the share
   *  of a verb that one of its steps makes up. */
  ExecutionOptions
  execution(double begin, double end) const;

private:
  int number_of_seeds_ = 100;
  float coverage_ = 0.0f;
  int number_of_samples_ = 100;
  int subsample_ = 0;
  std::uint64_t random_seed_ = 0;
  std::optional<pcl::index_t> start_index_;
  pcl::IndicesConstPtr seed_candidates_;
  RawScanSettings raw_scan_;
  ColorsConstPtr colors_;
  Search::Ptr search_method_;
  std::size_t memory_budget_ = 0;
  unsigned int number_of_threads_ = 0;
  ProgressCallback progress_;
};

} // namespace pcl_cid
