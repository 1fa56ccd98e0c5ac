/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID itself: from a point to all, of pairs of points, of two groups.
 */

#include "cids.h"

#include "arrays.h"
#include "cloud.h"
#include "long_work.h"
#include "settings.h"

#include <pcl_cid/core/cid_from.h>
#include <pcl_cid/core/concavity.h>
#include <pcl_cid/io/cloud_points.h>

#include <algorithm>
#include <limits>

namespace pcl_cid::python {
namespace {

constexpr const char* point_cid_doc = R"(CID of two points, or of pairs of points.

Parameters
----------
surface : Scan or array_like of shape (N, 3)
    The surface S. A Scan has everything ready; an array is made ready in each call.
p, q : array_like of shape (3,) or (K, 3)
    Positions in the coordinates of the surface, metres, on it or off it; a single one
    is paired with each of the others.
samples : int, default {samples}
    M of Eq. 2: {samples range}.
tolerance : float, optional
    Metres: Eq. 1 itself, up to this much too small, instead of Eq. 2.
progress : bool or callable, optional
    See Scan.propose.

Returns
-------
float or ndarray of float32, shape (K,)
    The largest distance of the segment pq to the surface, metres.

Raises
------
ValueError
    For a bad shape or value, and for positions that are not finite.
CIDCancelled

Notes
-----
Eq. 2 (Eq. 1 with `tolerance`) of Wang et al., RA-L 2023.
)";

constexpr const char* group_cid_doc =
    R"(CID of two groups of points: the mean over all pairs.

Parameters
----------
surface : Scan or array_like of shape (N, 3)
    The surface S, see `point_cid`.
first, second : array_like of shape (n, 3) and (m, 3)
    Positions of the points of the groups, metres.
samples : int, default {samples}
    M of Eq. 2: {samples range}.
progress : bool or callable, optional
    See Scan.propose.

Returns
-------
float
    Metres.

Raises
------
ValueError
    For a bad shape or value, and for positions that are not finite.
CIDCancelled

Notes
-----
Eq. 3 of Wang et al., RA-L 2023. Each of the n * m pairs is compared.
)";

/** The surface S of a call: that of a scan, or made ready for the call. */
class Surface {
public:
  explicit Surface(const py::object& given)
  {
    if (py::isinstance<Scan>(given))
      scan_ = given.cast<std::shared_ptr<const Scan>>();
    else
      given_ = cloudOf(python::pointsOf(given, "points of the surface"), "surface");
  }

  unsigned int
  threads() const
  {
    return scan_ ? scan_->settings().threads : setting::threads.initial;
  }

  /** May run without the GIL, and must before what is below. */
  void
  prepare(const ExecutionOptions& execution)
  {
    if (scan_) {
      frame_ = scan_->frame();
      local_frame_ = scan_->prepared()->points().frame;
      return;
    }
    const CloudPoints cloud = blamingValues([&] {
      return pcl_cid::pointsOf(given_, {true, {}});
    });
    if (cloud.finite == 0)
      refuse("the surface has no finite point; at least 1 is needed");
    const PointSet points = finitePoints(*cloud.points);
    DistanceField::Options options;
    options.execution = execution;
    field_ = std::make_unique<DistanceField>(points.points, options);
    frame_ = cloud.frame;
    local_frame_ = points.frame;
  }

  const DistanceField&
  field() const
  {
    return scan_ ? scan_->prepared()->field() : *field_;
  }

  Points
  local(const std::vector<Eigen::Vector3d>& positions) const
  {
    Points points;
    for (const Eigen::Vector3d& each : positions)
      points.push_back(local_frame_.toLocal(frame_.toLocal(each)).cast<float>());
    return points;
  }

private:
  std::shared_ptr<const Scan> scan_; ///< null for an array
  LabelledCloud given_;
  Frame frame_; ///< from what was given to the cloud
  std::unique_ptr<DistanceField> field_;
  Frame local_frame_; ///< from the cloud to the field
};

int
samplesOf(const py::object& samples)
{
  return valueFor(setting::samples, samples);
}

/** A tolerance of Eq. 1; 0 where Eq. 2 is asked for. */
float
toleranceOf(const py::object& tolerance)
{
  if (tolerance.is_none())
    return 0.0f;
  const std::optional<double> value = realNumber(tolerance);
  if (!value || !(*value >= static_cast<double>(setting::above_zero)) ||
      *value > static_cast<double>(setting::any_length))
    refuse("the tolerance is ",
           shown(tolerance),
           "; it must be a number of metres above 0");
  return static_cast<float>(*value);
}

/** CID of each pair; lists of one are paired with all of the other. */
std::vector<float>
cidsOfPairs(const DistanceField& field,
            const Points& p,
            const Points& q,
            int samples,
            float tolerance,
            const ExecutionOptions& execution)
{
  constexpr std::size_t between_reports = 256;
  std::vector<float> cids;
  const std::size_t pairs = std::max(p.size(), q.size());
  for (std::size_t i = 0; i < pairs; ++i) {
    if (i % between_reports == 0 &&
        !execution.progress(static_cast<double>(i) / static_cast<double>(pairs)))
      throw CIDCancelled();
    const Eigen::Vector3f& from = p[p.size() == 1 ? 0 : i];
    const Eigen::Vector3f& to = q[q.size() == 1 ? 0 : i];
    cids.push_back(tolerance > 0.0f ? continuousPointCID(field, from, to, tolerance)
                                    : pointCID(field, from, to, samples));
  }
  return cids;
}

/** Whether it is one position, not a list of them. */
bool
isSingle(const py::object& position)
{
  return py::module_::import("numpy").attr("ndim")(position).cast<int>() == 1;
}

py::object
pointCid(const py::object& given,
         const py::object& p,
         const py::object& q,
         const py::object& samples,
         const py::object& tolerance,
         const py::object& progress)
{
  Surface surface(given);
  const std::vector<Eigen::Vector3d> from = positionsOf(p, "positions p");
  const std::vector<Eigen::Vector3d> to = positionsOf(q, "positions q");
  if (from.size() != to.size() && from.size() != 1 && to.size() != 1)
    refuse("p has ",
           from.size(),
           " positions and q ",
           to.size(),
           "; they must have as many, or one of them a single one");
  const int number = samplesOf(samples);
  const float most_below = toleranceOf(tolerance);
  LongWork work(progress, surface.threads());
  std::vector<float> cids = work.run([&](const ExecutionOptions& execution) {
    surface.prepare(execution);
    return cidsOfPairs(surface.field(),
                       surface.local(from),
                       surface.local(to),
                       number,
                       most_below,
                       execution);
  });
  if (isSingle(p) && isSingle(q))
    return py::float_(static_cast<double>(cids.front()));
  return arrayOf(std::move(cids));
}

double
groupCid(const py::object& given,
         const py::object& first,
         const py::object& second,
         const py::object& samples,
         const py::object& progress)
{
  Surface surface(given);
  const std::vector<Eigen::Vector3d> a =
      positionsOf(first, "positions of the first group");
  const std::vector<Eigen::Vector3d> b =
      positionsOf(second, "positions of the second group");
  const int number = samplesOf(samples);
  LongWork work(progress, surface.threads());
  return blamingValues([&] {
    return work.run([&](const ExecutionOptions& execution) {
      surface.prepare(execution);
      return groupCID(
          surface.field(), surface.local(a), surface.local(b), number, execution);
    });
  });
}

} // namespace

Eigen::Vector3f
localPoint(const Scan& scan, pcl::index_t index)
{
  const PointSet& points = scan.prepared()->points();
  const auto found =
      std::lower_bound(points.source.begin(), points.source.end(), index);
  if (found == points.source.end() || *found != index)
    refuse("point ", index, " is not finite; choose one that is");
  return points.points[static_cast<std::size_t>(found - points.source.begin())];
}

std::vector<float>
cidsFrom(const Scan& scan,
         const Eigen::Vector3f& from,
         const ExecutionOptions& execution)
{
  const PointSet& points = scan.prepared()->points();
  const std::vector<float> cids = cidFrom(scan.prepared()->field(),
                                          from,
                                          points.points,
                                          scan.settings().grouping.samples,
                                          execution);
  std::vector<float> values(scan.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < cids.size(); ++i)
    values[static_cast<std::size_t>(points.source[i])] = cids[i];
  return values;
}

void
bindCids(py::module_& module)
{
  module.def("point_cid",
             &pointCid,
             py::arg("surface"),
             py::arg("p"),
             py::arg("q"),
             py::arg("samples") = setting::samples.initial,
             py::arg("tolerance") = py::none(),
             py::arg("progress") = py::none(),
             withRange(point_cid_doc, setting::samples).c_str());
  module.def("group_cid",
             &groupCid,
             py::arg("surface"),
             py::arg("first"),
             py::arg("second"),
             py::arg("samples") = setting::samples.initial,
             py::arg("progress") = py::none(),
             withRange(group_cid_doc, setting::samples).c_str());
}

} // namespace pcl_cid::python
