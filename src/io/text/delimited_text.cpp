/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Tables of text as spreadsheets write them.
 */

#include "delimited_text.h"

#include "base/sentence.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <utility>

#include <boost/locale/encoding_utf.hpp>

namespace pcl_cid {
namespace {

/** UTF-16 as UTF-8; what is no character is left out. */
std::string
fromUTF16(std::string_view bytes, bool is_big_endian)
{
  std::u16string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto low = static_cast<unsigned char>(bytes[is_big_endian ? i + 1 : i]);
    const auto high = static_cast<unsigned char>(bytes[is_big_endian ? i : i + 1]);
    text += static_cast<char16_t>(low | high << 8);
  }
  return boost::locale::conv::utf_to_utf<char>(text);
}

/** The text in UTF-8, without its byte order mark. */
std::string
decoded(std::string_view text)
{
  const auto begins = [&](std::string_view mark) {
    return text.substr(0, mark.size()) == mark;
  };
  if (begins("\xFF\xFE"))
    return fromUTF16(text.substr(2), false);
  if (begins("\xFE\xFF"))
    return fromUTF16(text.substr(2), true);
  return std::string(begins("\xEF\xBB\xBF") ? text.substr(3) : text);
}

std::string
trimmed(const std::string& cell)
{
  constexpr const char* blanks = " \t";
  const std::size_t begin = cell.find_first_not_of(blanks);
  if (begin == std::string::npos)
    return "";
  return cell.substr(begin, cell.find_last_not_of(blanks) - begin + 1);
}

bool
isLineEnd(char c)
{
  return c == '\r' || c == '\n';
}

/** Reads rows, character by character. */
class TableReading {
public:
  TableReading(std::string_view text, const std::string& name)
  : rest_(text), name_(name)
  {
  }

  TextTable
  table()
  {
    table_.separator = separator();
    while (!rest_.empty())
      takeCell();
    return std::move(table_);
  }

private:
  std::string_view
  firstLine() const
  {
    return rest_.substr(
        0, std::find_if(rest_.begin(), rest_.end(), isLineEnd) - rest_.begin());
  }

  /** The one that the file names, or that its first row has most of. */
  char
  separator()
  {
    constexpr std::string_view key = "sep=";
    while (!rest_.empty() && firstLine().find_first_not_of(" \t") == std::string::npos)
      endLine(firstLine().size());
    std::string_view line = firstLine();
    if (line.size() > key.size() && line.substr(0, key.size()) == key) {
      const char named = line[key.size()];
      endLine(line.size());
      return named;
    }
    char best = ',';
    for (const char candidate : {';', '\t'})
      if (std::count(line.begin(), line.end(), candidate) >
          std::count(line.begin(), line.end(), best))
        best = candidate;
    return best;
  }

  /** A cell and what ends it. */
  void
  takeCell()
  {
    if (row_.cells.empty())
      row_.line = line_;
    const std::size_t begin = rest_.find_first_not_of(" ");
    std::string cell;
    if (begin != std::string::npos && rest_[begin] == '"')
      cell = takeQuoted(begin + 1);
    cell += takePlain();
    row_.cells.push_back(trimmed(cell));
    if (!rest_.empty() && !isLineEnd(rest_.front())) {
      rest_.remove_prefix(1); // a separator
      if (!rest_.empty() && !isLineEnd(rest_.front()))
        return;
      row_.cells.emplace_back();
    }
    endRow();
  }

  std::string
  takePlain()
  {
    const auto end = std::find_if(rest_.begin(), rest_.end(), [this](char c) {
      return isLineEnd(c) || c == table_.separator;
    });
    const auto size = static_cast<std::size_t>(end - rest_.begin());
    std::string text(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return text;
  }

  /** What stands in quotes, of which two mean one. */
  std::string
  takeQuoted(std::size_t begin)
  {
    std::string text;
    for (std::size_t i = begin; i < rest_.size(); ++i) {
      if (rest_[i] == '"' && (i + 1 == rest_.size() || rest_[i + 1] != '"')) {
        rest_.remove_prefix(i + 1);
        return text;
      }
      if (rest_[i] == '"')
        ++i;
      line_ += rest_[i] == '\n' ? 1 : 0;
      text += rest_[i];
    }
    throw CIDException(sentence(name_, ": line ", row_.line, ": quotes do not end"));
  }

  void
  endRow()
  {
    const auto isEmpty = [](const std::string& cell) { return cell.empty(); };
    if (!std::all_of(row_.cells.begin(), row_.cells.end(), isEmpty))
      table_.rows.push_back(std::move(row_));
    row_ = TextRow();
    endLine(0);
  }

  /** Pass the end of a line, which may have several '\r'.
   *  \param[in] size of what is left of the line */
  void
  endLine(std::size_t size)
  {
    rest_.remove_prefix(size);
    const bool is_return = !rest_.empty() && rest_.front() == '\r';
    const std::size_t line_feed = rest_.find_first_not_of('\r');
    if (line_feed != std::string::npos && rest_[line_feed] == '\n')
      rest_.remove_prefix(line_feed + 1);
    else if (is_return)
      rest_.remove_prefix(1);
    ++line_;
  }

  std::string_view rest_;
  const std::string& name_;
  std::size_t line_ = 1;
  TextRow row_{};
  TextTable table_;
};

} // namespace

TextTable
readTextTable(std::string_view text, const std::string& name)
{
  const std::string plain = decoded(text);
  return TableReading(plain, name).table();
}

} // namespace pcl_cid
