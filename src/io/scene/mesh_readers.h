/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The meshes that scenes hold themselves, read back to check them.
 */

#pragma once

#include <pcl_cid/io/scene_formats.h>

namespace pcl_cid {

/** \brief The meshes of what writeGLTF() has written; the same for the others.
 *  \throws CIDException when the bytes are others */
NamedMeshes
readMeshesOfGLTF(std::istream& stream);

NamedMeshes
readMeshesOfUSD(std::istream& stream);

NamedMeshes
readMeshesOfMoveIt(std::istream& stream);

} // namespace pcl_cid
