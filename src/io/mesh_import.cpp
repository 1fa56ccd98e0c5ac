/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The meshes of parts, read back from OBJ and STL files.
 */

#include "base/sentence.h"
#include "binary_reading.h"
#include "field_values.h"

#include <pcl_cid/io/mesh_import.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>

namespace pcl_cid {
namespace {

/** Words with single or more spaces between them. */
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

  template <typename Value>
  Value
  parse(const std::string& word, std::uint8_t datatype) const
  {
    Value value;
    if (!parseValue(word, datatype, reinterpret_cast<std::uint8_t*>(&value)))
      fail("has '" + word + "' where a number must be");
    return value;
  }

  void
  addVertex(const std::vector<std::string>& words)
  {
    Eigen::Vector3d vertex;
    for (int axis = 0; axis < 3; ++axis)
      vertex[axis] = parse<double>(words[static_cast<std::size_t>(axis) + 1],
                                   pcl::PCLPointField::FLOAT64);
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
      const auto number =
          parse<std::uint64_t>(words[corner + 1], pcl::PCLPointField::UINT64);
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

struct LexicographicallyLess {
  bool
  operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
  {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

} // namespace

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

TriangleMesh
readSTL(const std::string& path)
{
  constexpr std::uint64_t comment_bytes = 80;
  constexpr std::uint64_t triangle_bytes = 12 * sizeof(float) + 2;
  BinaryReading file(path);
  for (std::uint64_t i = 0; i < comment_bytes; ++i)
    file.read<char>();
  const auto count = file.read<std::uint32_t>();
  file.requireLeft(count * triangle_bytes);

  TriangleMesh mesh;
  std::map<Eigen::Vector3d, std::uint32_t, LexicographicallyLess> known;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      file.read<float>(); // the normal, which the corners say again
    std::array<std::uint32_t, 3> triangle{};
    for (std::uint32_t& corner : triangle) {
      const Eigen::Vector3d vertex = file.readFinite<float>();
      const auto [place, is_new] =
          known.emplace(vertex, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new)
        mesh.vertices.push_back(vertex);
      corner = place->second;
    }
    mesh.triangles.push_back(triangle);
    file.read<std::uint16_t>(); // attributes
  }
  return mesh;
}

} // namespace pcl_cid
