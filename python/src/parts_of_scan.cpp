/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scan: merge trees and parts for Python.
 */

#include "arrays.h"
#include "long_work.h"
#include "merge_tree.h"
#include "parts.h"
#include "scan_binding.h"
#include "scan_docs.h"

#include <pybind11/stl.h>

namespace pcl_cid::python {
namespace {

/** Whoever has seeds says with propose() how many. */
void
requirePatches(GroupRule groups, bool has_seeds)
{
  if (groups == GroupRule::cid && has_seeds)
    refuse(
        "seeds is the number of patches, and needs groups='patches'; propose() makes "
        "seeds");
}

MergeTree
mergeTree(const Scan& self,
          const py::object& group_samples,
          const py::object& progress,
          const py::object& groups,
          const py::object& seeds)
{
  const int number = valueFor(setting::group_samples, group_samples);
  const GroupRule rule = valueFor(setting::groups, groups);
  requirePatches(rule, !seeds.is_none());
  std::optional<int> patches;
  if (!seeds.is_none())
    patches = valueFor(setting::seeds, seeds);
  LongWork work(progress, self.settings().threads);
  return work.run([&](const ExecutionOptions& execution) {
    const std::shared_ptr<const Seeding> seeding = self.seeding();
    PartMaker maker = seeding->partMaker();
    maker.resetMergeCut();
    maker.setGroupSampleSize(number);
    mergeAndCut(self, *seeding, rule, patches, maker, execution);
    seeding->keep(maker);
    return maker.getMergeTree();
  });
}

/** What parts() is given besides its settings. */
struct GivenParts {
  py::object count;
  py::object error;
  py::object threshold;
  py::object merges;
  py::object merging;
  py::object viewpoints;
  py::kwargs settings;

  bool
  has(const char* setting) const
  {
    return settings.contains(setting) && !py::object(settings[setting]).is_none();
  }

  bool
  isAboutHulls() const
  {
    return !count.is_none() || !error.is_none() || !viewpoints.is_none() ||
           has(setting::robot_radius.name);
  }

  bool
  isAboutGroups() const
  {
    return !threshold.is_none() || !merges.is_none() || has(setting::groups.name) ||
           has(setting::seeds.name) || has(setting::group_samples.name);
  }
};

/** The settings; `max_vertices="auto"` is not one of the table. */
PartSettings
settingsOf(GivenParts& given, bool& fewest_vertices)
{
  const char* const vertices = setting::max_vertices.name;
  fewest_vertices = given.has(vertices) &&
                    py::isinstance<py::str>(given.settings[vertices]) &&
                    py::object(given.settings[vertices]).equal(py::str("auto"));
  if (fewest_vertices)
    given.settings[vertices] = py::none();
  PartSettings settings;
  Keywords reader("parts", given.settings);
  forEachPartSetting(settings, reader);
  reader.requireKnown();
  return settings;
}

MergingRule
ruleOf(const GivenParts& given)
{
  if (!given.merging.is_none())
    return valueFor(setting::merging, given.merging);
  return given.isAboutHulls() && !given.isAboutGroups() ? MergingRule::hull
                                                        : MergingRule::cid;
}

/** Each rule has settings of its own. */
void
requireFittingRule(const GivenParts& given, MergingRule rule)
{
  const bool by_hull = rule == MergingRule::hull;
  if (by_hull && given.isAboutGroups())
    refuse("threshold, merges, groups, seeds and group_samples are about groups; leave "
           "them out where parts are merged by hull");
  if (by_hull && given.count.is_none() && given.error.is_none())
    refuse("merging by hull needs a count or an error");
  if (!by_hull && (!given.error.is_none() || !given.viewpoints.is_none() ||
                   given.has(setting::robot_radius.name)))
    refuse("error, viewpoints and robot_radius need merging by hull, and neither "
           "threshold, merges, groups, seeds nor group_samples");
}

/** In the coordinates of the prepared cloud. */
std::vector<Eigen::Vector3d>
localViewpoints(const py::object& viewpoints, const Scan& scan)
{
  if (viewpoints.is_none())
    return {};
  return scan.frame().toLocal(positionsOf(viewpoints, "viewpoints"));
}

PartRequest
requestOf(GivenParts& given, const Scan& scan)
{
  PartRequest request;
  request.settings = settingsOf(given, request.fewest_vertices);
  request.rule = ruleOf(given);
  requireFittingRule(given, request.rule);
  requirePatches(request.settings.groups, request.settings.seeds.has_value());
  request.cut = mergeCutOf(given.count, given.threshold, given.merges);
  if (!given.error.is_none())
    request.max_error = valueFor(setting::max_error, given.error);
  request.viewpoints = localViewpoints(given.viewpoints, scan);
  return request;
}

std::vector<std::shared_ptr<ConvexPart>>
shared(std::vector<ConvexPart> parts)
{
  std::vector<std::shared_ptr<ConvexPart>> result;
  for (ConvexPart& part : parts)
    result.push_back(std::make_shared<ConvexPart>(std::move(part)));
  return result;
}

std::vector<std::shared_ptr<ConvexPart>>
parts(const Scan& self,
      const py::object& count,
      const py::object& error,
      const py::object& threshold,
      const py::object& merges,
      const py::object& merging,
      const py::object& viewpoints,
      const py::object& progress,
      const py::kwargs& settings)
{
  GivenParts given{count, error, threshold, merges, merging, viewpoints, settings};
  const PartRequest request = requestOf(given, self);
  LongWork work(progress, self.settings().threads);
  return shared(work.run([&](const ExecutionOptions& execution) {
    return makeParts(self, request, execution);
  }));
}

/** With the rows of all parameters that are not keywords of the table. */
std::string
partsDoc(const SettingDocs& settings)
{
  std::string text = settings.in(parts_doc);
  text = withRange(text, setting::parts);
  text = withRange(text, setting::max_error);
  text = withRange(text, setting::threshold);
  text = withRange(text, setting::seeds);
  return withRange(text, setting::merges);
}

std::string
mergeTreeDoc()
{
  std::string text = withRange(merge_tree_doc, setting::group_samples);
  text = withRange(text, setting::groups);
  return withRange(text, setting::seeds);
}

} // namespace

void
bindPartsOfScan(py::class_<Scan, std::shared_ptr<Scan>>& scan)
{
  SettingDocs settings;
  PartSettings initial;
  forEachPartSetting(initial, settings);
  scan.attr("_part_settings") = settings.defaults();
  scan.def("merge_tree",
           &mergeTree,
           py::arg("group_samples") = setting::group_samples.initial,
           py::arg("progress") = py::none(),
           py::kw_only(),
           py::arg("groups") = setting::groups.wordOf(setting::groups.initial),
           py::arg("seeds") = py::none(),
           mergeTreeDoc().c_str())
      .def("parts",
           &parts,
           py::arg("count") = py::none(),
           py::arg("error") = py::none(),
           py::arg("threshold") = py::none(),
           py::arg("merges") = py::none(),
           py::kw_only(),
           py::arg("merging") = py::none(),
           py::arg("viewpoints") = py::none(),
           py::arg("progress") = py::none(),
           partsDoc(settings).c_str());
}

} // namespace pcl_cid::python
