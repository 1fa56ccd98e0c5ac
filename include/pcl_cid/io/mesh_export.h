/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts as mesh files: OBJ, PLY, STL.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <iosfwd>
#include <string>
#include <vector>

#include <pcl/PolygonMesh.h>

namespace pcl_cid {

/** \brief Colour of a part: that of its number in pcl::GlasbeyLUT, whose 256 colours
 *  are as different as can be; they repeat after that. */
struct PartColour {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
};

PCL_CID_IO_EXPORT PartColour
partColour(std::size_t part);

/** \brief "part_000", "part_001", ... */
PCL_CID_IO_EXPORT std::string
partName(std::size_t part);

/** \brief A Wavefront OBJ: an object `o part_NNN` for each hull, coordinates with all
 *  the digits of double. A test of the stream's state afterwards says whether it
 *  worked; the same for all writers here.
 *  \param[in] material_library name of the file that writeMTL() writes, as seen from
 *  the OBJ */
PCL_CID_IO_EXPORT void
writeOBJ(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const std::string& material_library);

/** \brief A Wavefront OBJ of one mesh: an object of this name, without colour. */
PCL_CID_IO_EXPORT void
writeOBJMesh(std::ostream& stream, const TriangleMesh& mesh, const std::string& name);

/** \brief The material library of an OBJ: a material `part_NNN` for each part. */
PCL_CID_IO_EXPORT void
writeMTL(std::ostream& stream, const std::vector<ConvexPart>& parts);

/** \brief A binary PLY: one mesh, coordinates as double, for each face its colour and
 *  the number of its part (`red`, `green`, `blue`, `part`). */
PCL_CID_IO_EXPORT void
writePLY(std::ostream& stream, const std::vector<ConvexPart>& parts);

/** \brief A binary STL: one mesh. The format holds float only: at UTM coordinates hulls
 *  lose their shape (steps of 0.25 m at 4,000,000 m), which OBJ and PLY keep. */
PCL_CID_IO_EXPORT void
writeSTL(std::ostream& stream, const std::vector<ConvexPart>& parts);

/** \brief A binary STL of one mesh. */
PCL_CID_IO_EXPORT void
writeSTLMesh(std::ostream& stream, const TriangleMesh& mesh);

/** \brief A mesh as PCL knows it, for its viewer and its own writers; float. */
PCL_CID_IO_EXPORT pcl::PolygonMesh
toPolygonMesh(const TriangleMesh& mesh);

/** \brief Move hulls: back to the frame of a file whose coordinates had an offset taken
 *  out (see CloudPoints). */
PCL_CID_IO_EXPORT void
translate(const Eigen::Vector3d& offset, std::vector<ConvexPart>& parts);

} // namespace pcl_cid
