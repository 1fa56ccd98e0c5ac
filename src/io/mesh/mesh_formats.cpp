/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The file formats of meshes, in one table.
 */

#include "mesh_rows.h"
#include "text/format_table.h"

#include <filesystem>
#include <utility>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

/** A new format is one more row here. */
FormatTable<MeshFormat>&
formatTable()
{
  static FormatTable<MeshFormat> table{objFormat(), plyMeshFormat(), stlFormat()};
  return table;
}

/** At a blank some programs end the name, others do not; some want a backslash before
 *  it, to others that is a letter of the name. */
std::string
withoutBlanks(std::string file)
{
  for (char& c : file)
    if (c == ' ' || c == '\t')
      c = '_';
  return file;
}

} // namespace

void
writeMesh(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const std::string& path,
          const std::string& name)
{
  const fs::path materials = materialsBeside(path);
  meshFormatOf(path).write(stream, parts, materials.filename().string(), name);
}

std::string
materialsBeside(const std::string& path)
{
  const std::string& extension = meshFormatOf(path).materials_extension;
  if (extension.empty())
    return "";
  const fs::path beside = fs::path(path).replace_extension(extension);
  return beside.parent_path() / withoutBlanks(beside.filename().string());
}

void
writeMaterials(std::ostream& stream,
               const std::vector<ConvexPart>& parts,
               const std::string& path,
               const std::string& name)
{
  const MeshFormat& format = meshFormatOf(path);
  if (format.write_materials)
    format.write_materials(stream, parts, name);
}

std::vector<MeshFormat>
meshFormats()
{
  return formatTable().all();
}

const MeshFormat&
meshFormatOf(const std::string& path)
{
  const MeshFormat* const format = formatTable().forFile(path);
  if (!format)
    throw CIDException(path + ": a mesh is written as " + listed(meshExtensions()));
  return *format;
}

std::vector<std::string>
meshExtensions()
{
  std::vector<std::string> extensions;
  for (const MeshFormat& format : meshFormats())
    extensions.insert(
        extensions.end(), format.extensions.begin(), format.extensions.end());
  return extensions;
}

std::vector<std::string>
partMeshExtensions()
{
  std::vector<std::string> extensions;
  for (const MeshFormat& format : meshFormats())
    if (format.write_mesh)
      extensions.insert(
          extensions.end(), format.extensions.begin(), format.extensions.end());
  return extensions;
}

void
registerMeshFormat(MeshFormat format)
{
  if (!format.write)
    throw CIDException("the format " + format.name + " must have a writer");
  if (format.materials_extension.empty() == static_cast<bool>(format.write_materials))
    throw CIDException("the format " + format.name +
                       " must have an extension and a writer for its colors, or "
                       "neither");
  formatTable().add(std::move(format));
}

} // namespace pcl_cid
