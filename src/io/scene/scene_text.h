/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the writers of scenes share: numbers, colors and names as text.
 */

#pragma once

#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/io/scene_export.h>

#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

namespace pcl_cid {

constexpr const char* xml_declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/** \brief Numbers with a space between them. */
std::string
numbers(std::initializer_list<double> values);

std::string
numbers(const Eigen::Vector3d& v);

/** \brief The color of a part: red, green, blue, opacity, each 0 to 1. */
std::string
rgba(std::size_t part);

/** \brief The same color as light of a screen mixes it: red, green, blue, linear, each
 *  0 to 1, to six places. */
Eigen::Vector3d
linearColor(std::size_t part);

/** \brief Refuse a name that is empty or cannot be written.
 *  \param[in] what the user calls it: "the frame"
 *  \throws CIDException */
void
requireName(const char* what, const std::string& name);

/** \brief For the content of XML elements and for attributes in double quotes. */
std::string
escaped(const std::string& text);

/** \brief The primitive that is written in the place of a part's mesh; null: the mesh
 *  is.
 *  \param[in] kinds that the format knows */
const HullPrimitive*
primitiveOf(std::size_t part,
            const SceneDescription& scene,
            const std::vector<HullPrimitive::Kind>& kinds);

/** \brief Box, sphere and cylinder, which all formats know. */
std::vector<HullPrimitive::Kind>
kindsWithoutCapsule();

/** \brief All of them. */
std::vector<HullPrimitive::Kind>
allKinds();

/** \brief Angles about the fixed axes x, y and z, applied in this order. */
std::string
rollPitchYaw(const Eigen::Matrix3d& axes);

/** \brief Where the file of a scene finds the mesh of a part, for XML. */
std::string
meshReference(std::size_t part, const SceneDescription& scene);

} // namespace pcl_cid
