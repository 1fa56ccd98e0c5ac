/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a command line takes: from this the parser, the help, the man page and the
 * completion of a shell are made.
 */

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief An option, or a flag: an option without a value. */
struct Option {
  std::string name;                    ///< without dashes
  std::string placeholder;             ///< of the value: "N", "FILE.csv", "cloud|FILE"
  std::string help;                    ///< a sentence without its stop
  std::vector<std::string> words;      ///< that the value may be
  std::vector<std::string> extensions; ///< that a file's name must end in; empty: any
  std::function<void(const std::string&)> take; ///< the value
  bool* flag = nullptr;                         ///< set where the flag is given
  char letter = '\0';                           ///< its short form, if it has one

  bool
  hasValue() const
  {
    return !placeholder.empty();
  }
};

/** \brief Options below a headline of the help. */
struct OptionGroup {
  std::string headline;
  std::vector<Option> options;
};

/** \brief A file, or a folder, that is not an option. */
struct FileArgument {
  std::string name;                    ///< what the user calls it: INPUT
  std::vector<std::string> extensions; ///< in small letters, with the dot
  /** Whether another extension is refused; else it is for the reader to say. */
  bool is_checked = false;
  /** Whether it may be the standard output, "-". */
  bool may_be_stream = false;
};

/** \brief A tool as a user sees it. */
struct ToolDescription {
  std::string tool;
  std::string usage; ///< a line for each form
  std::string about; ///< what it does; lines that begin with a blank are examples
  std::vector<OptionGroup> groups;
  std::vector<FileArgument>
      files; ///< the last one may be repeated where the usage says
  /** The option with which all files are as the first one; empty: there is none. */
  std::string list_option;
};

} // namespace pcl_cid::tools
