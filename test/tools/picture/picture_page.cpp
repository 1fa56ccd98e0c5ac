/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page of a picture, taken apart.
 */

#include "picture_page.h"

#include <cstring>
#include <stdexcept>

#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace pcl_cid::test {
namespace {

std::string
contentOf(const std::string& page, const std::string& type, const std::string& id)
{
  const std::string tag = "<script type=\"" + type + "\" id=\"" + id + "\">";
  if (timesIn(page, tag) != 1)
    throw std::runtime_error("not once in the page: " + tag);
  const std::size_t begin = page.find(tag) + tag.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

template <typename Number>
std::vector<Number>
numbersOf(const std::string& page, const std::string& id)
{
  using namespace boost::archive::iterators;
  using Bytes = transform_width<binary_from_base64<const char*>, 8, 6>;
  std::string text = contentOf(page, "application/octet-stream", id);
  const std::size_t padding = text.size() - (text.find_last_not_of('=') + 1);
  text.replace(text.size() - padding, padding, padding, 'A');
  std::string bytes(Bytes(text.data()), Bytes(text.data() + text.size()));
  bytes.resize(bytes.size() - padding);
  if (bytes.size() % sizeof(Number) != 0)
    throw std::runtime_error(id + ": not whole numbers");
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if (!numbers.empty())
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

Eigen::Vector3d
inFile(const nlohmann::json& facts, const std::vector<float>& numbers, std::size_t i)
{
  const std::vector<double> origin = facts.at("origin");
  return Eigen::Vector3d(origin[0], origin[1], origin[2]) +
         Eigen::Vector3f(&numbers.at(3 * i)).cast<double>();
}

} // namespace

PicturePage::PicturePage(const std::string& page)
: facts(nlohmann::json::parse(contentOf(page, "application/json", "facts")))
, positions(numbersOf<float>(page, "positions"))
, colors(numbersOf<unsigned char>(page, "colors"))
, labels(numbersOf<std::uint32_t>(page, "labels"))
, values(numbersOf<float>(page, "values"))
, hull_vertices(numbersOf<float>(page, "hull_vertices"))
, hull_triangles(numbersOf<std::uint32_t>(page, "hull_triangles"))
{
}

Eigen::Vector3d
PicturePage::position(std::size_t point) const
{
  return inFile(facts, positions, point);
}

Eigen::Vector3d
PicturePage::hullVertex(std::size_t vertex) const
{
  return inFile(facts, hull_vertices, vertex);
}

std::size_t
timesIn(const std::string& text, const std::string& part)
{
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1))
    ++times;
  return times;
}

} // namespace pcl_cid::test
