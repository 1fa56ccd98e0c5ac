/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pages do to the parts of a scan, and ask about them.
 */

#include "part_desk.h"
#include "header_fields.h"
#include "wire_state.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <utility>

namespace pcl_cid::studio {
namespace {

using Json = nlohmann::json;

constexpr const char* ask_parts = "parts";
constexpr const char* ask_hulls = "hulls";
constexpr const char* ask_tightness = "tightness";
constexpr const char* ask_export = "export parts";

/** Add a hull to those of a frame.
 *  \param[in] origin of the places */
void
append(const ConvexPart& part,
       const pcl_cid::Frame& origin,
       std::vector<float>& vertices,
       std::vector<std::uint32_t>& triangles)
{
  for (const Eigen::Vector3d& vertex : part.hull.vertices)
    for (const double coordinate : origin.toLocal(vertex))
      vertices.push_back(static_cast<float>(coordinate));
  for (const auto& triangle : part.hull.triangles)
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
}

std::vector<std::string>
textsIn(const Json& header, const char* name)
{
  std::vector<std::string> texts;
  for (const Json& text : listIn(header, name)) {
    if (!text.is_string())
      throw CIDException("'" + std::string(name) + "' must be a list of texts");
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

} // namespace

PartDesk::PartDesk(RecordedSession& session,
                   const Places& places,
                   const tools::LoadedScan& scan,
                   const tools::AbstractSettings& settings,
                   const PartExporter& exporter)
: session_(session), places_(places), exporter_(exporter), hulls_(scan, settings)
{
}

bool
PartDesk::answers(const Json& header)
{
  const auto word = header.find("ask");
  return word != header.end() && (*word == ask_parts || *word == ask_hulls ||
                                  *word == ask_tightness || *word == ask_export);
}

Frame
PartDesk::answer(const Frame& question, const ExecutionOptions& execution)
{
  const PartSession& session = session_.parts(execution);
  const std::string word = textIn(question.header, "ask");
  if (word == ask_parts)
    return {{{"parts", summary(execution)}}, partGroups(session, places_)};
  if (word == ask_hulls)
    return hulls(question, session);
  if (word == ask_tightness)
    return tightness(question, session);
  return exportParts(question, session);
}

Json
PartDesk::summary(const ExecutionOptions& execution)
{
  const PartSession& session = session_.parts(execution);
  if (decomposition_ != session.decomposition())
    ++decomposition_number_;
  decomposition_ = session.decomposition();
  return partsOf(session, decomposition_number_);
}

/** The parts that a page names, in its order. */
std::vector<ChosenPart>
PartDesk::partsIn(const Json& header, const PartSession& session) const
{
  const std::vector<ChosenPart> all = session.parts();
  std::vector<ChosenPart> named;
  for (const Json& number : listIn(header, "parts")) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& part) {
      return number == part.number();
    });
    if (found == all.end())
      throw CIDException("there is no part " + number.dump());
    named.push_back(*found);
  }
  return named;
}

Frame
PartDesk::hulls(const Frame& question, const PartSession& session)
{
  Json list = Json::array();
  std::vector<float> vertices;
  std::vector<std::uint32_t> triangles;
  for (const ChosenPart& part : partsIn(question.header, session)) {
    const ConvexPart& made = hulls_.hullOf(part, session);
    list.push_back({{"part", part.number()},
                    {"vertices", made.hull.vertices.size()},
                    {"triangles", made.hull.triangles.size()},
                    {"volume", made.volume},
                    {"thickness", made.thickness},
                    {"thickened", made.thickened},
                    {"boxed", made.boxed}});
    append(made, session.scan().points().frame, vertices, triangles);
  }
  return {{{"hulls", std::move(list)}},
          {{"vertices", std::move(vertices)}, {"triangles", std::move(triangles)}}};
}

Frame
PartDesk::tightness(const Frame& question, const PartSession& session)
{
  Json list = Json::array();
  for (const ChosenPart& part : partsIn(question.header, session)) {
    const HullTightness& figures = hulls_.tightnessOf(part, session);
    list.push_back({{"part", part.number()},
                    {"max_concavity", figures.max_concavity},
                    {"mean_concavity", figures.mean_concavity},
                    {"free_share", figures.free_share}});
  }
  return {{{"tightness", std::move(list)}}, {}};
}

Frame
PartDesk::exportParts(const Frame& question, const PartSession& session) const
{
  const Json& header = question.header;
  const ExportedFiles exported = exporter_.write(session,
                                                 {textIn(header, "file", ""),
                                                  textIn(header, "mesh"),
                                                  textsIn(header, "scenes"),
                                                  textIn(header, "labels", ""),
                                                  truthIn(header, "primitives"),
                                                  truthIn(header, "report")});
  return {{{"files", exported.files}, {"remarks", exported.remarks}}, {}};
}

} // namespace pcl_cid::studio
