/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts of a session in files, as pcl_cid_abstract writes them.
 */

#pragma once

#include "abstract/abstract_settings.h"
#include "exported_files.h"
#include "run/loaded_scan.h"

#include <pcl_cid/core/part_session.h>

#include <string>
#include <vector>

namespace pcl_cid::studio {

/** \brief What shall be written. */
struct PartExport {
  std::string name;                ///< of the files, without folder and extension
  std::string mesh;                ///< extension without the dot: "obj"
  std::vector<std::string> scenes; ///< options of pcl_cid_abstract: "urdf"
  std::string labels;              ///< extension without the dot; empty: none
  bool primitives = false;
  bool report = false;
};

/** \brief Extensions, without the dot, of the formats of meshes that can be read again,
 *  to verify parts in them. */
std::vector<std::string>
partMeshes();

/** \brief Writes the parts of sessions of one scan into one folder. */
class PartExporter {
public:
  /** \param[in] scan,settings must outlive this; settings are those of hulls
   *  \param[in] inputs files that are never written over
   *  \param[in] folder where files go
   *  \param[in] name what they are called where nothing else is asked for */
  PartExporter(const tools::LoadedScan& scan,
               const tools::AbstractSettings& settings,
               std::vector<std::string> inputs,
               std::string folder,
               std::string name);

  /** \brief Write all that is wanted of the parts that are not dropped, or nothing;
   *  guarantees are verified in the files.
   *  \throws CIDException when there is no such format, no part, a guarantee does not
   *  hold, or writing fails */
  ExportedFiles
  write(const PartSession& session, const PartExport& wanted) const;

private:
  tools::AbstractSettings
  settingsFor(const PartExport& wanted) const;

  const tools::LoadedScan& scan_;
  const tools::AbstractSettings& settings_;
  std::vector<std::string> inputs_;
  std::string folder_;
  std::string name_;
};

} // namespace pcl_cid::studio
