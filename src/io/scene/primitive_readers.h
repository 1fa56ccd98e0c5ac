/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The primitives of scenes, read back to check them.
 */

#pragma once

#include <pcl_cid/io/scene_formats.h>

namespace pcl_cid {

/** \brief The collision primitives of what writeURDF() has written; the same for the
 *  others.
 *  \throws CIDException when the text is another */
NamedPrimitives
readPrimitivesOfURDF(std::istream& stream);

NamedPrimitives
readPrimitivesOfSDF(std::istream& stream);

NamedPrimitives
readPrimitivesOfMJCF(std::istream& stream);

NamedPrimitives
readPrimitivesOfMoveIt(std::istream& stream);

} // namespace pcl_cid
