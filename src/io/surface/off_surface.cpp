/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The triangles of an OFF (Geomview's Object File Format) in ascii.
 */

#include "base/sentence.h"
#include "surface_formats.h"
#include "text/numbers.h"
#include "text/words.h"

#include <algorithm>
#include <istream>
#include <string_view>

namespace pcl_cid {
namespace {

/** Reads one file; each member function is one part of it. */
class OFFReading {
public:
  OFFReading(std::istream& stream, std::uint64_t size, const std::string& name)
  : stream_(stream), size_(size), name_(name)
  {
  }

  TriangleMesh
  mesh()
  {
    readHeader();
    for (std::uint64_t i = 0; i < vertices_; ++i)
      addVertex();
    for (std::uint64_t i = 0; i < faces_; ++i)
      addFaceOfLine();
    return std::move(mesh_);
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(name_, ": line ", line_number_, ": ", parts...));
  }

  /** The next line that is neither blank nor a comment. */
  void
  nextLine()
  {
    while (std::getline(stream_, line_)) {
      ++line_number_;
      rest_ = line_;
      rest_ = rest_.substr(0, rest_.find('#'));
      if (rest_.find_first_not_of(usual_blanks) != std::string_view::npos)
        return;
    }
    throw CIDException(sentence(name_,
                                ": is truncated: it announces ",
                                vertices_,
                                " vertices and ",
                                countOf(faces_, "face")));
  }

  /** "OFF", with letters for what else a vertex has before it; the counts may stand in
   *  the same line. */
  void
  readHeader()
  {
    nextLine();
    const std::string_view line = rest_;
    const std::string_view word = takeWord(rest_);
    constexpr std::string_view magic = "OFF";
    const std::size_t place = word.find(magic);
    if (place != std::string_view::npos) // counts may follow at once
      rest_ = line.substr(line.find(magic) + magic.size());
    if (place == std::string_view::npos || word.find_first_not_of("STCN") != place)
      fail("'", word.substr(0, 32), "' begins no OFF in ascii with three coordinates");
    if (rest_.find_first_not_of(usual_blanks) == std::string_view::npos)
      nextLine();
    vertices_ = count();
    faces_ = count();
    if (2 * (vertices_ + faces_) > size_) // before memory is taken for them
      fail("announces ",
           vertices_,
           " vertices and ",
           faces_,
           " faces, but the file has ",
           countOf(size_, "byte"));
  }

  std::uint64_t
  count()
  {
    const std::string_view word = takeWord(rest_);
    const auto number = parseNumber<std::uint32_t>(word);
    if (!number)
      fail("'", word.substr(0, 32), "' is no number of vertices or faces");
    return *number;
  }

  /** Normals, colors and the like follow. */
  void
  addVertex()
  {
    nextLine();
    const auto vertex = takeCoordinates(rest_);
    if (!vertex)
      fail("has no three coordinates");
    mesh_.vertices.push_back(*vertex);
  }

  /** The number of corners, the corners, and perhaps a color. */
  void
  addFaceOfLine()
  {
    nextLine();
    const std::uint64_t corners = count();
    corners_.clear();
    for (std::uint64_t k = 0; k < corners; ++k) {
      const std::string_view word = takeWord(rest_);
      const auto index = parseNumber<std::uint64_t>(word);
      if (!index || *index >= vertices_)
        fail("'", word.substr(0, 32), "' is none of the ", vertices_, " vertices");
      corners_.push_back(*index);
    }
    addFace(corners_, mesh_);
  }

  std::istream& stream_;
  const std::uint64_t size_;
  const std::string& name_;
  std::string line_;
  std::string_view rest_; ///< of the line
  std::size_t line_number_ = 0;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  std::vector<std::uint64_t> corners_;
  TriangleMesh mesh_;
};

} // namespace

SurfaceFormat
offSurface()
{
  return {"OFF",
          {".off"},
          false,
          [](std::istream& stream, std::uint64_t size, const std::string& name) {
            return OFFReading(stream, size, name).mesh();
          }};
}

} // namespace pcl_cid
