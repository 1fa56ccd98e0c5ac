/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Not installed: adds noise to a scan and thins it, for the experiments. Remarks on the
 * scan go to the standard error.
 */

#include "perturbation.h"
#include "tool_run.h"

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scan_source.h>

#include <cfloat>
#include <iostream>
#include <ostream>
#include <string>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

constexpr const char* tool = "cid_perturb";

struct PerturbSettings {
  std::string input;
  std::string output;
  std::string class_table; ///< of ScanNet; empty: looked for
  test::Perturbation perturbation;
};

bool
readCommandLine(int argc, const char* const* argv, PerturbSettings& settings)
{
  CommandLine line(
      tool,
      "cid_perturb INPUT OUTPUT.pcd [options]",
      "Add noise to the coordinates of a scan and keep a random part of its points.\n"
      "INPUT is whatever pcl_cid_segment takes; OUTPUT has its fields. For one seed, "
      "what\n"
      "a smaller fraction keeps a greater one keeps, too, moved in the same way.");
  line.group("Options");
  line.number("noise",
              "SIGMA",
              {0.0, DBL_MAX, "a number of metres, 0 or more"},
              settings.perturbation.noise,
              "standard deviation on each coordinate, metres");
  line.number("keep",
              "FRACTION",
              {DBL_MIN, 1.0, "a number above 0, at most 1"},
              settings.perturbation.keep,
              "probability of each point to be kept");
  line.number("random-seed",
              "S",
              {0, UINT64_MAX, "a whole number, 0 to 18446744073709551615"},
              settings.perturbation.seed,
              "of every random draw");
  declareClassTable(settings.class_table, line);
  line.helpOptions();
  if (!line.parse(argc, argv, {&settings.input, &settings.output}))
    return false;
  requireExtension("OUTPUT", settings.output, {".pcd"});
  return true;
}

void
perturb(const PerturbSettings& settings)
{
  OutputFiles outputs(scanFiles(settings.input, settings.class_table));
  outputs.announce(settings.output);
  ScanOptions options;
  options.remark = [](const std::string& sentence) { std::cerr << sentence << '\n'; };
  options.class_table = settings.class_table;
  LabelledCloud cloud = readScan(settings.input, options);
  cloud.fields = test::perturbed(cloud.fields, settings.perturbation);
  outputs.write(settings.output, [&](std::ostream& stream) {
    writeCloud(stream, cloud, layoutFor(settings.output, cloud.layout));
  });
  outputs.commit();
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(tool, [&] {
    PerturbSettings settings;
    if (readCommandLine(argc, argv, settings))
      perturb(settings);
  });
}
