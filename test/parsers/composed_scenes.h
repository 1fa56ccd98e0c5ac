/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Two scenes that are loaded together, for other people's parsers.
 */

#pragma once

#include "cloud_files.h"
#include "part_scenes.h"

#include <pcl_cid/io/scene_export.h>

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {

/** \brief Two scenes with a name each: NAME.urdf, NAME.sdf and NAME.xml in the folder
 *  "scenes", all meshes in the folder "meshes" beside it. */
class ComposedScenes {
public:
  struct Member {
    PartScene content;
    SceneDescription description;

    const std::vector<ConvexPart>&
    parts() const
    {
      return content.parts;
    }

    std::string
    partName(std::size_t part) const;
  };

  /** \param[in] mesh_folder what the scenes say; empty: its absolute path
   *  \param[in] extension of the meshes */
  ComposedScenes(const PartScene& first,
                 const PartScene& second,
                 const std::string& mesh_folder,
                 const std::string& extension = ".obj",
                 const std::array<std::string, 2>& names = {"hall", "kitchen"});

  const std::vector<Member>&
  members() const
  {
    return members_;
  }

  std::size_t
  numberOfParts() const
  {
    return members_[0].parts().size() + members_[1].parts().size();
  }

  /** \brief Path of a file beside the two folders. */
  std::string
  file(const std::string& name) const
  {
    return folder_.file(name);
  }

private:
  void
  write(const Member& member) const;

  TemporaryFolder folder_;
  std::vector<Member> members_;
};

/** \brief Call \a check with two different scans, also where their frames are far from
 *  each other, and with the same scan twice.
 *  \param[in] mesh_folder as for ComposedScenes */
template <typename Check>
void
forEachComposition(const std::string& mesh_folder, const Check& check)
{
  const PartScene near = thinParts(Eigen::Vector3d::Zero());
  for (const PartScene& other : {near, thinParts(utmOffset()), roomParts()})
    for (const std::string extension : {".obj", ".stl"}) {
      SCOPED_TRACE(other.name + " as " + extension);
      check(ComposedScenes(near, other, mesh_folder, extension));
    }
}

} // namespace pcl_cid::test
