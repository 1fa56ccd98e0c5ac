/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The meshes of a USD in text, read back to check them.
 */

#include "base/sentence.h"
#include "mesh_readers.h"
#include "text/numbers.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <array>
#include <istream>
#include <sstream>

namespace pcl_cid {
namespace {

/** Reads line by line what writeUSD() has written. */
class USDReading {
public:
  explicit USDReading(std::istream& stream) : stream_(stream) {}

  NamedMeshes
  meshes()
  {
    const char* const head[] = {"#usda 1.0",
                                "(",
                                nullptr, // the default prim
                                "    metersPerUnit = 1",
                                "    upAxis = \"Z\"",
                                ")",
                                "",
                                nullptr, // the prim of the scene
                                "{"};
    for (const char* const line : head)
      next(line);
    NamedMeshes meshes;
    while (next(nullptr) != "}")
      readMesh(meshes);
    return meshes;
  }

private:
  [[noreturn]] void
  fail(const std::string& reason) const
  {
    throw CIDException(sentence("line ", number_, ": ", reason));
  }

  /** \param[in] expected null: anything */
  const std::string&
  next(const char* expected)
  {
    ++number_;
    if (!std::getline(stream_, line_))
      fail("is missing");
    if (expected && line_ != expected)
      fail(sentence("is not '", expected, "'"));
    return line_;
  }

  /** What stands behind a beginning and before an end of the next line. */
  std::string
  between(const std::string& begin, const std::string& end = "")
  {
    next(nullptr);
    return within(begin, end);
  }

  std::string
  within(const std::string& begin, const std::string& end) const
  {
    if (line_.size() < begin.size() + end.size() || line_.rfind(begin, 0) != 0 ||
        line_.compare(line_.size() - end.size(), end.size(), end) != 0)
      fail(sentence("is not '", begin, "...", end, "'"));
    return line_.substr(begin.size(), line_.size() - begin.size() - end.size());
  }

  /** The numbers of a list, of tuples or not. */
  template <typename Number>
  std::vector<Number>
  numbersIn(std::string text) const
  {
    const auto is_between = [](char c) {
      return c == '(' || c == ')' || c == '[' || c == ']' || c == ',';
    };
    std::replace_if(text.begin(), text.end(), is_between, ' ');
    std::istringstream words(text);
    std::vector<Number> numbers;
    for (std::string word; words >> word;) {
      const auto number = parseNumber<Number>(word);
      if (!number)
        fail(sentence("has '", word, "' where a number must be"));
      numbers.push_back(*number);
    }
    return numbers;
  }

  template <typename Number>
  std::vector<std::array<Number, 3>>
  triplesIn(const std::string& text) const
  {
    const std::vector<Number> numbers = numbersIn<Number>(text);
    if (numbers.size() % 3 != 0)
      fail("has no triples");
    std::vector<std::array<Number, 3>> triples;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
      triples.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    return triples;
  }

  /** From its line "def Mesh" on. */
  void
  readMesh(NamedMeshes& meshes)
  {
    const std::string name = within("    def Mesh \"", "\" (");
    between("        prepend apiSchemas = ");
    next("    )");
    next("    {");
    next("        uniform token physics:approximation = \"convexHull\"");
    next("        uniform token subdivisionScheme = \"none\"");
    between("        float3[] extent = ");
    PlacedMesh placed;
    const auto counts = numbersIn<int>(between("        int[] faceVertexCounts = "));
    placed.mesh.triangles =
        triplesIn<std::uint32_t>(between("        int[] faceVertexIndices = "));
    if (counts != std::vector<int>(placed.mesh.triangles.size(), 3))
      fail("not all faces are triangles");
    for (const auto& [x, y, z] :
         triplesIn<float>(between("        point3f[] points = ")))
      placed.mesh.vertices.emplace_back(x, y, z);
    requireCorners(placed.mesh);
    between("        color3f[] primvars:displayColor = ");
    const auto origin =
        triplesIn<double>(between("        double3 xformOp:translate = "));
    if (origin.size() != 1)
      fail("has no place");
    placed.origin = {origin[0][0], origin[0][1], origin[0][2]};
    next("        uniform token[] xformOpOrder = [\"xformOp:translate\"]");
    next("    }");
    if (!meshes.emplace(name, placed).second)
      fail(sentence("there are two prims of the name ", name));
  }

  void
  requireCorners(const TriangleMesh& mesh) const
  {
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle)
        if (corner >= mesh.vertices.size())
          fail("a triangle has a corner that is none");
  }

  std::istream& stream_;
  std::string line_;
  std::size_t number_ = 0;
};

} // namespace

NamedMeshes
readMeshesOfUSD(std::istream& stream)
{
  return USDReading(stream).meshes();
}

} // namespace pcl_cid
