/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Completion of a tool's command line in bash.
 */

#include "completion.h"

#include <algorithm>
#include <cctype>
#include <ostream>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/split.hpp>

namespace pcl_cid::tools {
namespace {

using boost::algorithm::join;

/** What may stand in a place of the command line. */
struct Candidates {
  std::vector<std::string> words;
  std::vector<std::string> extensions; ///< of files
  bool any_file = false;
  bool folders = false;
};

/** The parts of a placeholder like "s3dis|scannet|FILE". */
Candidates
candidatesFor(const Option& option)
{
  Candidates candidates;
  candidates.words = option.words;
  std::vector<std::string> parts;
  boost::algorithm::split(parts, option.placeholder, boost::is_any_of("|"));
  for (const std::string& part : parts) {
    if (std::islower(static_cast<unsigned char>(part.front())) != 0)
      candidates.words.push_back(part);
    if (part == "DIR" || part == "FOLDER")
      candidates.folders = true;
    if (part.rfind("FILE", 0) != 0)
      continue;
    candidates.folders = true; // on the way to the file
    candidates.extensions = option.extensions;
    if (candidates.extensions.empty() && part != "FILE")
      candidates.extensions.push_back(part.substr(part.find('.')));
    candidates.any_file = candidates.extensions.empty();
  }
  return candidates;
}

Candidates
candidatesFor(const FileArgument& file)
{
  return {{}, file.extensions, file.extensions.empty(), true};
}

/** ".pcd" in small and in capital letters: "[.][pP][cC][dD]". */
std::string
patternOf(const std::string& extension)
{
  std::string pattern;
  for (const char letter : extension) {
    const auto code = static_cast<unsigned char>(letter);
    pattern += '[';
    pattern += static_cast<char>(std::tolower(code));
    if (std::isalpha(code) != 0)
      pattern += static_cast<char>(std::toupper(code));
    pattern += ']';
  }
  return pattern;
}

/** The statements that fill COMPREPLY, on one line. */
std::string
replyOf(const Candidates& candidates)
{
  std::vector<std::string> sources;
  const auto add = [&](const std::string& options) {
    sources.push_back("compgen " + options + " -- \"$word\"");
  };
  if (!candidates.words.empty())
    add("-W '" + join(candidates.words, " ") + "'");
  if (candidates.any_file)
    add("-f");
  for (const std::string& extension : candidates.extensions)
    add("-f -X '!*" + patternOf(extension) + "'");
  if (candidates.folders && !candidates.any_file)
    add("-d");
  if (sources.empty())
    return ":"; // a number: there is nothing to offer
  const bool names_files = candidates.any_file || candidates.folders;
  return (names_files ? "compopt -o filenames 2> /dev/null; " : "") +
         ("mapfile -t COMPREPLY < <(" + join(sources, "; ") + ")");
}

void
writeOptionValues(std::ostream& stream, const ToolDescription& tool)
{
  stream << "  case $option in\n";
  for (const OptionGroup& group : tool.groups)
    for (const Option& option : group.options)
      if (option.hasValue())
        stream << "    --" << option.name << ") " << replyOf(candidatesFor(option))
               << "; return ;;\n";
  stream << "  esac\n";
}

void
writeOptionNames(std::ostream& stream, const ToolDescription& tool)
{
  std::vector<std::string> options;
  for (const OptionGroup& group : tool.groups)
    for (const Option& option : group.options)
      options.push_back("--" + option.name);
  stream << "  if [[ $word == -* ]]; then\n"
         << "    mapfile -t COMPREPLY < <(compgen -W '" << join(options, " ")
         << "' -- \"$word\")\n"
         << "    return\n"
         << "  fi\n";
}

/** What may stand first, second, ...; the last one may be repeated. Where it is not
 * said yet whether files are a list, a later one may be as the first one, too. */
std::vector<FileArgument>
filePlaces(const ToolDescription& tool)
{
  std::vector<FileArgument> places = tool.files;
  if (tool.list_option.empty())
    return places;
  const FileArgument& first = tool.files.front();
  for (std::size_t k = 1; k < places.size(); ++k)
    for (const std::string& extension : first.extensions)
      if (std::find(places[k].extensions.begin(),
                    places[k].extensions.end(),
                    extension) == places[k].extensions.end())
        places[k].extensions.push_back(extension);
  places.push_back(first);
  return places;
}

/** How many files stand before the word says which of them it is. */
void
writeFileNames(std::ostream& stream, const ToolDescription& tool)
{
  std::vector<std::string> with_value;
  for (const OptionGroup& group : tool.groups)
    for (const Option& option : group.options)
      if (option.hasValue())
        with_value.push_back("--" + option.name);
  stream << "  local i files=0\n"
         << "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
         << "    case ${COMP_WORDS[i]} in\n"
         << "      " << join(with_value, "|")
         << ") [[ ${COMP_WORDS[i + 1]} == = ]] && ((i += 2)) || ((++i)) ;;\n"
         << "      -*) ;;\n"
         << "      *) ((++files)) ;;\n"
         << "    esac\n"
         << "  done\n";
  if (!tool.list_option.empty())
    stream << "  [[ \" ${COMP_WORDS[*]} \" == *\" --" << tool.list_option
           << " \"* ]] && files=0\n";
  stream << "  case $files in\n";
  const std::vector<FileArgument> places = filePlaces(tool);
  for (std::size_t k = 0; k < places.size(); ++k)
    stream << "    " << (k + 1 < places.size() ? std::to_string(k) : "*") << ") "
           << replyOf(candidatesFor(places[k])) << " ;;\n";
  stream << "  esac\n";
}

} // namespace

void
writeCompletion(std::ostream& stream, const ToolDescription& tool)
{
  const std::string function = "_" + tool.tool;
  stream
      << "# Completion of " << tool.tool << " in bash.\n\n"
      << function << "() {\n"
      << "  local word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]}\n"
      << "  COMPREPLY=()\n"
      << "  # bash cuts --option=value into three words.\n"
      << "  if [[ $word == = ]]; then\n"
      << "    word=\n"
      << "  elif [[ $option == = ]]; then\n"
      << "    option=${COMP_WORDS[COMP_CWORD - 2]}\n"
      << "  fi\n";
  writeOptionValues(stream, tool);
  writeOptionNames(stream, tool);
  if (!tool.files.empty())
    writeFileNames(stream, tool);
  stream << "} && complete -F " << function << ' ' << tool.tool << '\n';
}

} // namespace pcl_cid::tools
