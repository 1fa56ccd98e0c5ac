/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The scenes for robot software that parts can be written as, in one table.
 */

#include "scene_rows.h"
#include "text/format_table.h"

#include <utility>

namespace pcl_cid {
namespace {

/** A new format is one more row here. Several may have one extension: the user says
 *  which one by an option. */
FormatTable<SceneFormat, false>&
formatTable()
{
  static FormatTable<SceneFormat, false> table{urdfFormat(),
                                               sdfFormat(),
                                               mjcfFormat(),
                                               moveItFormat(),
                                               gltfFormat(),
                                               usdFormat()};
  return table;
}

} // namespace

std::vector<SceneFormat>
sceneFormats()
{
  return formatTable().all();
}

const SceneFormat*
findSceneFormat(const std::string& name)
{
  return formatTable().named(name);
}

void
registerSceneFormat(SceneFormat format)
{
  if (!format.write)
    throw CIDException("the format " + format.name + " must have a writer");
  if (!format.primitives.empty() && !format.read_primitives)
    throw CIDException("the format " + format.name +
                       " must have a reader of its primitives");
  if (format.option.empty())
    throw CIDException("the format " + format.name + " must have an option");
  for (const SceneFormat& known : sceneFormats())
    if (known.option == format.option)
      throw CIDException("the option of the format " + format.name + ", " +
                         format.option + ", is that of " + known.name);
  formatTable().add(std::move(format));
}

} // namespace pcl_cid
