/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The file formats of meshes, in one table.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief A file format of meshes: a row of the table. */
struct MeshFormat {
  /** What users call it: "OBJ". */
  std::string name;
  /** How names of its files end: in small letters, with the dot. */
  std::vector<std::string> extensions;
  /** Whether it rounds coordinates to float: far from the origin, thin hulls lose their
   *  shape in it. */
  bool is_float = false;
  /** Whether it keeps the parts apart, so that read() gives one mesh for each of them;
   *  else it gives one mesh of all. */
  bool has_parts = true;
  /** Extension, with the dot, of the file beside the mesh that holds its colors; empty
   *  when they are in the mesh, or nowhere. */
  std::string materials_extension;
  /** Whether the names of parts stand in it. */
  bool names_parts = false;
  /** Write the hulls of parts.
   *  \param[in] materials name of the file of colors as seen from the mesh; of no
   *  meaning to a format without one
   *  \param[in] name of all the parts (see partName()); of no meaning to a format in
   *  which no names stand */
  std::function<void(std::ostream& stream,
                     const std::vector<ConvexPart>& parts,
                     const std::string& materials,
                     const std::string& name)>
      write;
  /** Write the file of colors; empty for a format without one. */
  std::function<void(std::ostream& stream,
                     const std::vector<ConvexPart>& parts,
                     const std::string& name)>
      write_materials;
  /** Write one mesh under a name, as scenes refer to them; empty for a format in which
   *  they do not. */
  std::function<void(
      std::ostream& stream, const TriangleMesh& mesh, const std::string& name)>
      write_mesh;
  /** Read a file back, strictly; empty for a format that is only written.
   *  \throws CIDException that names the file and says what is wrong with it */
  std::function<std::vector<TriangleMesh>(const std::string& path)> read;
};

/** \brief Write the hulls of parts in the format that the extension of a file says.
 *  Look at the state of the stream afterwards to see whether it worked, or write
 *  through OutputFiles.
 *  \param[in] path name of the file
 *  \param[in] name before the names of parts, where the format has those (see
 *  partName())
 *  \throws CIDException when no format has this extension */
PCL_CID_IO_EXPORT void
writeMesh(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const std::string& path,
          const std::string& name = "");

/** \brief The file of colors beside a mesh: "hulls.mtl" for "hulls.obj". A blank in
 *  the name becomes an underscore, "my_hulls.mtl" for "my hulls.obj": programs that
 *  read OBJ do not agree on how it names a file with blanks.
 *  \return empty when the format of the mesh has none
 *  \throws CIDException when no format has this extension */
PCL_CID_IO_EXPORT std::string
materialsBeside(const std::string& path);

/** \brief Write the file of colors of a mesh, if its format has one.
 *  \param[in] path name of the mesh, not of the colors
 *  \param[in] name as in the mesh
 *  \throws CIDException when no format has this extension */
PCL_CID_IO_EXPORT void
writeMaterials(std::ostream& stream,
               const std::vector<ConvexPart>& parts,
               const std::string& path,
               const std::string& name = "");

/** \brief All formats: OBJ, PLY, STL, then those that were registered. */
PCL_CID_IO_EXPORT std::vector<MeshFormat>
meshFormats();

/** \brief The format with the extension of this file. The row stays where it is as
 *  long as the program runs.
 *  \throws CIDException when there is none; the message lists the extensions */
PCL_CID_IO_EXPORT const MeshFormat&
meshFormatOf(const std::string& path);

/** \brief Extensions of all formats: ".obj", ".ply", ".stl". */
PCL_CID_IO_EXPORT std::vector<std::string>
meshExtensions();

/** \brief Extensions of the formats in which scenes refer to the meshes of parts (those
 *  with MeshFormat::write_mesh): ".obj", ".stl". */
PCL_CID_IO_EXPORT std::vector<std::string>
partMeshExtensions();

/** \brief Add a format for as long as the program runs: all functions here know it from
 *  then on. Any thread may call this.
 *  \throws CIDException when its name or one of its extensions is taken or no good, or
 *  when it has no writer, or only one of extension and writer of its colors */
PCL_CID_IO_EXPORT void
registerMeshFormat(MeshFormat format);

} // namespace pcl_cid
