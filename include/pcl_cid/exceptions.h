/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the library throws.
 */

#pragma once

#include <pcl_cid/pcl_cid_export.h>

#include <string>

#include <pcl/exceptions.h>

namespace pcl_cid {

/** \brief A bad setting or an unusable input. The message is one sentence: which value
 *  or file, what is wrong with it, what is allowed. When it is thrown, outputs are
 *  empty and no file is left behind. */
class PCL_CID_EXPORT CIDException : public pcl::PCLException {
public:
  explicit CIDException(const std::string& message)
  : pcl::PCLException(message), message_(message)
  {
  }

  /** \brief The sentence alone; pcl::PCLException would put ": " before it. */
  const char*
  what() const noexcept override
  {
    return message_.c_str();
  }

private:
  std::string message_;
};

/** \brief The progress callback asked to stop. Outputs are empty; the object can be
 *  used again. */
class PCL_CID_EXPORT CIDCancelled : public CIDException {
public:
  CIDCancelled() : CIDException("cancelled by the progress callback") {}
};

} // namespace pcl_cid
