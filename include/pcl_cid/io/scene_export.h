/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts as a scene for robot software: URDF, SDF, MJCF, MoveIt.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <iosfwd>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief File format of the meshes that URDF, SDF and MJCF refer to, one a part. */
enum class PartFormat { obj, stl };

/** \brief What the writers of scenes are told beside the parts. */
struct SceneDescription {
  /** Of the robot (URDF), the model (SDF, MJCF), the scene (MoveIt). */
  std::string name = "convex_parts";
  /** The frame of the cloud: name of the one link in URDF and SDF. MJCF has the world
   *  body in its place, MoveIt the frame that it plans in. */
  std::string frame = "map";
  /** What is subtracted from the meshes, and is the pose of each of them in the frame;
   *  see sceneOrigin(). */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** Folder with the meshes, as seen from the scene's file; empty when it is the same.
   *  MoveIt needs none. */
  std::string mesh_folder;
  PartFormat mesh_format = PartFormat::obj;
};

/** \brief A local origin for meshes in float, the one place of the rule: zero when no
 *  coordinate of a hull is beyond 1000 m, where float has steps of 0.06 mm; else the
 *  centre of all hulls, rounded to whole metres. */
PCL_CID_IO_EXPORT Eigen::Vector3d
sceneOrigin(const std::vector<ConvexPart>& parts);

/** \brief "part_000.obj", "part_001.obj", ... */
PCL_CID_IO_EXPORT std::string
partFileName(std::size_t part, PartFormat format);

/** \brief Whether a file has a name that partFileName() gives, in either format.
 *  \param[in] name without folder */
PCL_CID_IO_EXPORT bool
isPartFileName(const std::string& name);

/** \brief The mesh file of one part, the scene's origin subtracted. */
PCL_CID_IO_EXPORT void
writePartMesh(std::ostream& stream,
              const std::vector<ConvexPart>& parts,
              std::size_t part,
              const SceneDescription& scene);

/** \brief A URDF: one link, for each part a `<visual>` with its colour and a
 *  `<collision>`. Streams as in mesh_export.h; the same for all writers here.
 *  \throws CIDException when a name cannot be written in XML (control characters) or is
 *  empty */
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
 *  colour and a `<collision>` with a plain mesh.
 *  \throws CIDException as writeURDF() and requireFrameForSDF() */
PCL_CID_IO_EXPORT void
writeSDF(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const SceneDescription& scene);

/** \brief An MJCF: for each part a mesh asset and a geom of its colour in the world
 *  body, which nothing moves.
 *  \throws CIDException as writeURDF() */
PCL_CID_IO_EXPORT void
writeMJCF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene);

/** \brief A scene in MoveIt's text form (`.scene`): for each part a collision object
 *  with a mesh and its colour.
 *  \throws CIDException when the scene's name is empty or holds control characters */
PCL_CID_IO_EXPORT void
writeMoveItScene(std::ostream& stream,
                 const std::vector<ConvexPart>& parts,
                 const SceneDescription& scene);

} // namespace pcl_cid
