/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Wavefront OBJ files of parts: written, and read back.
 */

#include "base/sentence.h"
#include "mesh_rows.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_import.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace pcl_cid {
namespace {

void
appendVector(const Eigen::Vector3d& v, std::string& text)
{
  for (int axis = 0; axis < 3; ++axis) {
    text += ' ';
    appendNumber(v[axis], text);
  }
}

void
appendVertices(const TriangleMesh& mesh, std::string& text)
{
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    text += 'v';
    appendVector(vertex, text);
    text += '\n';
  }
}

/** \param[in] first_vertex number of the mesh's first vertex in the file, from 1 */
void
appendFaces(const TriangleMesh& mesh, std::size_t first_vertex, std::string& text)
{
  for (const auto& triangle : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t vertex : triangle)
      text += ' ' + std::to_string(first_vertex + vertex);
    text += '\n';
  }
}

/** The words of a line, however many blanks are between them. */
std::vector<std::string>
wordsOf(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

/** Reads an OBJ line by line. */
class OBJReading {
public:
  explicit OBJReading(const std::string& path) : path_(path) {}

  void
  take(const std::string& line)
  {
    ++line_number_;
    line_ = line;
    const std::vector<std::string> words = wordsOf(line);
    if (words.empty() || words[0][0] == '#' || words[0] == "mtllib" ||
        words[0] == "usemtl")
      return;
    if (words[0] == "o")
      beginObject();
    else if (words[0] == "v" && words.size() == 4)
      addVertex(words);
    else if (words[0] == "f" && words.size() == 4)
      addTriangle(words);
    else
      fail("is not 'o NAME', 'v X Y Z' or 'f A B C'");
  }

  const std::vector<TriangleMesh>&
  meshes() const
  {
    return meshes_;
  }

private:
  [[noreturn]] void
  fail(const std::string& reason) const
  {
    throw CIDException(sentence(
        path_, ": line ", line_number_, ": '", line_.substr(0, 64), "' ", reason));
  }

  void
  beginObject()
  {
    if (!meshes_.empty())
      first_vertex_ += meshes_.back().vertices.size();
    meshes_.emplace_back();
  }

  TriangleMesh&
  object()
  {
    if (meshes_.empty())
      fail("stands before the first object");
    return meshes_.back();
  }

  template <typename Number>
  Number
  parse(const std::string& word) const
  {
    const auto number = parseNumber<Number>(word);
    if (!number)
      fail("has '" + word + "' where a number must be");
    return *number;
  }

  void
  addVertex(const std::vector<std::string>& words)
  {
    Eigen::Vector3d vertex;
    for (int axis = 0; axis < 3; ++axis)
      vertex[axis] = parse<double>(words[static_cast<std::size_t>(axis) + 1]);
    if (!vertex.allFinite())
      fail("is a vertex that is not finite");
    object().vertices.push_back(vertex);
  }

  void
  addTriangle(const std::vector<std::string>& words)
  {
    TriangleMesh& mesh = object();
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto number = parse<std::uint64_t>(words[corner + 1]);
      if (number < first_vertex_ || number - first_vertex_ >= mesh.vertices.size())
        fail("names a vertex that is not one of its object's before it");
      triangle[corner] = static_cast<std::uint32_t>(number - first_vertex_);
    }
    mesh.triangles.push_back(triangle);
  }

  const std::string& path_;
  std::vector<TriangleMesh> meshes_;
  /** Number of the object's first vertex, counted from 1 through all objects. */
  std::size_t first_vertex_ = 1;
  std::size_t line_number_ = 0;
  std::string line_;
};

} // namespace

void
writeOBJ(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const std::string& material_library,
         const std::string& name)
{
  stream << "mtllib " << material_library << '\n';
  std::size_t first_vertex = 1; // counted from 1, through all parts
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TriangleMesh& hull = parts[i].hull;
    std::string text = "o " + partName(i, name) + "\n";
    appendVertices(hull, text);
    text += "usemtl " + partName(i, name) + "\n";
    appendFaces(hull, first_vertex, text);
    stream << text;
    first_vertex += hull.vertices.size();
  }
}

void
writeOBJMesh(std::ostream& stream, const TriangleMesh& mesh, const std::string& name)
{
  std::string text = "o " + name + "\n";
  appendVertices(mesh, text);
  appendFaces(mesh, 1, text);
  stream << text;
}

void
writeMTL(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const std::string& name)
{
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartColor color = partColor(i);
    std::string text = "newmtl " + partName(i, name) + "\nKd";
    appendVector(Eigen::Vector3d(color.red, color.green, color.blue) / 255.0, text);
    stream << text << '\n';
  }
}

std::vector<TriangleMesh>
readOBJ(const std::string& path)
{
  std::ifstream stream = openedForReading(path);
  OBJReading reading(path);
  for (std::string line; std::getline(stream, line);)
    reading.take(line);
  if (stream.bad())
    throw CIDException(path + ": cannot be read: " + std::strerror(errno));
  return reading.meshes();
}

MeshFormat
objFormat()
{
  MeshFormat format;
  format.name = "OBJ";
  format.extensions = {".obj"};
  format.materials_extension = ".mtl";
  format.names_parts = true;
  format.write = writeOBJ;
  format.write_materials = writeMTL;
  format.write_mesh = writeOBJMesh;
  format.read = readOBJ;
  return format;
}

} // namespace pcl_cid
