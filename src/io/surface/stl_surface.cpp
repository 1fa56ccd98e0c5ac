/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The triangles of an STL, binary or ascii.
 */

#include "base/sentence.h"
#include "surface_formats.h"
#include "text/file_reading.h"
#include "text/numbers.h"
#include "text/words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <istream>
#include <string_view>

namespace pcl_cid {
namespace {

constexpr std::uint64_t header_bytes = 80 + 4; // a text, and the number of triangles
constexpr std::uint64_t triangle_bytes = 50;

std::string
inSmallLetters(std::string_view word)
{
  std::string letters(word);
  for (char& letter : letters)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return letters;
}

void
addTriangle(const std::array<Eigen::Vector3d, 3>& corners, TriangleMesh& mesh)
{
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/** \param[in] bytes a normal, three corners of three floats, two bytes more */
std::array<Eigen::Vector3d, 3>
cornersOf(const char* bytes)
{
  std::array<float, 12> values{};
  std::memcpy(values.data(), bytes, sizeof(values));
  std::array<Eigen::Vector3d, 3> corners;
  for (std::size_t k = 0; k < corners.size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      corners[k][static_cast<Eigen::Index>(axis)] = values[3 + 3 * k + axis];
  return corners;
}

/** The number of triangles that a binary file says it has. */
std::uint64_t
announced(std::istream& stream)
{
  std::array<char, header_bytes> header{};
  std::uint32_t count = 0;
  stream.read(header.data(), header.size());
  if (stream)
    std::memcpy(&count, header.data() + 80, sizeof(count));
  return count;
}

TriangleMesh
binaryMesh(std::istream& stream, std::uint64_t count, const std::string& name)
{
  constexpr std::size_t block = 4096; // triangles
  std::vector<char> bytes(block * triangle_bytes);
  TriangleMesh mesh;
  mesh.vertices.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::uint64_t i = 0; i < count; i += block) {
    const std::uint64_t here = std::min<std::uint64_t>(block, count - i);
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(here * triangle_bytes)))
      throw CIDException(name + ": cannot be read to its end");
    for (std::uint64_t k = 0; k < here; ++k)
      addTriangle(cornersOf(bytes.data() + k * triangle_bytes), mesh);
  }
  return mesh;
}

/** Three lines "vertex x y z" are a triangle, and a loop has three. */
TriangleMesh
asciiMesh(std::istream& stream, const std::string& name)
{
  TriangleMesh mesh;
  std::array<Eigen::Vector3d, 3> corners;
  std::size_t corner = 0;
  std::size_t line_number = 0;
  bool is_open = false; // a solid
  const auto fail = [&](const std::string& what) {
    throw CIDException(sentence(name, ": line ", line_number, ": ", what));
  };
  const char line_end = lineEndOf(stream);
  for (std::string line; std::getline(stream, line, line_end);) {
    ++line_number;
    std::string_view rest = line;
    const std::string word = inSmallLetters(takeWord(rest));
    if (word == "solid")
      is_open = true;
    else if (word == "endsolid")
      is_open = false;
    else if (word == "vertex") {
      if (corner == corners.size())
        fail("is the fourth corner of a triangle");
      const auto position = takeCoordinates(rest);
      if (!position)
        fail("must have three coordinates");
      corners[corner] = *position;
      ++corner;
    }
    else if (word == "endloop") {
      if (corner != corners.size())
        fail(sentence("ends a triangle with ", countOf(corner, "corner")));
      addTriangle(corners, mesh);
      corner = 0;
    }
  }
  if (is_open)
    throw CIDException(name + ": is truncated: there is no 'endsolid'");
  return mesh;
}

/** By its size, since a binary file may begin with "solid", too. */
TriangleMesh
readSTLSurface(std::istream& stream, std::uint64_t size, const std::string& name)
{
  const std::uint64_t count = announced(stream);
  stream.clear();
  const std::uint64_t needed = header_bytes + count * triangle_bytes;
  if (count > 0 && size >= needed) { // some programs add something of their own
    stream.seekg(static_cast<std::streamoff>(header_bytes));
    return binaryMesh(stream, count, name);
  }
  stream.seekg(0);
  std::string word;
  if (stream >> word && inSmallLetters(word) == "solid") {
    stream.seekg(0);
    return asciiMesh(stream, name);
  }
  throw CIDException(sentence(name,
                              ": is no STL: it does not begin with 'solid', and has ",
                              countOf(size, "byte"),
                              "; the ",
                              countOf(count, "triangle"),
                              " that its header announces need ",
                              needed));
}

} // namespace

SurfaceFormat
stlSurface()
{
  return {"STL", {".stl"}, false, readSTLSurface};
}

} // namespace pcl_cid
