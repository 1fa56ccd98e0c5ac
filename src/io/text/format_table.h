/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A table of formats, found by name or by the extension of a file.
 */

#pragma once

#include "base/sentence.h"
#include "path_names.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <deque>
#include <initializer_list>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace pcl_cid {

/** \brief Whether a format has an extension.
 *  \param[in] extension in small letters, with the dot */
template <typename Format>
bool
hasExtension(const Format& format, const std::string& extension)
{
  const auto& known = format.extensions;
  return std::find(known.begin(), known.end(), extension) != known.end();
}

/** \brief Rows of a type with a `name` and `extensions` (small letters, with the dot).
 *
 *  Rows are added and never taken away, so a pointer to one stays valid. Any thread may
 *  look up and add.
 *  \tparam extensions_differ whether each extension belongs to one format only, so that
 *  the name of a file says which */
template <typename Format, bool extensions_differ = true>
class FormatTable {
public:
  FormatTable(std::initializer_list<Format> built_in)
  {
    for (const Format& format : built_in)
      add(format);
  }

  /** \throws CIDException when the name is empty or taken, when there is no extension,
   *  or one is taken, or is not in small letters with a dot before them */
  void
  add(Format format)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requireNew(format);
    formats_.push_back(std::move(format));
  }

  std::vector<Format>
  all() const
  {
    std::vector<Format> copies;
    for (const Format* const format : rows())
      copies.push_back(*format);
    return copies;
  }

  /** \brief The first row that fulfils a condition; null when none does. */
  template <typename Condition>
  const Format*
  find(const Condition& condition) const
  {
    for (const Format* const format : rows())
      if (condition(*format))
        return format;
    return nullptr;
  }

  /** \brief The row of this name; null when there is none. */
  const Format*
  named(const std::string& name) const
  {
    return find([&](const Format& format) { return format.name == name; });
  }

  /** \brief The row that has the extension of this file; null when none does. */
  const Format*
  forFile(const std::string& path) const
  {
    const std::string extension = extensionOf(path);
    return find([&](const Format& format) { return hasExtension(format, extension); });
  }

private:
  /** The rows so far; a condition on them may then take its time. */
  std::vector<const Format*>
  rows() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<const Format*> pointers;
    for (const Format& format : formats_)
      pointers.push_back(&format);
    return pointers;
  }

  void
  requireNew(const Format& format) const
  {
    if (format.name.empty() || format.extensions.empty())
      throw CIDException(sentence("the format '",
                                  format.name,
                                  "' must have a name and at least one extension"));
    for (const std::string& extension : format.extensions)
      if (extension.size() < 2 || extensionOf("file" + extension) != extension)
        throw CIDException(sentence("the format ",
                                    format.name,
                                    " has the extension '",
                                    extension,
                                    "'; it must be a dot and small letters"));
    for (const Format& known : formats_) {
      if (known.name == format.name)
        throw CIDException(
            sentence("there is a format named ", format.name, " already"));
      for (const std::string& extension : format.extensions)
        if (extensions_differ && hasExtension(known, extension))
          throw CIDException(sentence("the format ",
                                      format.name,
                                      " cannot have the extension ",
                                      extension,
                                      ", which is that of ",
                                      known.name));
    }
  }

  mutable std::mutex mutex_;
  std::deque<Format> formats_; // rows stay where they are when others are added
};

} // namespace pcl_cid
