/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Build tool, not installed: one room, in the layout of S3DIS and in that of ScanNet.
 */

#include "dataset_folders.h"

#include <exception>
#include <iostream>

int
main(int argc, char** argv)
{
  constexpr std::size_t points = 2000;
  constexpr std::uint32_t bare_instance = 2;
  if (argc != 2) {
    std::cerr << "usage: make_dataset_folders OUTPUT_FOLDER\n";
    return 2;
  }
  try {
    const pcl_cid::test::LabelledScan room = pcl_cid::test::smallRoomScan(points);
    pcl_cid::test::writeS3DISRoom(argv[1], room);
    pcl_cid::test::writeScannetScan(argv[1], room, bare_instance);
  }
  catch (const std::exception& error) {
    std::cerr << "make_dataset_folders: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
