/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the header of an array of NumPy: its shape, and what its elements are.
 */

#include "npy_header.h"

#include "base/sentence.h"
#include "text/numbers.h"

#include <pcl_cid/exceptions.h>

#include <array>
#include <cctype>
#include <istream>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace pcl_cid {
namespace {

using Json = nlohmann::json;

constexpr std::string_view magic{"\x93NUMPY", 6};

/** The dictionary of a header is a literal of Python: as JSON, tuples are lists. */
std::string
jsonOf(std::string_view literal)
{
  std::string json;
  char quote = '\0'; // of the string that is open
  for (std::size_t i = 0; i < literal.size(); ++i) {
    const char c = literal[i];
    if (quote != '\0') {
      if (c == '"' && quote != '"')
        json += '\\';
      json += c == quote ? '"' : c;
      if (c == '\\' && i + 1 < literal.size())
        json += literal[++i];
      else if (c == quote)
        quote = '\0';
    }
    else if (c == '\'' || c == '"') {
      quote = c;
      json += '"';
    }
    else if (c == ')' || c == ']' || c == '}') {
      while (!json.empty() && (json.back() == ',' || json.back() == ' '))
        json.pop_back(); // JSON ends no list with a comma
      json += c == ')' ? ']' : c;
    }
    else if (c == 'L' && !json.empty() && std::isdigit(json.back()))
      continue; // a long of Python 2
    else if (c == '(')
      json += '[';
    else if (literal.substr(i, 4) == "True" || literal.substr(i, 5) == "False") {
      json += c == 'T' ? "true" : "false";
      i += c == 'T' ? 3 : 4;
    }
    else
      json += c;
  }
  return json;
}

/** \return 0 for what is no number of columns that a cloud may have */
std::size_t
numbersIn(const Json& shape)
{
  std::size_t product = 1;
  for (const Json& length : shape.is_array() ? shape : Json::array({shape})) {
    const bool is_small = length.is_number_unsigned() &&
                          length.get<std::uint64_t>() <= most_numbers_of_point;
    product = is_small ? product * length.get<std::size_t>() : 0;
    if (product > most_numbers_of_point)
      return 0;
  }
  return product;
}

/** Reads one header; what does not fit is thrown as Json::exception. */
class NpyHeaderReading {
public:
  NpyHeaderReading(std::istream& stream, const std::string& name)
  : stream_(stream), name_(name)
  {
  }

  NpyHeader
  header()
  {
    const Json dictionary = Json::parse(jsonOf(text()));
    NpyHeader header;
    header.is_fortran_order = dictionary.at("fortran_order").get<bool>();
    for (const Json& length : dictionary.at("shape")) {
      if (!length.is_number_unsigned())
        fail("has the shape ", dictionary.at("shape").dump(), ", which is none");
      header.shape.push_back(length.get<std::uint64_t>());
    }
    const Json& description = dictionary.at("descr");
    if (description.is_string())
      header.fields.push_back(field(description.get<std::string>(), ""));
    else
      for (const Json& each : description) {
        if (!each.at(1).is_string())
          fail("has the field ",
               each.at(0).dump(),
               ", a record itself, which is not read");
        header.fields.push_back(
            field(each.at(1).get<std::string>(), each.at(0).get<std::string>()));
        if (each.size() > 2)
          header.fields.back().count = numbersIn(each.at(2));
        if (header.fields.back().count == 0)
          fail("has a field of the shape ",
               each.at(2).dump(),
               "; a point has at most ",
               most_numbers_of_point,
               " numbers");
      }
    return header;
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(name_, ": ", parts...));
  }

  void
  readBytes(char* bytes, std::size_t count)
  {
    if (!stream_.read(bytes, static_cast<std::streamsize>(count)))
      fail("is truncated: its header is not whole");
  }

  /** Magic, version, length, and as many bytes of text. */
  std::string
  text()
  {
    std::array<char, magic.size() + 2> begin{};
    readBytes(begin.data(), begin.size());
    const auto version = static_cast<unsigned char>(begin[magic.size()]);
    if (version < 1 || version > 3)
      fail("is an array of NumPy's format ", int{version}, "; 1 to 3 are known");
    std::array<unsigned char, 4> length{};
    readBytes(reinterpret_cast<char*>(length.data()), version == 1 ? 2 : 4);
    constexpr std::size_t longest = 1 << 20;
    const std::size_t bytes = length[0] | std::size_t{length[1]} << 8 |
                              std::size_t{length[2]} << 16 |
                              std::size_t{length[3]} << 24;
    if (bytes > longest)
      fail("is damaged: its header has ",
           bytes,
           " bytes; at most ",
           longest,
           " are expected");
    std::string text(bytes, '\0');
    readBytes(text.data(), bytes);
    return text;
  }

  /** \param[in] type "<f4": order of the bytes, kind, bytes */
  NpyField
  field(const std::string& type, const std::string& field_name) const
  {
    constexpr std::string_view kinds = "fiub";
    const auto size = type.size() < 3
                          ? std::nullopt
                          : parseNumber<std::size_t>(std::string_view(type).substr(2));
    const bool is_known =
        size && kinds.find(type[1]) != std::string_view::npos &&
        (*size == 4 || *size == 8 || (type[1] != 'f' && (*size == 1 || *size == 2)));
    if (!is_known)
      fail("holds elements of the type '",
           type,
           "'; they must be f4, f8, i1 to i8 or "
           "u1 to u8");
    return {field_name, type[1], *size, type[0] == '>', 1};
  }

  std::istream& stream_;
  const std::string& name_;
};

} // namespace

bool
recognizesNpy(std::istream& stream)
{
  std::array<char, magic.size()> begin{};
  stream.read(begin.data(), begin.size());
  return stream && std::string_view(begin.data(), begin.size()) == magic;
}

NpyHeader
readNpyHeader(std::istream& stream, const std::string& name)
{
  try {
    return NpyHeaderReading(stream, name).header();
  }
  catch (const Json::exception&) {
    throw CIDException(name + ": is damaged: its header is not what NumPy writes");
  }
}

} // namespace pcl_cid
