/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * evaluate(): scores of instance labels.
 */

#include "evaluation.h"

#include "arrays.h"
#include "gil.h"
#include "settings.h"

#include <pcl_cid/core/evaluation.h>
#include <pcl_cid/io/class_names.h>

#include <pybind11/stl.h>

namespace pcl_cid::python {
namespace {

constexpr const char* evaluate_doc = R"(Score instance labels against the truth.

Parameters
----------
prediction, truth : array_like of int, shape (N,), or a list of them
    The label of each point, 0 for none; a list has an array for each scan.
protocol : {protocol range}, default {protocol}
    By whose rules: those of the paper (section V; a prediction belongs to the truth
    instance whose label it carries), of ScanNet's benchmark, or of ASIS on S3DIS.
prediction_classes, truth_classes : as the labels, optional
    The class of each point. Without those of the truth all instances are of one
    class; without those of the prediction it has the truth's.
classes : sequence of int, optional
    Numbers of the classes that count. Default: the 18 of ScanNet's benchmark
    (nyu40id), or the 13 of S3DIS for other protocols.

Returns
-------
dict
    `mean` and, for each class, `classes`: the figures of the protocol, as ap50;
    `truth_instances`, `groups`, `labelled_points`, `purity`, `compactness`,
    `mean_iou`. NaN where there is nothing to score.

Raises
------
ValueError
    When lengths differ, and in the protocol of the paper when a predicted label is not
    one of the truth.
)";

/** Several scans come as a list or tuple of arrays. */
std::vector<py::object>
scansOf(const py::object& given)
{
  const bool is_sequence =
      py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given);
  if (is_sequence && py::len(given) > 0) {
    const py::object first = given[py::int_(0)];
    if (py::isinstance<py::array>(first) || py::isinstance<py::sequence>(first))
      return given.cast<std::vector<py::object>>();
  }
  return {given};
}

/** Classes of each scan, none where they are not given. */
std::vector<py::object>
classesOf(const py::object& given, const char* name, std::size_t scans)
{
  if (given.is_none())
    return std::vector<py::object>(scans, py::none());
  std::vector<py::object> classes = scansOf(given);
  if (classes.size() != scans)
    refuse("the ", name, " are of ", classes.size(), " scans, the labels of ", scans);
  return classes;
}

InstanceOverlaps
overlapsOfScan(PointLabels predicted,
               const py::object& predicted_classes,
               PointLabels actual,
               const py::object& true_classes,
               EvaluationProtocol protocol)
{
  const std::size_t size = actual.label.size();
  if (predicted.label.size() != size)
    refuse("the prediction has ",
           predicted.label.size(),
           " points and the truth ",
           size,
           "; they must be the same points");
  if (true_classes.is_none())
    actual.semantic.assign(size, 1);
  else
    actual.semantic = labelsOf(true_classes, "classes of the truth", size, "points");
  const bool has_both = !true_classes.is_none() && !predicted_classes.is_none();
  if (has_both && protocol != EvaluationProtocol::paper)
    predicted.semantic =
        labelsOf(predicted_classes, "classes of the prediction", size, "points");
  const GilReleased released;
  return overlapsOf(predicted, actual);
}

std::vector<std::uint32_t>
scoredClasses(const py::object& classes, bool has_classes, EvaluationProtocol protocol)
{
  if (!classes.is_none())
    return labelsOf(classes, "classes");
  if (!has_classes)
    return {1};
  std::vector<std::uint32_t> numbers;
  for (const SemanticClass& each : protocol == EvaluationProtocol::scannet
                                       ? scannetBenchmarkClasses()
                                       : s3disClasses())
    numbers.push_back(each.number);
  return numbers;
}

void
addFigures(const EvaluationFigures& figures,
           EvaluationProtocol protocol,
           py::dict& dict)
{
  for (const NamedFigure& figure : figuresOf(protocol))
    dict[figure.name] = figures.*figure.value;
}

/** With the names that reports of pcl_cid_evaluate have. */
py::dict
asDict(const Evaluation& evaluation, EvaluationProtocol protocol)
{
  py::list classes;
  for (const ClassEvaluation& each : evaluation.classes) {
    py::dict entry;
    entry["number"] = each.semantic;
    entry["truth_instances"] = each.truths;
    entry["predictions"] = each.predictions;
    addFigures(each.figures, protocol, entry);
    classes.append(entry);
  }
  py::dict mean;
  mean["classes"] = evaluation.classes_in_mean;
  addFigures(evaluation.mean, protocol, mean);
  py::dict dict;
  dict["protocol"] = protocol_setting.wordOf(protocol);
  dict["labelled_points"] = evaluation.truth_points;
  dict["truth_instances"] = evaluation.truths;
  dict["groups"] = evaluation.groups;
  dict["purity"] = evaluation.purity;
  dict["compactness"] = evaluation.compactness;
  dict["mean_iou"] = evaluation.mean_iou;
  dict["mean"] = mean;
  dict["classes"] = classes;
  return dict;
}

py::dict
evaluateLabels(const py::object& prediction,
               const py::object& truth,
               const py::object& protocol_word,
               const py::object& prediction_classes,
               const py::object& truth_classes,
               const py::object& classes)
{
  const EvaluationProtocol protocol = valueFor(protocol_setting, protocol_word);
  const std::vector<py::object> predictions = scansOf(prediction);
  const std::vector<py::object> truths = scansOf(truth);
  if (predictions.size() != truths.size())
    refuse("the prediction is of ",
           predictions.size(),
           " scans and the truth of ",
           truths.size(),
           "; they must be the same scans");
  const auto predicted =
      classesOf(prediction_classes, "prediction_classes", truths.size());
  const auto actual = classesOf(truth_classes, "truth_classes", truths.size());
  std::vector<InstanceOverlaps> overlaps;
  for (std::size_t i = 0; i < truths.size(); ++i)
    overlaps.push_back(
        overlapsOfScan({labelsOf(predictions[i], "predicted labels"), {}},
                       predicted[i],
                       {labelsOf(truths[i], "true labels"), {}},
                       actual[i],
                       protocol));
  const std::vector<std::uint32_t> scored =
      scoredClasses(classes, !truth_classes.is_none(), protocol);
  const Evaluation evaluation = blamingValues([&] {
    const GilReleased released;
    return evaluate(overlaps, protocol, scored);
  });
  return asDict(evaluation, protocol);
}

} // namespace

void
bindEvaluation(py::module_& module)
{
  module.def("evaluate",
             &evaluateLabels,
             py::arg("prediction"),
             py::arg("truth"),
             py::arg("protocol") = asPython(protocol_setting, protocol_setting.initial),
             py::arg("prediction_classes") = py::none(),
             py::arg("truth_classes") = py::none(),
             py::arg("classes") = py::none(),
             withRange(evaluate_doc, protocol_setting).c_str());
}

} // namespace pcl_cid::python
