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
#include "run/command_line.h"
#include "run/common_settings.h"
#include "run/run.h"

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scan_source.h>

#include <iostream>
#include <limits>
#include <ostream>
#include <string>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

constexpr const char* tool = "cid_perturb";

constexpr NumberSetting<double> noise_setting{"Options",
                                              "noise",
                                              "noise",
                                              "SIGMA",
                                              "metres",
                                              0.0,
                                              0.0,
                                              std::numeric_limits<double>::max(),
                                              "standard deviation on each coordinate"};

constexpr NumberSetting<double> keep_setting{"Options",
                                             "keep",
                                             "fraction to keep",
                                             "FRACTION",
                                             "",
                                             1.0,
                                             std::numeric_limits<double>::min(),
                                             1.0,
                                             "probability of each point to be kept"};

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
  line.setting(noise_setting, settings.perturbation.noise);
  line.setting(keep_setting, settings.perturbation.keep);
  line.setting(setting::random_seed, settings.perturbation.seed);
  declareClassTable(settings.class_table, line);
  line.helpOptions();
  return line.parse(argc,
                    argv,
                    {scanArgument("INPUT"), outputArgument("OUTPUT", {".pcd"})},
                    {&settings.input, &settings.output});
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
