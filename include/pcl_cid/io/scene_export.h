/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts as a scene for robot software: URDF, SDF, MJCF, MoveIt, glTF, USD.
 * scene_formats.h has them in a table.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief What the writers of scenes need to know besides the parts. */
struct SceneDescription {
  /** Name of the robot (URDF), the model (SDF, MJCF), the scene (MoveIt) or the prim or
   * node of all (USD, glTF); it also stands before the names of all parts, in the scene
   * and of their mesh files (see partName()), so that scenes of different names can be
   * loaded together. It must pass requirePartsName(); only mesh files can do without
   * it. */
  std::string name = "convex_parts";
  /** The frame of the cloud: name of the one link in URDF and SDF; empty: the name of
   *  the scene. MJCF has the world body in its place, MoveIt the frame that it plans
   *  in, glTF and USD the origin. */
  std::string frame;
  /** The origin of the meshes, in the frame of the parts: subtracted from their
   *  coordinates, and written as the pose of each of them; see sceneOrigin(). */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** Folder with the meshes, as seen from the scene's file; empty when it is the same.
   *  In URDF and SDF it may be a URI: `package://my_robot/meshes`. MoveIt, glTF and USD
   * need none.
   */
  std::string mesh_folder;
  /** Extension of the meshes, with the dot, which says their format; one of
   *  partMeshExtensions(). */
  std::string mesh_extension = ".obj";
  /** What is written in the place of the mesh of each part, in the frame of the parts
   *  (see fitPrimitives()); none, or of a kind that the format does not know: its mesh.
   *  Empty: meshes for all. */
  std::vector<std::optional<HullPrimitive>> primitives;
};

/** \brief A local origin for meshes in float; this is the only place of the rule.
 *
 *  Zero when no coordinate of a hull is beyond 1000 m, where float has steps of 0.06
 *  mm; else the center of all hulls, rounded to whole meters.
 *  \return in the frame of the parts */
PCL_CID_IO_EXPORT Eigen::Vector3d
sceneOrigin(const std::vector<ConvexPart>& parts);

/** \brief The mesh of one part, with the scene's origin subtracted, in double. */
PCL_CID_IO_EXPORT TriangleMesh
meshInScene(const ConvexPart& part, const SceneDescription& scene);

/** \brief "kitchen_part_000.obj", "kitchen_part_001.obj", ... in a scene of the name
 *  "kitchen"; "part_000.obj" where the name is empty.
 *  \param[in] part its number, from 0
 *  \throws CIDException when SceneDescription::mesh_extension is none of
 *  partMeshExtensions() */
PCL_CID_IO_EXPORT std::string
partFileName(std::size_t part, const SceneDescription& scene);

/** \brief Whether a file has a name that partFileName() gives for some part and some
 *  extension.
 *  \param[in] file its name without folder
 *  \param[in] name of the scene */
PCL_CID_IO_EXPORT bool
isPartFileName(const std::string& file, const std::string& name);

/** \brief The link of a scene in URDF and SDF: SceneDescription::frame, or, where that
 *  is empty, the name of the scene. */
PCL_CID_IO_EXPORT const std::string&
linkName(const SceneDescription& scene);

/** \brief Refuse a folder of meshes that no URDF and no SDF can name: with control
 *  characters, or a URI that does not begin with `package://`, `model://`, `file:///`,
 *  `http://` or `https://`, or names nothing after that.
 *  \throws CIDException */
PCL_CID_IO_EXPORT void
requireMeshFolder(const std::string& folder);

/** \brief Refuse a folder of meshes that MJCF cannot name: with control characters, or
 *  a URI, as MuJoCo reads files by their paths only.
 *  \throws CIDException */
PCL_CID_IO_EXPORT void
requireMeshFolderForMJCF(const std::string& folder);

/** \brief What stands in the place of the mesh of a part; null: nothing does. */
PCL_CID_IO_EXPORT const HullPrimitive*
primitiveOf(std::size_t part, const SceneDescription& scene);

/** \brief The mesh file of one part: meshInScene() in the format of the scene's
 *  SceneDescription::mesh_extension.
 *  \param[in] part its number; less than there are parts
 *  \throws CIDException when scenes refer to no meshes with this extension */
PCL_CID_IO_EXPORT void
writePartMesh(std::ostream& stream,
              const std::vector<ConvexPart>& parts,
              std::size_t part,
              const SceneDescription& scene);

/** \brief A URDF: one link, for each part a `<visual>` with its color and a
 *  `<collision>`.
 *
 *  Look at the state of the stream afterwards to see whether it worked, or write
 *  through OutputFiles; the same for all writers here.
 *  \throws CIDException for a name that is not good (see requirePartsName()), and for
 *  a frame or a folder that cannot be written in XML (control characters) */
PCL_CID_IO_EXPORT void
writeURDF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene);

/** \brief Refuse a frame that SDF has no link of.
 *  \throws CIDException when it is empty, holds "::" or control characters, or is
 *  reserved: `world` and `__NAME__` */
PCL_CID_IO_EXPORT void
requireFrameForSDF(const std::string& frame);

/** \brief An SDF 1.9: a static model of one link, for each part a `<visual>` with its
 *  color and a `<collision>` with a plain mesh.
 *  \throws CIDException as writeURDF() and requireFrameForSDF() */
PCL_CID_IO_EXPORT void
writeSDF(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const SceneDescription& scene);

/** \brief An MJCF: for each part a mesh asset and a geom of its color in the world
 *  body, which nothing moves.
 *
 *  MuJoCo 2 resolves the paths of meshes from the model that it opens. So where another
 *  model in another folder includes this one, SceneDescription::mesh_folder must be
 *  absolute, or as seen from that model and its `meshdir`. MuJoCo 3 also looks from
 *  this one.
 *  \throws CIDException as writeURDF() and requireMeshFolderForMJCF() */
PCL_CID_IO_EXPORT void
writeMJCF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene);

/** \brief A binary glTF 2.0 (`.glb`): a node for each part, with its mesh and its
 *  material, in one that turns z up to y up, as glTF has it. Coordinates are float,
 *  relative to the scene's origin, which is the place of each node, in double. Open the
 *  stream in binary mode.
 *  \throws CIDException for a name that is not good (see requirePartsName()), and for
 *  meshes of more than 4 GB */
PCL_CID_IO_EXPORT void
writeGLTF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene);

/** \brief A USD in text (`.usda`): a mesh for each part in its color, z up, in metres;
 *  static colliders of UsdPhysics, of the approximation `convexHull`. Coordinates are
 *  float, relative to the scene's origin, to which each mesh is translated in double.
 *  \throws CIDException for a name that is not good (see requirePartsName()) */
PCL_CID_IO_EXPORT void
writeUSD(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const SceneDescription& scene);

/** \brief A scene in MoveIt's text form (`.scene`): for each part a collision object
 *  with a mesh and its color.
 *  \throws CIDException for a name that is not good (see requirePartsName()) */
PCL_CID_IO_EXPORT void
writeMoveItScene(std::ostream& stream,
                 const std::vector<ConvexPart>& parts,
                 const SceneDescription& scene);

} // namespace pcl_cid
