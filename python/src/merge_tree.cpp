/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Merge trees: Algorithm 2 for Python.
 */

#include "merge_tree.h"

#include "arrays.h"

namespace pcl_cid::python {
namespace {

constexpr const char* cut_doc = R"(The part of each group, where the tree is cut.

Parameters
----------
count : int, optional
    When so many parts remain.
threshold : float, optional
    When the smallest CID of two parts (Eq. 3) exceeds so many metres.
merges : int, optional
    After so many merges, the stop of Algorithm 2.

Returns
-------
ndarray of int32, shape (K,)
    Numbers of parts from 0, in the order of their lowest group. With none of the
    three, the cut is where the heights of the merges begin to climb.

Raises
------
ValueError
    For a value out of its range, and for more than one of them.
)";

const MergeTree&
treeOf(const py::object& self)
{
  return self.cast<const MergeTree&>();
}

/** A column of the steps, which lives as long as the tree. */
template <typename Value>
py::array
columnOf(const py::object& self, Value MergeStep::*column, py::ssize_t width)
{
  const std::vector<MergeStep>& steps = treeOf(self).steps();
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(steps.size()), width};
  std::vector<py::ssize_t> strides{sizeof(MergeStep), sizeof(Value)};
  if (width == 1) {
    shape.pop_back();
    strides.pop_back();
  }
  const Value* const first = steps.empty() ? nullptr : &(steps.front().*column);
  return readOnly(py::array_t<Value>(shape, strides, first, self));
}

} // namespace

MergeCut
mergeCutOf(const py::object& count,
           const py::object& threshold,
           const py::object& merges)
{
  if (int{count.is_none()} + int{threshold.is_none()} + int{merges.is_none()} < 2)
    refuse("count is ",
           shown(count),
           ", threshold ",
           shown(threshold),
           " and merges ",
           shown(merges),
           "; only one of them may be given");
  MergeCut cut;
  if (!count.is_none())
    cut = {MergeCut::Rule::parts,
           static_cast<std::size_t>(valueFor(setting::parts, count)),
           0.0};
  if (!threshold.is_none())
    cut = {MergeCut::Rule::threshold, 0, valueFor(setting::threshold, threshold)};
  if (!merges.is_none())
    cut = {MergeCut::Rule::merges,
           static_cast<std::size_t>(valueFor(setting::merges, merges)),
           0.0};
  return cut;
}

void
bindMergeTree(py::module_& module)
{
  static_assert(offsetof(MergeStep, second) == offsetof(MergeStep, first) + sizeof(int),
                "first and second are two columns of one array");
  py::class_<MergeTree, std::shared_ptr<MergeTree>> tree(
      module,
      "MergeTree",
      "All merges of Algorithm 2, lowest group CID (Eq. 3) first; see "
      "Scan.merge_tree.");
  forbidNew(tree);
  tree.def(
          "cut",
          [](const MergeTree& self,
             const py::object& count,
             const py::object& threshold,
             const py::object& merges) {
            return arrayOf(self.cut(mergeCutOf(count, threshold, merges)));
          },
          py::arg("count") = py::none(),
          py::arg("threshold") = py::none(),
          py::arg("merges") = py::none(),
          cut_doc)
      .def("__len__", &MergeTree::numberOfGroups)
      .def("__repr__",
           [](const MergeTree& self) {
             return "<pcl_cid.MergeTree of " + std::to_string(self.numberOfGroups()) +
                    " groups>";
           })
      .def_property_readonly(
          "sizes",
          [](const MergeTree& self) { return arrayOf(self.groupSizes()); },
          "ndarray of uint64, shape (K,): points in each group.")
      .def_property_readonly(
          "merges",
          [](const py::object& self) { return columnOf(self, &MergeStep::first, 2); },
          "ndarray of int32, shape (K - 1, 2): the two that each merge joins, lower "
          "number first; the result goes by that.")
      .def_property_readonly(
          "heights",
          [](const py::object& self) { return columnOf(self, &MergeStep::height, 1); },
          "ndarray of float64, shape (K - 1,): CID_g of the two, metres.");
}

} // namespace pcl_cid::python
