/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the header of a PLY: what the file holds, and in which order.
 */

#include "ply_header.h"

#include "base/sentence.h"
#include "fields/field_values.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <pcl_cid/exceptions.h>

#include <sstream>

namespace pcl_cid {
namespace {

struct TypeName {
  const char* name;
  const char* modern_name;
  std::uint8_t datatype;
};

constexpr TypeName type_names[] = {{"char", "int8", pcl::PCLPointField::INT8},
                                   {"uchar", "uint8", pcl::PCLPointField::UINT8},
                                   {"short", "int16", pcl::PCLPointField::INT16},
                                   {"ushort", "uint16", pcl::PCLPointField::UINT16},
                                   {"int", "int32", pcl::PCLPointField::INT32},
                                   {"uint", "uint32", pcl::PCLPointField::UINT32},
                                   {"float", "float32", pcl::PCLPointField::FLOAT32},
                                   {"double", "float64", pcl::PCLPointField::FLOAT64}};

/** Reads the header line by line. */
class HeaderReading {
public:
  HeaderReading(const std::string& name, char line_end) : name_(name)
  {
    header_.line_end = line_end;
  }

  /** \return whether more lines follow */
  bool
  takeLine(const std::string& line)
  {
    ++header_.lines;
    line_ = line;
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "end_header")
      return false;
    if (key == "format")
      takeFormat(words);
    else if (key == "element")
      takeElement(words);
    else if (key == "property")
      takeProperty(words);
    else if (!key.empty() && key != "ply" && key != "comment" && key != "obj_info")
      fail();
    return true;
  }

  const PLYHeader&
  header() const
  {
    if (!format_known_)
      throw CIDException(name_ + ": the PLY header has no format line");
    return header_;
  }

private:
  [[noreturn]] void
  fail() const
  {
    throw CIDException(sentence(name_,
                                ": line ",
                                header_.lines,
                                ": '",
                                line_.substr(0, 64),
                                "' is no line of a PLY header"));
  }

  void
  takeFormat(std::istringstream& words)
  {
    std::string format;
    words >> format;
    if (format == "ascii")
      header_.encoding = PLYHeader::Encoding::ascii;
    else if (format == "binary_little_endian")
      header_.encoding = PLYHeader::Encoding::little_endian;
    else if (format == "binary_big_endian")
      header_.encoding = PLYHeader::Encoding::big_endian;
    else
      fail();
    format_known_ = true;
  }

  void
  takeElement(std::istringstream& words)
  {
    PLYElement element;
    std::string count;
    words >> element.name >> count;
    const auto number = parseNumber<std::uint64_t>(count);
    if (!number)
      fail();
    element.count = *number;
    header_.elements.push_back(element);
  }

  void
  takeProperty(std::istringstream& words)
  {
    if (header_.elements.empty())
      fail();
    PLYProperty property;
    std::string type;
    words >> type;
    if (type == "list") {
      words >> type;
      property.length_datatype = plyDatatype(type);
      if (property.length_datatype == 0 || kindOf(property.length_datatype) == 'F')
        fail();
      words >> type;
    }
    property.datatype = plyDatatype(type);
    words >> property.name;
    if (property.datatype == 0 || property.name.empty())
      fail();
    header_.elements.back().properties.push_back(property);
  }

  const std::string& name_;
  PLYHeader header_;
  std::string line_;
  bool format_known_ = false;
};

} // namespace

int
PLYElement::find(const std::string& property, std::uint8_t datatype) const
{
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property && properties[i].length_datatype == 0 &&
        (datatype == 0 || properties[i].datatype == datatype))
      return static_cast<int>(i);
  return -1;
}

PLYHeader
readPLYHeader(std::istream& stream, const std::string& name)
{
  const char line_end = lineEndOf(stream);
  passByteOrderMark(stream);
  HeaderReading reading(name, line_end);
  std::string line;
  do {
    if (!readHeaderLine(stream, line_end, name, line))
      throw CIDException(name + ": the PLY header does not end; the file is truncated");
  } while (reading.takeLine(line));
  return reading.header();
}

std::uint8_t
plyDatatype(const std::string& type)
{
  for (const TypeName& known : type_names)
    if (type == known.name || type == known.modern_name)
      return known.datatype;
  return 0;
}

const char*
plyTypeName(std::uint8_t datatype)
{
  for (const TypeName& known : type_names)
    if (datatype == known.datatype)
      return known.name;
  return nullptr;
}

} // namespace pcl_cid
