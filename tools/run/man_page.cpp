/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The manual page of a tool.
 */

#include "man_page.h"

#include <pcl_cid/version.h>

#include <cctype>
#include <ostream>
#include <sstream>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>

namespace pcl_cid::tools {
namespace {

/** Text as roff shows it: hyphens stay what one types, `words` are bold, and no line is
 *  a request by mistake. */
std::string
roff(const std::string& text)
{
  std::string result;
  bool is_bold = false;
  for (const char letter : text) {
    if (letter == '\\')
      result += "\\e";
    else if (letter == '-')
      result += "\\-";
    else if (letter == '`')
      result += (is_bold = !is_bold) ? "\\fB" : "\\fR";
    else
      result += letter;
  }
  if (result.rfind('.', 0) == 0 || result.rfind('\'', 0) == 0)
    result.insert(0, "\\&");
  return result;
}

/** "Label every point. INPUT is ..." -> "label every point". */
std::string
summaryOf(const std::string& about)
{
  std::string summary = about.substr(0, about.find(". "));
  summary = summary.substr(0, summary.find(".\n"));
  boost::algorithm::replace_all(summary, "\n", " ");
  summary.front() =
      static_cast<char>(std::tolower(static_cast<unsigned char>(summary.front())));
  return summary;
}

void
writeTitle(std::ostream& stream, const ToolDescription& tool)
{
  stream << ".TH " << boost::algorithm::to_upper_copy(tool.tool)
         << " 1 \"\" \"pcl_cid " PCL_CID_VERSION "\" \"User Commands\"\n"
         << ".SH NAME\n"
         << roff(tool.tool) << " \\- " << roff(summaryOf(tool.about)) << '\n';
}

void
writeSynopsis(std::ostream& stream, const ToolDescription& tool)
{
  stream << ".SH SYNOPSIS\n";
  std::istringstream forms(tool.usage);
  for (std::string form; std::getline(forms, form);) {
    const std::size_t end = form.find(' ');
    stream << "\\fB" << roff(form.substr(0, end)) << "\\fR"
           << (end == std::string::npos ? "" : roff(form.substr(end))) << "\n.br\n";
  }
}

/** Lines that begin with a blank are as they are; the others flow. */
void
writeDescription(std::ostream& stream, const ToolDescription& tool)
{
  stream << ".SH DESCRIPTION\n";
  std::istringstream lines(tool.about);
  bool is_example = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      stream << (is_example ? ".EE\n.PP\n" : ".PP\n");
      is_example = false;
      continue;
    }
    if (line.front() == ' ' && !is_example) {
      stream << ".EX\n";
      is_example = true;
    }
    stream << roff(line) << '\n';
  }
  if (is_example)
    stream << ".EE\n";
}

void
writeOption(std::ostream& stream, const Option& option)
{
  stream << ".TP\n\\fB";
  if (option.letter != '\0')
    stream << "\\-" << option.letter << "\\fR, \\fB";
  stream << roff("--" + option.name) << "\\fR";
  if (option.hasValue())
    stream << " \\fI" << roff(option.placeholder) << "\\fR";
  stream << '\n' << roff(option.help) << ".\n";
}

void
writeOptionSections(std::ostream& stream, const ToolDescription& tool)
{
  stream << ".SH OPTIONS\n";
  for (const OptionGroup& group : tool.groups) {
    stream << ".SS " << roff(group.headline) << '\n';
    for (const Option& option : group.options)
      writeOption(stream, option);
  }
}

void
writeEnd(std::ostream& stream, const ToolDescription& tool)
{
  stream << ".SH EXIT STATUS\n"
         << ".TP\n0\nAll is done.\n"
         << ".TP\n1\nSomething is wrong with a file or a value; a line on standard "
            "error says what.\n"
         << ".TP\n2\nThe command line is wrong.\n"
         << ".TP\n128 + N\nStopped by signal N before the work was done.\n"
         << ".SH SEE ALSO\n";
  const char* separator = "";
  for (const char* const other : {"pcl_cid_abstract",
                                  "pcl_cid_evaluate",
                                  "pcl_cid_segment",
                                  "pcl_cid_simulate",
                                  "pcl_cid_studio"})
    if (tool.tool != other) {
      stream << separator << "\\fB" << other << "\\fR(1)";
      separator = ", ";
    }
  stream << "\n.PP\nWang et al., \"Concavity\\-Induced Distance for Unoriented Point "
            "Cloud "
            "Decomposition\", IEEE Robotics and Automation Letters, 2023.\n";
}

} // namespace

void
writeManPage(std::ostream& stream, const ToolDescription& tool)
{
  writeTitle(stream, tool);
  writeSynopsis(stream, tool);
  writeDescription(stream, tool);
  writeOptionSections(stream, tool);
  writeEnd(stream, tool);
}

} // namespace pcl_cid::tools
