/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors of a cloud.
 */

#include "base/sentence.h"
#include "field_values.h"
#include "required_fields.h"

#include <pcl_cid/io/cloud_points.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace pcl_cid {
namespace {

using Channels = std::array<const pcl::PCLPointField*, 3>;

const pcl::PCLPointField*
findIgnoringCase(const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.count == 1 &&
        std::equal(field.name.begin(),
                   field.name.end(),
                   name.begin(),
                   name.end(),
                   [](unsigned char a, char b) { return std::tolower(a) == b; }))
      return &field;
  return nullptr;
}

/** Red, green and blue where they are fields of their own; null when they are not. */
Channels
channelsOf(const pcl::PCLPointCloud2& cloud)
{
  constexpr const char* known[][3] = {{"red", "green", "blue"},
                                      {"r", "g", "b"},
                                      {"diffuse_red", "diffuse_green", "diffuse_blue"}};
  for (const auto& names : known) {
    Channels channels;
    for (std::size_t k = 0; k < channels.size(); ++k)
      channels[k] = findIgnoringCase(cloud, names[k]);
    if (channels[0] && channels[1] && channels[2])
      return channels;
  }
  return {};
}

/** Colors from three fields of any type. */
class ChannelReading {
public:
  ChannelReading(const LabelledCloud& cloud, const Channels& channels)
  : cloud_(cloud), channels_(channels), coordinates_(cloud), white_(white())
  {
  }

  std::vector<ColorRGB>
  colors() const
  {
    std::vector<ColorRGB> colors(cloud_.size(), ColorRGB{0, 0, 0});
    for (std::size_t i = 0; i < colors.size(); ++i)
      if (coordinates_[i].allFinite())
        colors[i] = {byte(i, 0), byte(i, 1), byte(i, 2)};
    return colors;
  }

private:
  double
  value(std::size_t point, std::size_t channel) const
  {
    const pcl::PCLPointField& field = *channels_[channel];
    return toDouble(cloud_.fields.data.data() + point * cloud_.fields.point_step +
                        field.offset,
                    field.datatype);
  }

  /** The value that is brightest: by the type, or by the values where that says
   *  nothing. */
  double
  white() const
  {
    const std::uint8_t datatype = channels_[0]->datatype;
    if (datatype == pcl::PCLPointField::UINT8)
      return 255.0;
    if (datatype == pcl::PCLPointField::UINT16)
      return 65535.0;
    if (kindOf(datatype) != 'F')
      return 255.0;
    for (std::size_t i = 0; i < cloud_.size(); ++i)
      for (std::size_t k = 0; k < channels_.size(); ++k)
        if (coordinates_[i].allFinite() && value(i, k) > 1.0)
          return 255.0;
    return 1.0;
  }

  std::uint8_t
  byte(std::size_t point, std::size_t channel) const
  {
    const double given = value(point, channel);
    if (!(given >= 0.0 && given <= white_))
      throw CIDException(sentence(cloud_.name,
                                  ": field '",
                                  channels_[channel]->name,
                                  "' of point ",
                                  point,
                                  " is ",
                                  given,
                                  "; as a color it must be 0 to ",
                                  white_));
    return static_cast<std::uint8_t>(std::lround(255.0 * given / white_));
  }

  const LabelledCloud& cloud_;
  const Channels channels_;
  const FileCoordinates coordinates_;
  const double white_;
};

/** The packed field; null when there is none. */
const pcl::PCLPointField*
packedColor(const LabelledCloud& cloud)
{
  for (const char* const name : {"rgb", "rgba"})
    if (findField(cloud.fields, name))
      return &requireField(cloud, name);
  return nullptr;
}

std::vector<ColorRGB>
unpackedColors(const LabelledCloud& cloud, const pcl::PCLPointField& field)
{
  if (sizeOf(field.datatype) != sizeof(std::uint32_t))
    throw CIDException(sentence(cloud.name,
                                ": field '",
                                field.name,
                                "' has ",
                                sizeOf(field.datatype),
                                " bytes; colors must have 4"));
  std::vector<ColorRGB> colors;
  colors.reserve(cloud.size());
  const std::uint8_t* bytes = cloud.fields.data.data() + field.offset;
  for (std::size_t i = 0; i < cloud.size(); ++i, bytes += cloud.fields.point_step)
    colors.push_back(unpackColor(loadValue<std::uint32_t>(bytes)));
  return colors;
}

} // namespace

bool
hasColors(const LabelledCloud& cloud)
{
  return findField(cloud.fields, "rgb") || findField(cloud.fields, "rgba") ||
         channelsOf(cloud.fields)[0];
}

std::vector<ColorRGB>
colorsOf(const LabelledCloud& cloud)
{
  if (const pcl::PCLPointField* const packed = packedColor(cloud))
    return unpackedColors(cloud, *packed);
  if (const Channels channels = channelsOf(cloud.fields); channels[0])
    return ChannelReading(cloud, channels).colors();
  throw CIDException(cloud.name +
                     ": has no colors, in a field 'rgb' or 'rgba', or in fields 'red', "
                     "'green' and 'blue'; its fields are " +
                     listOfFields(cloud));
}

} // namespace pcl_cid
