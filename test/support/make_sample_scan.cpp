/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Build tool, not installed: makes the sample scan in data/ again, byte for byte.
 */

#include <exception>
#include <iostream>

#include "sample_scan.h"

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: make_sample_scan OUTPUT_FOLDER\n";
    return 2;
  }
  try {
    pcl_cid::test::writeSampleScan(argv[1]);
  }
  catch (const std::exception& error) {
    std::cerr << "make_sample_scan: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
