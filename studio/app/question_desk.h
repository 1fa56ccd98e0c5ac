/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pages ask about a session, without changing it.
 */

#pragma once

#include "label_export.h"
#include "places.h"
#include "server/frame.h"

#include <pcl_cid/core/label_doubt.h>
#include <pcl_cid/core/label_session.h>
#include <pcl_cid/io/cloud_points.h>

#include <memory>

namespace pcl_cid::studio {

/** \brief Answers what a page may `"ask"`. */
class QuestionDesk {
public:
  /** \param[in] session,places,points,exporter must outlive this */
  QuestionDesk(const LabelSession& session,
               const Places& places,
               const CloudPoints& points,
               LabelExporter& exporter);
  ~QuestionDesk();

  /** \brief The answer, without its id.
   *  \throws CIDException when it is no question, CIDCancelled */
  Frame
  answer(const Frame& question, const ExecutionOptions& execution);

private:
  Frame
  nextQuestion(const Frame& question) const;

  Frame
  doubtful(const Frame& question, const ExecutionOptions& execution);

  Frame
  preview(const Frame& question, const ExecutionOptions& execution) const;

  Frame
  cidFromPlace(const Frame& question, const ExecutionOptions& execution) const;

  Frame
  inspect(const Frame& question) const;

  Frame
  exportLabels(const Frame& question, const ExecutionOptions& execution) const;

  const std::vector<float>&
  margins(const ExecutionOptions& execution);

  const LabelSession& session_;
  const Places& places_;
  const CloudPoints& points_;
  LabelExporter& exporter_;
  std::unique_ptr<LabelDoubt> doubt_; ///< made when it is asked for
  std::vector<float> margins_;        ///< of the last time, to be read
};

} // namespace pcl_cid::studio
