/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --verify: the primitives in a scene, checked on what is in its file.
 */

#pragma once

#include "hull_verification.h"
#include "scene_outputs.h"

namespace pcl_cid::tools {

/** \brief Read a scene again, before it is committed, and check that each primitive
 *  holds every point of its part, padded, and keeps the bound on the error. None of the
 *  code that fits primitives is used, but for the mesh that the bound is asked of.
 *  \param[in] scene which parts must be primitives
 *  \throws CIDException with file, part and what is wrong */
void
verifyPrimitives(const SceneFile& file,
                 const SceneDescription& scene,
                 const Verification& verification,
                 OutputFiles& outputs);

} // namespace pcl_cid::tools
