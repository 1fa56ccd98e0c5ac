/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pages ask about a session, without changing it.
 */

#include "question_desk.h"
#include "header_fields.h"
#include "wire_state.h"

#include <pcl_cid/core/cid_from.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <utility>

namespace pcl_cid::studio {
namespace {

using Json = nlohmann::json;

Frame
withPlaces(Json header, const pcl::Indices& points, const Places& places)
{
  return {std::move(header), {{"places", places.placesOf(points)}}};
}

} // namespace

QuestionDesk::QuestionDesk(const LabelSession& session,
                           const Places& places,
                           const CloudPoints& points,
                           LabelExporter& exporter)
: session_(session), places_(places), points_(points), exporter_(exporter)
{
}

QuestionDesk::~QuestionDesk() = default;

Frame
QuestionDesk::answer(const Frame& question, const ExecutionOptions& execution)
{
  const std::string word = textIn(question.header, "ask");
  if (word == "state")
    return {summaryOf(session_, places_), allLabels(session_, places_)};
  if (word == "question")
    return nextQuestion(question);
  if (word == "doubtful")
    return doubtful(question, execution);
  if (word == "doubt")
    return {Json::object(), {{"doubt", margins(execution)}}};
  if (word == "preview")
    return preview(question, execution);
  if (word == "cid")
    return cidFromPlace(question, execution);
  if (word == "inspect")
    return inspect(question);
  if (word == "export")
    return exportLabels(question, execution);
  throw CIDException("nothing is called '" + word + "' that can be asked");
}

Frame
QuestionDesk::nextQuestion(const Frame& question) const
{
  std::optional<pcl::index_t> after;
  if (const auto key = optionalNumberIn(question.header, "after"))
    after = places_.requirePoint(*key);
  const std::optional<Question> next = session_.nextQuestion(after);
  if (!next) {
    const std::optional<Question> first = session_.nextQuestion();
    return {{{"question", nullptr}, {"left", first ? first->left : 0}}, {}};
  }
  const std::uint32_t place = places_.placeOf(next->seed);
  return withPlaces(
      {{"question", {{"seed", place}, {"place", place}, {"size", next->size}}},
       {"left", next->left}},
      groupOf(session_, next->seed),
      places_);
}

/** Of the first places. */
const std::vector<float>&
QuestionDesk::margins(const ExecutionOptions& execution)
{
  if (!doubt_) {
    pcl::Indices points;
    const std::size_t enough = std::min(LabelDoubt::enough_points, places_.size());
    for (std::size_t place = 0; place < enough; ++place)
      points.push_back(places_.point(place));
    doubt_ = std::make_unique<LabelDoubt>(session_.grouping().sharedScan(),
                                          session_.grouping().settings().samples,
                                          points,
                                          ExecutionOptions{execution.threads, {}});
  }
  return margins_ = doubt_->margins(session_, execution);
}

Frame
QuestionDesk::doubtful(const Frame& question, const ExecutionOptions& execution)
{
  const auto below = question.header.find("below");
  if (below == question.header.end() || !below->is_number() ||
      !(below->get<float>() > 0.0f))
    throw CIDException("'below' must be a number of metres above 0");
  margins(execution);
  const auto area = doubt_->area(margins_,
                                 below->get<float>(),
                                 optionalNumberIn(question.header, "skip").value_or(0));
  if (!area)
    return {{{"place", nullptr}, {"size", 0}}, {}};
  return withPlaces(
      {{"place", places_.placeOf(area->point)}, {"size", area->points.size()}},
      area->points,
      places_);
}

Frame
QuestionDesk::preview(const Frame& question, const ExecutionOptions& execution) const
{
  const pcl::index_t point = places_.requirePoint(numberIn(question.header, "place"));
  return withPlaces(Json::object(), session_.preview(point, execution), places_);
}

/** Fig. 1 of the paper. */
Frame
QuestionDesk::cidFromPlace(const Frame& question,
                           const ExecutionOptions& execution) const
{
  const std::uint32_t place = numberIn(question.header, "place");
  places_.requirePoint(place);
  const PreparedScan& scan = session_.scan();
  const Points& points = scan.points().points;
  const std::vector<float> of_members = cidFrom(scan.field(),
                                                points[places_.member(place)],
                                                points,
                                                session_.grouping().settings().samples,
                                                execution);
  std::vector<float> cids(places_.size());
  for (std::size_t k = 0; k < cids.size(); ++k)
    cids[k] = of_members[places_.member(k)];
  return {Json::object(), {{"cid", std::move(cids)}}};
}

Frame
QuestionDesk::inspect(const Frame& question) const
{
  const pcl::index_t point = places_.requirePoint(numberIn(question.header, "place"));
  const auto index = static_cast<std::size_t>(point);
  const pcl::PointXYZ& local = (*points_.points)[index];
  const Eigen::Vector3d position =
      points_.frame.toFile(local.getVector3fMap().cast<double>());
  const pcl::index_t group = session_.groups()[index];
  Json seed;
  if (group >= 0)
    seed =
        places_.placeOf(session_.grouping().seeds()[static_cast<std::size_t>(group)]);
  return {{{"index", point},
           {"position", {position.x(), position.y(), position.z()}},
           {"label", session_.labels()[index]},
           {"seed", seed},
           {"painted", session_.isPainted(point)}},
          {}};
}

Frame
QuestionDesk::exportLabels(const Frame& question,
                           const ExecutionOptions& execution) const
{
  const auto clean = question.header.find("clean_up");
  const bool clean_up =
      clean != question.header.end() && clean->is_boolean() && clean->get<bool>();
  const ExportedFiles exported = exporter_.write(session_,
                                                 textIn(question.header, "format"),
                                                 textIn(question.header, "file", ""),
                                                 clean_up,
                                                 execution);
  return {{{"files", exported.files}, {"remarks", exported.remarks}}, {}};
}

} // namespace pcl_cid::studio
