/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Command lines: options declared once feed the parser, the checks and the help.
 */

#pragma once

#include <charconv>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <boost/program_options/options_description.hpp>

namespace pcl_cid::tools {

/** \brief The command line is wrong; the message is one sentence. */
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief The numbers that an option takes, and how the user is told. */
template <typename Number>
struct Allowed {
  Number least;
  Number most;
  std::string text;
};

/** \brief ".obj, .ply or .stl". */
std::string
alternatives(const std::vector<std::string>& words);

/** \brief The options of a tool.
 *
 *  Each is bound to a variable, whose value at that time is the default. */
class CommandLine {
public:
  /** \param[in] usage what follows the tool's name, a line for each form
   *  \param[in] about what the tool does */
  CommandLine(std::string tool, std::string usage, std::string about);

  /** \brief Options that follow stand below this headline in the help. */
  void
  group(const std::string& headline);

  void
  flag(const std::string& name, bool& target, const std::string& help);

  /** \brief `--help` and `--version`, which parse() answers. */
  void
  helpOptions();

  void
  text(const std::string& name,
       const std::string& placeholder,
       std::string& target,
       const std::string& help);

  /** \brief One of several words.
   *  \param[in] words the first is the default
   *  \param[out] target number of the word */
  void
  choice(const std::string& name,
         const std::string& placeholder,
         const std::vector<std::string>& words,
         std::size_t& target,
         const std::string& help);

  /** \brief A number with a default. */
  template <typename Number>
  void
  number(const std::string& name,
         const std::string& placeholder,
         const Allowed<Number>& allowed,
         Number& target,
         const std::string& help)
  {
    std::ostringstream with_default;
    with_default << help << "; default " << target;
    option(
        name, placeholder, with_default.str(), [=, &target](const std::string& text) {
          target = parse(name, text, allowed);
        });
  }

  /** \brief A number without a default. */
  template <typename Number>
  void
  optionalNumber(const std::string& name,
                 const std::string& placeholder,
                 const Allowed<Number>& allowed,
                 std::optional<Number>& target,
                 const std::string& help)
  {
    option(name, placeholder, help, [=, &target](const std::string& text) {
      target = parse(name, text, allowed);
    });
  }

  /** \brief Refuse the first option together with any of the others. */
  void
  exclude(const std::string& name, const std::vector<std::string>& others);

  /** \brief Refuse the first option where none of the others is given: it would have no
   *  effect. */
  void
  require(const std::string& name, const std::vector<std::string>& others);

  /** \brief Read a command line, or answer `--help` and `--version`, wherever they
   * stand. \param[out] files what is not an option, exactly as many as asked for
   *  \param[in] names what the user calls them
   *  \return whether there is work to do
   *  \throws UsageError */
  bool
  parse(int argc,
        const char* const* argv,
        std::vector<std::string*> files,
        const std::string& names = "INPUT and OUTPUT");

private:
  using Take = std::function<void(const std::string&)>;

  void
  option(const std::string& name,
         const std::string& placeholder,
         const std::string& help,
         const Take& take);

  void
  checkCombinations(const std::function<bool(const std::string&)>& is_given) const;

  void
  printHelp() const;

  template <typename Number>
  static Number
  parse(const std::string& name,
        const std::string& text,
        const Allowed<Number>& allowed)
  {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || rest != end ||
        !(number >= allowed.least && number <= allowed.most))
      throw UsageError("--" + name + " is '" + text + "'; it must be " + allowed.text);
    return number;
  }

  std::string tool_;
  std::string usage_;
  std::string about_;
  std::vector<boost::program_options::options_description> groups_;
  std::vector<std::pair<std::string, std::string>> exclusive_;
  std::vector<std::pair<std::string, std::vector<std::string>>> requiring_;
};

} // namespace pcl_cid::tools
