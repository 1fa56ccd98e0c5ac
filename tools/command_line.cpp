/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Command lines: options declared once feed the parser, the checks and the help.
 */

#include "command_line.h"

#include <pcl_cid/version.h>

#include <algorithm>
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

} // namespace

std::string
alternatives(const std::vector<std::string>& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
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
CommandLine::choice(const std::string& name,
                    const std::string& placeholder,
                    const std::vector<std::string>& words,
                    std::size_t& target,
                    const std::string& help)
{
  target = 0;
  const std::string with_default = help + "; default " + words.front();
  option(name, placeholder, with_default, [=, &target](const std::string& value) {
    const auto word = std::find(words.begin(), words.end(), value);
    if (word == words.end())
      throw UsageError("--" + name + " is '" + value + "'; it must be " +
                       alternatives(words));
    target = static_cast<std::size_t>(word - words.begin());
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
  std::vector<std::string> given;
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
    po::notify(values);
  }
  catch (const po::error& error) {
    throw UsageError(error.what());
  }
  checkCombinations([&](const std::string& name) { return values.count(name) != 0; });
  if (given.size() != files.size())
    throw UsageError(names + " are needed, " + std::to_string(files.size()) +
                     " file names; given: " + std::to_string(given.size()));
  for (std::size_t i = 0; i < files.size(); ++i)
    *files[i] = given[i];
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
