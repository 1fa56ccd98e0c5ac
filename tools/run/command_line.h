/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Command lines: options declared once feed the parser, the checks, the help, the man
 * page and the completion.
 */

#pragma once

#include "file_arguments.h"
#include "tool_description.h"

#include <pcl_cid/core/settings.h>

#include <charconv>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pcl_cid::tools {

/** \brief The command line is wrong; the message is one sentence. */
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief The name of a row as an option: "start-index" for "start_index". */
std::string
optionName(const std::string& row);

template <typename Row>
std::string
optionName(const Row& row)
{
  return optionName(std::string(row.name));
}

/** \brief The options of all settings in a group of the table. */
std::vector<std::string>
optionsOf(const std::string& group);

/** \brief The options of a tool.
 *
 *  Each is bound to a variable, whose value at that time is the default. Name, limits
 *  and help of a setting come from its row in the table (see settings.h). */
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

  /** \brief `--paper`: what is not the paper's by default becomes so, but for what is
   *  given. */
  void
  paperOption();

  /** \brief `--help`, `--version` and what else is printed about the tool, which
   *  parse() answers. */
  void
  helpOptions();

  void
  text(const std::string& name,
       const std::string& placeholder,
       std::string& target,
       const std::string& help);

  /** \brief A file whose name must end in one of some extensions. */
  void
  file(const std::string& name,
       const std::string& placeholder,
       const std::vector<std::string>& extensions,
       std::string& target,
       const std::string& help);

  /** \brief One of several words. */
  void
  word(const std::string& name,
       const std::string& placeholder,
       const std::vector<std::string>& words,
       std::string& target,
       const std::string& help);

  /** \brief A number.
   *  \param[in] note what there is to say about it in this tool, for the help */
  template <typename Value, typename Number>
  void
  setting(const NumberSetting<Value>& row, Number& target, const std::string& note = "")
  {
    std::ostringstream with_default;
    with_default << helpOf(row, note);
    if (row.zero)
      with_default << "; 0 " << row.zero;
    with_default << "; default " << target;
    asInPaper(row, target);
    option(
        optionName(row),
        row.placeholder,
        with_default.str(),
        [=, &target](const std::string& text) { target = parse<Number>(row, text); });
  }

  /** \brief A number that is left out where another setting would be 0: it cannot be
   *  given as 0 unless that is in its range. */
  template <typename Value, typename Number>
  void
  optional(const NumberSetting<Value>& row,
           std::optional<Number>& target,
           const std::string& note = "")
  {
    option(optionName(row),
           row.placeholder,
           helpOf(row, note),
           [row = row.withoutZero(), &target](const std::string& text) {
             target = parse<Number>(row, text);
           });
  }

  /** \brief The same, or a word in the place of the number. */
  template <typename Value, typename Number>
  void
  optional(const NumberSetting<Value>& row,
           std::optional<Number>& target,
           const std::string& word,
           bool& is_word,
           const std::string& note)
  {
    option(optionName(row),
           row.placeholder,
           helpOf(row, note),
           [=, row = row.withoutZero(), &target, &is_word](const std::string& text) {
             is_word = text == word;
             if (!is_word)
               target = parse<Number>(row, text, ", or '" + word + "'");
           },
           {word});
  }

  /** \brief One of the words of a row. */
  template <typename Value, std::size_t Count>
  void
  choice(const ChoiceSetting<Value, Count>& row, Value& target)
  {
    asInPaper(row, target);
    choose(row, target, std::string("default ") + row.wordOf(target));
  }

  /** \brief The same, left out where other options decide. */
  template <typename Value, std::size_t Count>
  void
  choice(const ChoiceSetting<Value, Count>& row,
         std::optional<Value>& target,
         const std::string& note)
  {
    asInPaper(row, target);
    choose(row, target, note);
  }

  /** \brief Refuse the first option together with any of the others.
   *  \param[in] advice ends the message */
  void
  exclude(const std::string& name,
          const std::vector<std::string>& others,
          const std::string& advice = "give one of them");

  /** \brief Refuse the first option where none of the others is given: it would have no
   *  effect. */
  void
  require(const std::string& name, const std::vector<std::string>& others);

  /** \brief Read a command line, or answer `--help` and the like, wherever they stand.
   *  \param[in] files what is not an option, exactly as many as asked for
   *  \param[out] targets their names
   *  \return whether there is work to do
   *  \throws UsageError */
  bool
  parse(int argc,
        const char* const* argv,
        const std::vector<FileArgument>& files,
        const std::vector<std::string*>& targets);

  /** \brief The same, or any number of files of the first kind where an option is
   *  given.
   *  \param[in] list_option without dashes
   *  \param[out] list set instead of the targets where it is given */
  bool
  parseEither(int argc,
              const char* const* argv,
              const std::vector<FileArgument>& files,
              const std::vector<std::string*>& targets,
              const std::string& list_option,
              std::vector<std::string>& list);

  /** \brief The same for any number of files of one kind, at least one. */
  bool
  parseList(int argc,
            const char* const* argv,
            const FileArgument& file,
            std::vector<std::string>& given);

private:
  using Take = std::function<void(const std::string&)>;

  bool
  read(int argc, const char* const* argv, std::vector<std::string>& given);

  bool
  answers(int argc, const char* const* argv) const;

  void
  option(const std::string& name,
         const std::string& placeholder,
         const std::string& help,
         const Take& take,
         const std::vector<std::string>& words = {},
         const std::vector<std::string>& extensions = {});

  template <typename Row, typename Target>
  void
  asInPaper(const Row& row, Target& target)
  {
    if (row.in_paper)
      set_paper_.push_back([row, &target] { target = row.paper(); });
  }

  template <typename Value, std::size_t Count, typename Target>
  void
  choose(const ChoiceSetting<Value, Count>& row,
         Target& target,
         const std::string& note)
  {
    std::vector<std::string> words;
    for (const auto& each : row.words)
      words.emplace_back(each.word);
    choose(optionName(row),
           row.placeholder,
           words,
           std::string(row.meaning) + "; " + note,
           [=, &target](const std::string& word) { target = *row.valueOf(word); });
  }

  /** An option that takes one of the words and nothing else. */
  void
  choose(const std::string& name,
         const std::string& placeholder,
         const std::vector<std::string>& words,
         const std::string& help,
         const Take& take);

  void
  checkCombinations(const std::function<bool(const std::string&)>& is_given) const;

  /** "grow hulls outward by this, metres; the note". */
  template <typename Value>
  static std::string
  helpOf(const NumberSetting<Value>& row, const std::string& note)
  {
    std::string help = row.meaning;
    if (*row.unit)
      help += std::string(", ") + row.unit;
    return note.empty() ? help : help + "; " + note;
  }

  template <typename Number, typename Value>
  static Number
  parse(const NumberSetting<Value>& row,
        const std::string& text,
        const std::string& or_else = "")
  {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || rest != end || !row.allows(number))
      throw UsageError("--" + optionName(row) + " is '" + text + "'; it must be " +
                       rangeOf(row) + or_else);
    return number;
  }

  ToolDescription tool_;
  std::vector<std::function<void()>> set_paper_; ///< for each row that has `in_paper`
  std::vector<std::string> given_; ///< names of the options that are given
  /** Two options that exclude each other, and what to say of it. */
  struct Exclusion {
    std::string name;
    std::string other;
    std::string advice;
  };
  std::vector<Exclusion> exclusive_;
  std::vector<std::pair<std::string, std::vector<std::string>>> requiring_;
};

} // namespace pcl_cid::tools
