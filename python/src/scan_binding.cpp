/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scan: a prepared scan and its seeds for Python.
 */

#include "scan_binding.h"

#include "arrays.h"
#include "cids.h"
#include "cloud.h"
#include "gil.h"
#include "long_work.h"
#include "scan_docs.h"

#include <cmath>

namespace pcl_cid::python {
namespace {

ScanSettings
settingsOf(const py::object& paper, const py::kwargs& keywords)
{
  ScanSettings settings;
  if (!PyBool_Check(paper.ptr()))
    refuse("paper is ", shown(paper), "; it must be True or False");
  if (paper.cast<bool>())
    settings.setPaperSettings();
  Keywords reader("Scan", keywords);
  forEachSettingOf(settings, reader);
  reader.requireKnown();
  return settings;
}

/** The cloud that is given, as points or as it was read. */
Cloud
cloudFor(const py::object& points, const py::object& sensor)
{
  const bool is_cloud = py::isinstance<Cloud>(points);
  if (is_cloud && sensor.is_none())
    return points.cast<Cloud>();
  LabelledCloud cloud = is_cloud
                            ? points.cast<const Cloud&>().cloud()
                            : cloudOf(python::pointsOf(points, "points"), "points");
  setSensor(sensor, cloud);
  return Cloud(std::move(cloud));
}

/** Its points about their own origin. */
CloudPoints
localPoints(const Cloud& cloud, bool keep_zeros)
{
  Remarks remarks;
  const CloudPoints result = blamingValues([&] {
    const GilReleased released;
    return pcl_cid::pointsOf(cloud.cloud(), {keep_zeros, remarks.callback()});
  });
  remarks.warn();
  if (result.finite == 0)
    refuse(
        "none of the ", result.points->size(), " points is finite; at least 1 must be");
  return result;
}

/** Needed where they weigh something; a Cloud may have its own. */
std::vector<ColorRGB>
colorsFor(const py::object& colors,
          const py::object& points,
          std::size_t size,
          float weight)
{
  if (!colors.is_none())
    return colorsOf(colors, size);
  if (weight == 0.0f)
    return {};
  if (py::isinstance<Cloud>(points))
    return pcl_cid::colorsOf(points.cast<const Cloud&>().cloud());
  refuse("the color weight is ",
         asWritten(weight),
         ", but there are no colors; give some, or set it to 0");
}

std::shared_ptr<Scan>
makeScan(const py::object& points,
         const py::object& colors,
         const py::object& sensor,
         const py::object& paper,
         const py::object& keep_zeros,
         const py::object& progress,
         const py::kwargs& keywords)
{
  const ScanSettings settings = settingsOf(paper, keywords);
  if (!PyBool_Check(keep_zeros.ptr()))
    refuse("keep_zeros is ", shown(keep_zeros), "; it must be True or False");
  LongWork work(progress, settings.threads);
  const CloudPoints cloud =
      localPoints(cloudFor(points, sensor), keep_zeros.cast<bool>());
  const std::vector<ColorRGB> bytes =
      colorsFor(colors, points, cloud.points->size(), settings.preparation.color);
  return blamingValues([&] {
    return work.run([&](const ExecutionOptions& execution) {
      return std::make_shared<Scan>(cloud, bytes, settings, execution);
    });
  });
}

py::str
propose(Scan& self,
        const py::object& seeds,
        const py::object& coverage,
        const py::object& progress)
{
  const float within =
      coverage.is_none() ? 0.0f : valueFor(setting::coverage, coverage);
  const std::size_t wanted =
      !seeds.is_none()     ? static_cast<std::size_t>(valueFor(setting::seeds, seeds))
      : coverage.is_none() ? static_cast<std::size_t>(setting::seeds.initial)
                           : self.size();
  LongWork work(progress, self.settings().threads);
  const ProposalStop stop = work.run([&](const ExecutionOptions& execution) {
    return self.propose(wanted, within, execution);
  });
  return stop == ProposalStop::seeds      ? "seeds"
         : stop == ProposalStop::coverage ? "coverage"
                                          : "no_gain";
}

void
addSeeds(Scan& self,
         const py::object& seeds,
         const py::object& labels,
         const py::object& progress)
{
  const pcl::Indices indices = indicesOf(seeds, "seeds", self.size());
  std::optional<std::vector<std::uint32_t>> given;
  if (!labels.is_none())
    given = labelsOf(labels, "labels", indices.size(), "seeds");
  LongWork work(progress, self.settings().threads);
  blamingValues([&] {
    work.run([&](const ExecutionOptions& execution) {
      self.addSeeds(indices, given, execution);
    });
  });
}

void
removeSeeds(Scan& self, const py::object& seeds, const py::object& progress)
{
  const pcl::Indices indices = indicesOf(seeds, "seeds", self.size());
  LongWork work(progress, self.settings().threads);
  blamingValues([&] {
    work.run([&](const ExecutionOptions& execution) {
      self.removeSeeds(indices, execution);
    });
  });
}

void
labelSeeds(Scan& self, const py::object& seeds, const py::object& labels)
{
  const pcl::Indices indices = indicesOf(seeds, "seeds", self.size());
  const std::vector<std::uint32_t> given =
      labelsOf(labels, "labels", indices.size(), "seeds");
  LongWork work(py::none(), self.settings().threads);
  blamingValues([&] {
    work.run([&](const ExecutionOptions& execution) {
      self.labelSeeds(indices, given, execution);
    });
  });
}

py::array
labels(const Scan& self, const py::object& clean_up, const py::object& progress)
{
  const bool mends = valueFor(setting::clean_up, clean_up);
  LongWork work(progress, self.settings().threads);
  return arrayOf(work.run([&](const ExecutionOptions& execution) {
    return self.seeding()->labels(mends, execution);
  }));
}

py::array
groups(const Scan& self)
{
  LongWork work(py::none(), self.settings().threads);
  return viewOf(work.run([&](const ExecutionOptions& execution) {
    return self.seeding()->groups(execution);
  }));
}

py::array
cids(const Scan& self, const py::object& progress)
{
  LongWork work(progress, self.settings().threads);
  return arrayOf(work.run([&](const ExecutionOptions& execution) {
    return self.seeding()->grouping()->cids(execution);
  }));
}

py::array
cidFrom(const Scan& self, const py::object& index, const py::object& progress)
{
  const pcl::Indices indices = indicesOf(index, "points", self.size());
  if (indices.size() != 1)
    refuse("the point is ", shown(index), "; it must be the index of one point");
  const Eigen::Vector3f from = localPoint(self, indices.front());
  LongWork work(progress, self.settings().threads);
  return arrayOf(work.run([&](const ExecutionOptions& execution) {
    return cidsFrom(self, from, execution);
  }));
}

py::dict
settingsAsDict(const Scan& self)
{
  py::dict values;
  forEachSettingOf(self.settings(), [&](const auto& row, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::optional<pcl::index_t>>)
      values[row.name] = value ? py::cast(*value) : py::none();
    else
      values[row.name] = asPython(row, value);
  });
  return values;
}

std::string
nameOf(const Scan& self)
{
  return "<pcl_cid.Scan of " + std::to_string(self.size()) + " points, " +
         std::to_string(self.seeding()->labelsOfSeeds().size()) + " seeds>";
}

} // namespace

void
bindScan(py::module_& module)
{
  SettingDocs settings;
  ScanSettings initial;
  forEachSettingOf(initial, settings);
  py::class_<Scan, std::shared_ptr<Scan>> scan(module, "Scan", scan_doc);
  scan.def(py::init(&makeScan),
           py::arg("points"),
           py::arg("colors") = py::none(),
           py::arg("sensor") = py::none(),
           py::kw_only(),
           py::arg("paper") = false,
           py::arg("keep_zeros") = false,
           py::arg("progress") = py::none(),
           settings.in(init_doc).c_str());
  scan.attr("_settings") = settings.defaults();
  scan.def("__len__", &Scan::size)
      .def("__repr__", &nameOf)
      .def("propose",
           &propose,
           py::arg("seeds") = py::none(),
           py::arg("coverage") = py::none(),
           py::arg("progress") = py::none(),
           withRange(withRange(propose_doc, setting::seeds), setting::coverage).c_str())
      .def("add_seeds",
           &addSeeds,
           py::arg("seeds"),
           py::arg("labels") = py::none(),
           py::arg("progress") = py::none(),
           add_seeds_doc)
      .def("remove_seeds",
           &removeSeeds,
           py::arg("seeds"),
           py::arg("progress") = py::none(),
           remove_seeds_doc)
      .def("label_seeds",
           &labelSeeds,
           py::arg("seeds"),
           py::arg("labels"),
           label_seeds_doc)
      .def("labels",
           &labels,
           py::arg("clean_up") = asPython(setting::clean_up, setting::clean_up.initial),
           py::arg("progress") = py::none(),
           labels_doc)
      .def("cids", &cids, py::arg("progress") = py::none(), cids_doc)
      .def("cid_from",
           &cidFrom,
           py::arg("index"),
           py::arg("progress") = py::none(),
           cid_from_doc)
      .def_property_readonly("groups", &groups, groups_doc)
      .def_property_readonly(
          "seeds",
          [](const Scan& self) { return arrayOf(self.seeding()->grouping()->seeds()); },
          "ndarray of int32, shape (K,): the points that are seeds, by number.")
      .def_property_readonly(
          "seed_labels",
          [](const Scan& self) { return arrayOf(self.seeding()->labelsOfSeeds()); },
          "ndarray of uint32, shape (K,): the label of each seed.")
      .def_property_readonly(
          "coverage",
          [](const Scan& self) { return self.seeding()->grouping()->coverage(); },
          "float: the largest CID of a point that is not isolated to its seed, metres; "
          "NaN without seeds.")
      .def_property_readonly("settings",
                             &settingsAsDict,
                             "dict: the settings that the scan was made with.");
  bindPartsOfScan(scan);
}

} // namespace pcl_cid::python
