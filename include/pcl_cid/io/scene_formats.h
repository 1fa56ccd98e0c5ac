/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scenes for robot software that parts can be written as, in one table.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

struct SceneDescription;

/** \brief The primitives of a scene by the names of their parts. */
using NamedPrimitives = std::map<std::string, HullPrimitive>;

/** \brief A mesh, and its origin in the frame of the scene. */
struct PlacedMesh {
  TriangleMesh mesh;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

/** \brief The meshes of a scene by the names of their parts. */
using NamedMeshes = std::map<std::string, PlacedMesh>;

/** \brief A format of scenes: a row of the table. */
struct SceneFormat {
  /** What users call it: "URDF". */
  std::string name;
  /** The option of pcl_cid_abstract that writes it, without dashes: "urdf". */
  std::string option;
  /** How names of its files end: in small letters, with the dot, the usual one first.
   *  Other formats may have the same. */
  std::vector<std::string> extensions;
  /** What the option does, for `--help`. */
  std::string help;
  /** Whether it refers to a mesh file for each part, in SceneDescription::mesh_folder;
   *  else it holds the meshes itself, or needs none. */
  bool refers_to_meshes = false;
  /** Whether SceneDescription::frame stands in it. */
  bool names_frame = false;
  /** Refuse, before long work, what it cannot hold; empty when there is nothing to
   *  refuse.
   *  \throws CIDException */
  std::function<void(const SceneDescription& scene)> check;
  /** Write parts.
   *  \throws CIDException for names that it cannot hold */
  std::function<void(std::ostream& stream,
                     const std::vector<ConvexPart>& parts,
                     const SceneDescription& scene)>
      write;
  /** Primitives that it knows, of SceneDescription::primitives; empty: meshes only. */
  std::vector<HullPrimitive::Kind> primitives;
  /** Read the primitives of what it has written; needed where it knows any.
   *  \throws CIDException when it cannot */
  std::function<NamedPrimitives(std::istream& stream)> read_primitives;
  /** Whether the meshes that it holds itself are rounded to float. */
  bool is_float = false;
  /** Read the meshes that it holds itself from what it has written, to verify them;
   *  empty where there are none, or nothing reads them.
   *  \throws CIDException when it cannot */
  std::function<NamedMeshes(std::istream& stream)> read_meshes;
};

/** \brief All formats: URDF, SDF, MJCF, MoveIt, glTF, USD, then those that were
 * registered. */
PCL_CID_IO_EXPORT std::vector<SceneFormat>
sceneFormats();

/** \brief The format of this name; null when there is none. The row stays where it is
 *  as long as the program runs. */
PCL_CID_IO_EXPORT const SceneFormat*
findSceneFormat(const std::string& name);

/** \brief Add a format for as long as the program runs. Any thread may call this.
 *  \throws CIDException when its name or its option is taken, an extension is no good,
 *  or when it has no writer, no option, or primitives without a reader of them */
PCL_CID_IO_EXPORT void
registerSceneFormat(SceneFormat format);

} // namespace pcl_cid
