/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Command lines: options declared once feed the parser, the checks and the help.
 */

#include "command_line.h"

#include "words.h"

#include <pcl_cid/version.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>

#include <boost/program_options/parsers.hpp>
#include <boost/program_options/positional_options.hpp>
#include <boost/program_options/variables_map.hpp>

namespace pcl_cid::tools {
namespace {

namespace po = boost::program_options;

bool
isThere(int argc, const char* const* argv, const std::vector<std::string>& names)
{
  for (int i = 1; i < argc; ++i)
    for (const std::string& name : names)
      if (argv[i] == name)
        return true;
  return false;
}

/** In small letters, with the dot. */
std::string
extensionOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& letter : extension)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

} // namespace

void
requireExtension(const std::string& name,
                 const std::string& path,
                 const std::vector<std::string>& extensions)
{
  if (std::find(extensions.begin(), extensions.end(), extensionOf(path)) ==
      extensions.end())
    throw UsageError(name + " is '" + path + "'; its name must end in " +
                     alternatives(extensions));
}

std::string
optionName(const std::string& row)
{
  std::string name = row;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::vector<std::string>
optionsOf(const std::string& group)
{
  std::vector<std::string> options;
  forEachSetting([&](const auto& row) {
    if (row.group == group)
      options.push_back(optionName(row));
  });
  return options;
}

CommandLine::CommandLine(std::string tool, std::string usage, std::string about)
: tool_(std::move(tool)), usage_(std::move(usage)), about_(std::move(about))
{
}

void
CommandLine::group(const std::string& headline)
{
  groups_.emplace_back(headline);
}

void
CommandLine::flag(const std::string& name, bool& target, const std::string& help)
{
  groups_.back().add_options()(name.c_str(), po::bool_switch(&target), help.c_str());
}

void
CommandLine::paperOption()
{
  groups_.back().add_options()(
      "paper",
      po::bool_switch(),
      "as in the paper, but for what is given: each option whose default is another "
      "has the paper's");
}

void
CommandLine::helpOptions()
{
  groups_.back().add_options()("help,h", po::bool_switch(), "print this and exit")(
      "version", po::bool_switch(), "print the version and exit");
}

void
CommandLine::option(const std::string& name,
                    const std::string& placeholder,
                    const std::string& help,
                    const Take& take)
{
  groups_.back().add_options()(
      name.c_str(),
      po::value<std::string>()->value_name(placeholder)->notifier(take),
      help.c_str());
}

void
CommandLine::text(const std::string& name,
                  const std::string& placeholder,
                  std::string& target,
                  const std::string& help)
{
  option(name, placeholder, help, [=, &target](const std::string& value) {
    if (value.empty())
      throw UsageError("--" + name + " is empty; it must be " + placeholder);
    target = value;
  });
}

void
CommandLine::word(const std::string& name,
                  const std::string& placeholder,
                  const std::vector<std::string>& words,
                  std::string& target,
                  const std::string& help)
{
  choose(name,
         placeholder,
         words,
         help + "; default " + target,
         [&target](const std::string& word) { target = word; });
}

void
CommandLine::choose(const std::string& name,
                    const std::string& placeholder,
                    const std::vector<std::string>& words,
                    const std::string& help,
                    const Take& take)
{
  option(name, placeholder, help, [=](const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end())
      throw UsageError("--" + name + " is '" + word + "'; it must be " +
                       alternatives(words));
    take(word);
  });
}

void
CommandLine::exclude(const std::string& name, const std::vector<std::string>& others)
{
  for (const std::string& other : others)
    exclusive_.emplace_back(name, other);
}

void
CommandLine::require(const std::string& name, const std::vector<std::string>& others)
{
  requiring_.emplace_back(name, others);
}

bool
CommandLine::parse(int argc,
                   const char* const* argv,
                   std::vector<std::string*> files,
                   const std::string& names)
{
  std::vector<std::string> given;
  if (!read(argc, argv, given))
    return false;
  if (given.size() != files.size())
    throw UsageError(names + " are needed, " + std::to_string(files.size()) +
                     " file names; given: " + std::to_string(given.size()));
  for (std::size_t i = 0; i < files.size(); ++i)
    *files[i] = given[i];
  return true;
}

bool
CommandLine::parseList(int argc,
                       const char* const* argv,
                       std::vector<std::string>& files,
                       const std::string& name)
{
  if (!read(argc, argv, files))
    return false;
  if (files.empty())
    throw UsageError(name + " is needed, at least 1 file name; given: 0");
  return true;
}

/** \param[out] given what is not an option
 *  \return whether there is work to do */
bool
CommandLine::read(int argc, const char* const* argv, std::vector<std::string>& given)
{
  if (isThere(argc, argv, {"-h", "--help"})) {
    printHelp();
    return false;
  }
  if (isThere(argc, argv, {"--version"})) {
    std::cout << tool_ << ' ' << PCL_CID_VERSION << '\n';
    return false;
  }
  po::options_description known;
  for (const po::options_description& group : groups_)
    known.add(group);
  known.add_options()("file", po::value<std::vector<std::string>>(&given));
  po::variables_map values;
  try {
    constexpr int style =
        po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv)
                  .options(known)
                  .positional(po::positional_options_description().add("file", -1))
                  .style(style)
                  .run(),
              values);
    // Before what is given, which po::notify() takes.
    if (values.count("paper") != 0 && values["paper"].as<bool>())
      for (const auto& set : set_paper_)
        set();
    po::notify(values);
  }
  catch (const po::error& error) {
    throw UsageError(error.what());
  }
  // Flags that are not given have a value, too.
  checkCombinations([&](const std::string& name) {
    return values.count(name) != 0 && !values[name].defaulted();
  });
  return true;
}

void
CommandLine::checkCombinations(
    const std::function<bool(const std::string&)>& is_given) const
{
  for (const auto& [name, other] : exclusive_)
    if (is_given(name) && is_given(other))
      throw UsageError("--" + name + " and --" + other +
                       " exclude each other; give one of them");
  for (const auto& [name, others] : requiring_) {
    if (!is_given(name) || std::any_of(others.begin(), others.end(), is_given))
      continue;
    std::vector<std::string> missing;
    for (const std::string& other : others)
      missing.push_back("--" + other);
    throw UsageError("--" + name + " has no effect without " + alternatives(missing));
  }
}

void
CommandLine::printHelp() const
{
  std::cout << about_ << "\n\nUsage: ";
  for (const char letter : usage_) {
    std::cout << letter;
    if (letter == '\n')
      std::cout << "       ";
  }
  std::cout << '\n';
  for (const po::options_description& group : groups_)
    std::cout << '\n' << group;
}

} // namespace pcl_cid::tools
