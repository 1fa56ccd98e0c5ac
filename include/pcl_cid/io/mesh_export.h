/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts as mesh files: the writers, one by one. mesh_formats.h has them in a
 * table.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/frame.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Color of a part, 0 to 255 each. */
struct PartColor {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
};

/** \brief The color of a part: that of its number in pcl::GlasbeyLUT, whose 256 colors
 *  are as different as can be; they repeat after that.
 *  \param[in] part its number, from 0 */
PCL_CID_IO_EXPORT PartColor
partColor(std::size_t part);

/** \brief "part_000", "part_001", ...; of parts with the name "kitchen" it is
 *  "kitchen_part_000", "kitchen_part_001", ...
 *  \param[in] part its number, from 0
 *  \param[in] name of all the parts, which tells them from those of other scans; may be
 *  empty */
PCL_CID_IO_EXPORT std::string
partName(std::size_t part, const std::string& name = "");

/** \brief Refuse a name of parts that is not good in all formats: it must be letters
 *  of ASCII, digits and underscores, a letter first, and not `world`.
 *  \throws CIDException */
PCL_CID_IO_EXPORT void
requirePartsName(const std::string& name);

/** \brief A good name, as much like any text as can be: what is no letter and no digit
 *  becomes an underscore, one for several in a row and none at the ends; "scan" goes
 *  before what does not begin with a letter. "2nd floor (new)" gives
 *  "scan_2nd_floor_new". */
PCL_CID_IO_EXPORT std::string
partsNameFrom(const std::string& text);

/** \brief A Wavefront OBJ: an object `o part_NNN` for each hull, coordinates with all
 *  the digits of double.
 *
 *  Like all writers here it throws nothing: look at the state of the stream afterwards,
 *  or write through OutputFiles.
 *  \param[in] material_library name of the file that writeMTL() writes, as seen from
 *  the OBJ; many programs read no name with a blank (see materialsBeside())
 *  \param[in] name before the names of objects and materials (see partName()) */
PCL_CID_IO_EXPORT void
writeOBJ(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const std::string& material_library,
         const std::string& name = "");

/** \brief A Wavefront OBJ of one mesh: an object of this name, without color. */
PCL_CID_IO_EXPORT void
writeOBJMesh(std::ostream& stream, const TriangleMesh& mesh, const std::string& name);

/** \brief The material library of an OBJ: a material `part_NNN` for each part.
 *  \param[in] name as in the OBJ */
PCL_CID_IO_EXPORT void
writeMTL(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const std::string& name = "");

/** \brief A binary PLY: one mesh, coordinates as double, for each face its color and
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

/** \brief Move hulls from a local frame to that of the file: from that of CloudPoints,
 *  in which they were made, to that in which they are written. */
PCL_CID_IO_EXPORT void
moveToFile(const Frame& frame, std::vector<ConvexPart>& parts);

} // namespace pcl_cid
