/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scenes of parts in every format that the library writes, for other people's parsers.
 */

#pragma once

#include "cloud_files.h"
#include "part_scenes.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {

/** \brief The files of a scene, in a folder whose name has a space, an ampersand and a
 *  letter that is not ASCII; so has the folder of the parts in it. */
class ExportedScene {
public:
  ExportedScene(const PartScene& scene, const std::string& format);

  /** \brief For messages. */
  std::string
  name() const;

  const PartScene&
  content() const
  {
    return content_;
  }

  const std::vector<ConvexPart>&
  parts() const
  {
    return content_.parts;
  }

  const SceneDescription&
  description() const
  {
    return description_;
  }

  /** \brief scene.urdf, scene.sdf, scene.xml, scene.scene, scene.glb, scene.usda, and
   * hulls.obj, hulls.ply and hulls.stl with all parts in one. */
  std::string
  file(const std::string& name) const
  {
    return inFolder(name);
  }

  /** \brief Path of a file that a scene refers to. */
  std::string
  referred(const std::string& reference) const
  {
    return inFolder(reference);
  }

  /** \brief The name of a part in scenes. */
  std::string
  partName(std::size_t part) const
  {
    return pcl_cid::partName(part, description_.name);
  }

  /** \brief Path of the mesh of a part. */
  std::string
  mesh(std::size_t part) const
  {
    return inFolder(description_.mesh_folder + "/" + partFileName(part, description_));
  }

private:
  std::string
  inFolder(const std::string& name) const
  {
    return folder_.file("R\xC3\xA4ume & Co/" + name);
  }

  void
  writeMeshes() const;

  void
  writeScenes() const;

  TemporaryFolder folder_;
  PartScene content_;
  SceneDescription description_;
};

/** \brief All part scenes; computed once. */
const std::vector<PartScene>&
scenesToExport();

/** \brief Call \a check with each of them, in each format of the parts' meshes, the
 * name in the messages. */
template <typename Check>
void
forEachExportedScene(const Check& check)
{
  for (const PartScene& scene : scenesToExport())
    for (const std::string format : {".obj", ".stl"}) {
      const ExportedScene exported(scene, format);
      SCOPED_TRACE(exported.name());
      check(exported);
    }
}

/** \brief Box around the vertices of a hull. */
Eigen::AlignedBox3d
boxOf(const TriangleMesh& hull);

/** \brief Middle of a hull, strictly inside. */
Eigen::Vector3d
middleOf(const TriangleMesh& hull);

} // namespace pcl_cid::test
