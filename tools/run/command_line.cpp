/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Command lines: options declared once feed the parser, the checks, the help, the man
 * page and the completion.
 */

#include "command_line.h"

#include "completion.h"
#include "man_page.h"
#include "words.h"

#include <pcl_cid/version.h>

#include <algorithm>
#include <iostream>

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options/options_description.hpp>
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

/** The options below a headline, as the parser and the help want them. */
po::options_description
parserOf(const OptionGroup& group)
{
  po::options_description options(group.headline);
  for (const Option& option : group.options)
    if (option.hasValue())
      options.add_options()(option.name.c_str(),
                            po::value<std::string>()
                                ->value_name(option.placeholder)
                                ->notifier(option.take),
                            option.help.c_str());
    else {
      std::string name = option.name;
      if (option.letter != '\0')
        name += std::string(",") + option.letter;
      options.add_options()(name.c_str(),
                            option.flag != nullptr ? po::bool_switch(option.flag)
                                                   : po::bool_switch(),
                            option.help.c_str());
    }
  return options;
}

void
printHelp(const ToolDescription& tool)
{
  std::cout << tool.about << "\n\nUsage: ";
  for (const char letter : tool.usage) {
    std::cout << letter;
    if (letter == '\n')
      std::cout << "       ";
  }
  std::cout << '\n';
  for (const OptionGroup& group : tool.groups)
    std::cout << '\n' << parserOf(group);
}

} // namespace

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
{
  tool_.tool = std::move(tool);
  tool_.usage = std::move(usage);
  tool_.about = std::move(about);
}

void
CommandLine::group(const std::string& headline)
{
  tool_.groups.push_back({headline, {}});
}

void
CommandLine::flag(const std::string& name, bool& target, const std::string& help)
{
  option(name, "", help, {});
  tool_.groups.back().options.back().flag = &target;
}

void
CommandLine::paperOption()
{
  option("paper",
         "",
         "as in the paper, but for what is given: each option whose default is another "
         "has the paper's",
         {});
}

void
CommandLine::helpOptions()
{
  option("help", "", "print this and exit", {});
  tool_.groups.back().options.back().letter = 'h';
  option("man-page", "", "print the manual page, for man -l -, and exit", {});
  option("completion",
         "",
         "print what completes this command line in bash, for eval, and exit",
         {});
  option("version", "", "print the version and exit", {});
}

void
CommandLine::option(const std::string& name,
                    const std::string& placeholder,
                    const std::string& help,
                    const Take& take,
                    const std::vector<std::string>& words,
                    const std::vector<std::string>& extensions)
{
  tool_.groups.back().options.push_back(
      {name, placeholder, help, words, extensions, take});
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
CommandLine::file(const std::string& name,
                  const std::string& placeholder,
                  const std::vector<std::string>& extensions,
                  std::string& target,
                  const std::string& help)
{
  const auto take = [=, &target](const std::string& value) {
    requireExtension("--" + name, value, extensions);
    target = value;
  };
  option(name, placeholder, help, take, {}, extensions);
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
         help + (target.empty() ? "" : "; default " + target),
         [&target](const std::string& word) { target = word; });
}

void
CommandLine::choose(const std::string& name,
                    const std::string& placeholder,
                    const std::vector<std::string>& words,
                    const std::string& help,
                    const Take& take)
{
  const auto check_and_take = [=](const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end())
      throw UsageError("--" + name + " is '" + word + "'; it must be " +
                       alternatives(words));
    take(word);
  };
  option(name, placeholder, help, check_and_take, words);
}

void
CommandLine::exclude(const std::string& name,
                     const std::vector<std::string>& others,
                     const std::string& advice)
{
  for (const std::string& other : others)
    exclusive_.push_back({name, other, advice});
}

void
CommandLine::require(const std::string& name, const std::vector<std::string>& others)
{
  requiring_.emplace_back(name, others);
}

bool
CommandLine::parse(int argc,
                   const char* const* argv,
                   const std::vector<FileArgument>& files,
                   const std::vector<std::string*>& targets)
{
  tool_.files = files;
  std::vector<std::string> given;
  if (!read(argc, argv, given))
    return false;
  takeFiles(tool_.files, given, targets);
  return true;
}

bool
CommandLine::parseEither(int argc,
                         const char* const* argv,
                         const std::vector<FileArgument>& files,
                         const std::vector<std::string*>& targets,
                         const std::string& list_option,
                         std::vector<std::string>& list)
{
  tool_.files = files;
  tool_.list_option = list_option;
  std::vector<std::string> given;
  if (!read(argc, argv, given))
    return false;
  if (std::count(given_.begin(), given_.end(), list_option) > 0)
    list = given;
  else
    takeFiles(tool_.files, given, targets, list_option);
  return true;
}

bool
CommandLine::parseList(int argc,
                       const char* const* argv,
                       const FileArgument& file,
                       std::vector<std::string>& given)
{
  tool_.files = {file};
  if (!read(argc, argv, given))
    return false;
  if (given.empty())
    throw UsageError(file.name + " is needed, at least 1 file name; given: 0");
  return true;
}

/** Answer what is asked about the tool itself.
 *  \return whether there was such a question */
bool
CommandLine::answers(int argc, const char* const* argv) const
{
  if (isThere(argc, argv, {"-h", "--help"}))
    printHelp(tool_);
  else if (isThere(argc, argv, {"--version"}))
    std::cout << tool_.tool << ' ' << PCL_CID_VERSION << '\n';
  else if (isThere(argc, argv, {"--man-page"}))
    writeManPage(std::cout, tool_);
  else if (isThere(argc, argv, {"--completion"}))
    writeCompletion(std::cout, tool_);
  else
    return false;
  return true;
}

/** \param[out] given what is not an option
 *  \return whether there is work to do */
bool
CommandLine::read(int argc, const char* const* argv, std::vector<std::string>& given)
{
  if (answers(argc, argv))
    return false;
  po::options_description known;
  for (const OptionGroup& group : tool_.groups)
    known.add(parserOf(group));
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
  for (const auto& [name, value] : values)
    if (!value.defaulted())
      given_.push_back(name);
  checkCombinations([&](const std::string& name) {
    return std::count(given_.begin(), given_.end(), name) > 0;
  });
  return true;
}

void
CommandLine::checkCombinations(
    const std::function<bool(const std::string&)>& is_given) const
{
  for (const auto& [name, other, advice] : exclusive_)
    if (is_given(name) && is_given(other))
      throw UsageError("--" + name + " and --" + other + " exclude each other; " +
                       advice);
  for (const auto& [name, others] : requiring_) {
    if (!is_given(name) || std::any_of(others.begin(), others.end(), is_given))
      continue;
    std::vector<std::string> missing;
    for (const std::string& other : others)
      missing.push_back("--" + other);
    throw UsageError("--" + name + " has no effect without " + alternatives(missing));
  }
}

} // namespace pcl_cid::tools
