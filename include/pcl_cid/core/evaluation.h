/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scores of instance labels by the protocols of the paper, ScanNet and S3DIS.
 */

#pragma once

#include <pcl_cid/core/instance_overlaps.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief The rules by which predictions are scored. */
enum class EvaluationProtocol {
  /** Section V: a prediction belongs to the truth instance whose label it carries, and
   *  hits it or nothing. */
  paper,
  /** ScanNet's benchmark: instances of 100 points or more, void passed over. */
  scannet,
  /** S3DIS as ASIS scores it: coverage, precision and recall. */
  s3dis
};

/** \brief The row of the protocol. */
inline constexpr ChoiceSetting<EvaluationProtocol, 3> protocol_setting{
    "Scores",
    "protocol",
    "NAME",
    EvaluationProtocol::paper,
    {{{"paper", EvaluationProtocol::paper},
      {"scannet", EvaluationProtocol::scannet},
      {"s3dis", EvaluationProtocol::s3dis}}},
    "whose rules: those of the paper (a prediction belongs to the truth instance whose "
    "label it carries), of ScanNet's benchmark, or of ASIS on S3DIS"};

/** \brief The figures of a class; NaN where the protocol has none or there is no truth
 *  instance that counts. */
struct EvaluationFigures {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  /** Mean AP over the thresholds 0.50, 0.55 ... 0.90 (scannet). */
  double ap = none;
  /** AP, precision and recall of the matches with IoU above 0.25, 0.50 and 0.75. */
  double ap25 = none;
  double precision25 = none;
  double recall25 = none;
  double ap50 = none;
  double precision50 = none;
  double recall50 = none;
  double ap75 = none;
  double precision75 = none;
  double recall75 = none;
  /** Best IoU of a truth instance: mean over the scans of its mean, and of its mean
   *  weighted by the points of the instances (s3dis: mCov, mWCov). */
  double coverage = none;
  double weighted_coverage = none;
  /** Predictions with an IoU of 0.5 or more, over predictions and over truth instances;
   *  several may hit the same instance (s3dis). */
  double precision = none;
  double recall = none;
};

/** \brief A figure, its name in files and its headline in a table for people. */
struct NamedFigure {
  const char* name;
  const char* headline;
  double EvaluationFigures::*value;
};

/** \brief The figures that a protocol has, in the order in which they are shown. */
PCL_CID_EXPORT std::vector<NamedFigure>
figuresOf(EvaluationProtocol protocol);

/** \brief Scores of one class. */
struct ClassEvaluation {
  std::uint32_t semantic = 0;
  /** Instances that the protocol counts. */
  std::size_t truths = 0;
  std::size_t predictions = 0;
  EvaluationFigures figures;
};

/** \brief Scores of one or more scans. */
struct Evaluation {
  std::vector<ClassEvaluation> classes;
  /** Each the mean over the classes that have a truth instance, and their number. */
  EvaluationFigures mean;
  std::size_t classes_in_mean = 0;

  /** Of whatever class: truth instances and their points, predicted instances. */
  std::size_t truths = 0;
  std::size_t truth_points = 0;
  std::size_t groups = 0;
  /** Share of the points of truth instances that lie in the truth instance which has
   *  most of the points of their group; NaN without truth. */
  double purity = EvaluationFigures::none;
  /** Truth instances over groups; NaN without groups. */
  double compactness = EvaluationFigures::none;
  /** Mean over the truth instances of the best IoU with any prediction of any class;
   *  NaN without truth. */
  double mean_iou = EvaluationFigures::none;
};

/** \brief Score scans, pooled.
 *
 *  \code
 *    std::vector<InstanceOverlaps> scans;
 *    scans.push_back(overlapsOf(prediction, truth)); // for each scan
 *    const Evaluation evaluation =
 *        evaluate(scans, EvaluationProtocol::paper, {1, 2, 3});
 *  \endcode
 *  \param[in] classes numbers of those that count
 *  \throws CIDException when a class is 0 or there twice; in the protocol of the paper,
 *  when a predicted label is not one of the truth */
PCL_CID_EXPORT Evaluation
evaluate(const std::vector<InstanceOverlaps>& scans,
         EvaluationProtocol protocol,
         const std::vector<std::uint32_t>& classes);

} // namespace pcl_cid
