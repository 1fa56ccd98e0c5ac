/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts of an OBJ, whichever program wrote it.
 */

#include "obj_parts.h"

#include "io/text/numbers.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>
#include <unordered_map>

namespace pcl_cid::benchmarks {
namespace {

/** What says how a mesh looks, and no more. */
constexpr std::array<std::string_view, 16> passed_over = {"bevel",
                                                          "c_interp",
                                                          "d_interp",
                                                          "l",
                                                          "lod",
                                                          "maplib",
                                                          "mg",
                                                          "mtllib",
                                                          "p",
                                                          "s",
                                                          "shadow_obj",
                                                          "trace_obj",
                                                          "usemap",
                                                          "usemtl",
                                                          "vn",
                                                          "vt"};

/** Of a vertex or a face: the last `o` and the last `g` before it. */
struct Names {
  int object; ///< counts them; -1 before the first
  int group;  ///< the same for the same name; -1 before the first
};

/** Reads line by line what the file has, without a thought of parts. */
class OBJLines {
public:
  explicit OBJLines(std::string path) : path_(std::move(path)) {}

  void
  take(std::string line)
  {
    while (!line.empty() && line.back() == '\r')
      line.pop_back();
    ++line_number_;
    line_ = line;
    std::istringstream stream(line);
    std::string keyword;
    if (!(stream >> keyword) || keyword[0] == '#')
      return;
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream),
                                         {}};
    if (keyword == "v")
      addVertex(words);
    else if (keyword == "f")
      addFace(words);
    else if (keyword == "o")
      now_.object = objects_++;
    else if (keyword == "g")
      nameGroup(words);
    else if (std::find(passed_over.begin(), passed_over.end(), keyword) ==
             passed_over.end())
      fail("is not understood");
  }

  MeshParts
  parts() const;

private:
  struct Face {
    std::vector<std::size_t> corners;
    Names names;
  };

  [[noreturn]] void
  fail(const std::string& reason) const
  {
    throw CIDException(path_ + ": line " + std::to_string(line_number_) + ": '" +
                       line_.substr(0, 64) + "' " + reason);
  }

  /** What follows the three coordinates is a weight or a color. */
  void
  addVertex(const std::vector<std::string>& words)
  {
    if (words.size() < 3)
      fail("has fewer than the 3 coordinates of a vertex");
    Eigen::Vector3d vertex;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto number = parseLoosely<double>(words[axis]);
      if (!number || !std::isfinite(*number))
        fail("has '" + words[axis] + "' where a finite number must be");
      vertex[static_cast<Eigen::Index>(axis)] = *number;
    }
    vertices_.push_back(vertex);
    names_.push_back(now_);
  }

  void
  addFace(const std::vector<std::string>& words)
  {
    Face face{{}, now_};
    for (const std::string& word : words) {
      if (word[0] == '#')
        break;
      face.corners.push_back(vertexOf(word));
    }
    if (face.corners.size() < 3)
      fail("has fewer than the 3 corners of a face");
    faces_.push_back(face);
  }

  /** \param[in] word the number of a vertex, with those of a texture and a normal or
   *  not; negative ones count back from the last vertex */
  std::size_t
  vertexOf(const std::string& word) const
  {
    const auto number = parseNumber<std::int64_t>(word.substr(0, word.find('/')));
    if (!number)
      fail("has '" + word + "' where the number of a vertex must be");
    const auto count = static_cast<std::int64_t>(vertices_.size());
    const std::int64_t index = *number < 0 ? count + *number : *number - 1;
    if (index < 0 || index >= count)
      fail("names vertex " + std::to_string(*number) + "; there are " +
           std::to_string(count) + " before it");
    return static_cast<std::size_t>(index);
  }

  void
  nameGroup(const std::vector<std::string>& words)
  {
    std::string name;
    for (const std::string& word : words)
      name += ' ' + word;
    now_.group = group_of_name_.emplace(name, static_cast<int>(group_of_name_.size()))
                     .first->second;
  }

  std::string path_;
  std::string line_;
  std::size_t line_number_ = 0;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Names> names_; ///< of each vertex
  std::vector<Face> faces_;
  std::map<std::string, int> group_of_name_;
  int objects_ = 0;
  Names now_{-1, -1};
};

/** A mesh that takes vertices of a file as they are named. */
class GrowingMesh {
public:
  std::uint32_t
  add(std::size_t vertex, const std::vector<Eigen::Vector3d>& vertices)
  {
    const auto [place, is_new] =
        number_.emplace(vertex, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new)
      mesh.vertices.push_back(vertices[vertex]);
    return place->second;
  }

  TriangleMesh mesh;

private:
  std::unordered_map<std::size_t, std::uint32_t> number_;
};

MeshParts
OBJLines::parts() const
{
  const bool by_object = objects_ > 1 || group_of_name_.empty();
  const auto partOf = [by_object](const Names& names) {
    return by_object ? names.object : names.group;
  };
  std::map<int, GrowingMesh> part;
  std::vector<char> is_named(vertices_.size());
  for (const Face& face : faces_) {
    GrowingMesh& growing = part[partOf(face.names)];
    std::vector<std::uint32_t> corners;
    for (const std::size_t vertex : face.corners) {
      is_named[vertex] = true;
      corners.push_back(growing.add(vertex, vertices_));
    }
    for (std::size_t k = 2; k < corners.size(); ++k)
      growing.mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    if (!is_named[i] && partOf(names_[i]) >= 0)
      part[partOf(names_[i])].add(i, vertices_);

  MeshParts parts;
  parts.has_names = objects_ > 0 || !group_of_name_.empty();
  for (auto& [number, growing] : part)
    parts.meshes.push_back(std::move(growing.mesh));
  return parts;
}

} // namespace

MeshParts
readOBJParts(const std::string& path)
{
  std::ifstream stream(path);
  OBJLines lines(path);
  for (std::string line; std::getline(stream, line);)
    lines.take(line);
  if (!stream.is_open() || stream.bad())
    throw CIDException(path + ": cannot be read");
  return lines.parts();
}

} // namespace pcl_cid::benchmarks
