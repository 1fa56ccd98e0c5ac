/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A session on the disk: what was done, action by action.
 */

#include <pcl_cid/io/session_file.h>

#include "action_json.h"
#include "outputs/hidden_files.h"
#include "settings_json.h"

#include <pcl_cid/io/cloud_points.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <boost/crc.hpp>

#include <fcntl.h>
#include <unistd.h>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

/** CRC-64 as in ECMA-182. */
using Checksum =
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693u, 0xFFFFFFFFFFFFFFFFu, 0, true, true>;

[[noreturn]] void
fail(const std::string& path, const std::string& doing, int reason)
{
  throw CIDException(path + ": cannot " + doing + ": " +
                     std::generic_category().message(reason));
}

/** The whole lines of a text, and where each ends. */
struct Lines {
  std::vector<std::string> texts;
  std::vector<std::size_t> ends;

  explicit Lines(const std::string& text)
  {
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos;) {
      texts.push_back(text.substr(begin, end - begin));
      begin = end + 1;
      ends.push_back(begin);
    }
  }
};

/** What is wrong with a line that cannot be done. */
CIDException
impossible(const std::string& path, std::size_t line, const CIDException& error)
{
  return CIDException(path + ": line " + std::to_string(line) + ": " + error.what());
}

void
addLine(const nlohmann::json& json, std::size_t line, SessionRecord& record)
{
  if (const std::optional<PartAction> on_parts = partActionFrom(json)) {
    record.part_actions.push_back(*on_parts);
    record.part_lines.push_back(line);
    return;
  }
  record.actions.push_back(actionFrom(json));
  record.lines.push_back(line);
}

/** \throws CIDException with file and line */
SessionRecord
recordOf(const Lines& lines, const std::string& path)
{
  SessionRecord record;
  for (std::size_t k = 0; k < lines.texts.size(); ++k)
    try {
      const auto json = nlohmann::json::parse(lines.texts[k]);
      if (k == 0)
        record = recordFrom(json);
      else
        addLine(json, k + 1, record);
    }
    catch (const nlohmann::json::exception&) {
      throw CIDException(path + ": line " + std::to_string(k + 1) + " is not JSON");
    }
    catch (const CIDException& error) {
      throw impossible(path, k + 1, error);
    }
  return record;
}

std::string
lineOf(const nlohmann::ordered_json& json)
{
  try {
    return json.dump() + "\n";
  }
  catch (const nlohmann::json::exception&) {
    throw CIDException("a class or a name is not UTF-8 text; give it another one");
  }
}

/** A text without a whole line: of a session that was hardly begun, or of something
 *  else. */
void
requireTornHeader(const std::string& text, const std::string& path)
{
  if (!text.empty() && text.front() != '{')
    throw CIDException(path + ": it is not a session of pcl_cid");
}

/** The file itself, where the path is a link to one. */
std::string
resolved(const std::string& path)
{
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target.string();
}

/** Let the name of a file reach the disk. */
void
synchronizeFolderOf(const std::string& path)
{
  if (const int reason = synchronize(fs::absolute(resolved(path)).parent_path()))
    fail(path, "be written", reason);
}

} // namespace

ScanIdentity
identityOf(const LabelledCloud& cloud)
{
  ScanIdentity identity{fs::path(cloud.name).filename().string(), cloud.size(), 0};
  const FileCoordinates coordinates(cloud);
  Checksum checksum;
  for (std::size_t i = 0; i < identity.points; ++i) {
    Eigen::Vector3d position = coordinates[i];
    if (!position.allFinite())
      position.setConstant(std::numeric_limits<double>::infinity());
    position += Eigen::Vector3d::Zero(); // -0 is 0
    checksum.process_bytes(position.data(), sizeof(double) * 3);
  }
  identity.checksum = checksum.checksum();
  return identity;
}

std::optional<SessionRecord>
findSession(const std::string& path)
{
  const OpenFile file(resolved(path), O_RDONLY);
  if (file.get() < 0 && errno == ENOENT)
    return std::nullopt;
  if (file.get() < 0)
    fail(path, "be read", errno);
  try {
    const std::string text = file.readAll();
    const Lines lines(text);
    if (!lines.texts.empty())
      return recordOf(lines, path);
    requireTornHeader(text, path);
    return std::nullopt;
  }
  catch (const std::system_error& error) {
    fail(path, "be read", error.code().value());
  }
}

SessionRecord
readSession(const std::string& path)
{
  std::optional<SessionRecord> record = findSession(path);
  if (!record)
    throw CIDException(path + ": there is no session");
  return std::move(*record);
}

void
requireScanOf(const SessionRecord& record,
              const ScanIdentity& scan,
              const std::string& path)
{
  if (record.scan.points != scan.points)
    throw CIDException(path + ": the session is of a scan of " +
                       std::to_string(record.scan.points) + " points, '" +
                       record.scan.name + "'; '" + scan.name + "' has " +
                       std::to_string(scan.points));
  if (record.scan.checksum != scan.checksum)
    throw CIDException(path + ": the session is of '" + record.scan.name + "'; '" +
                       scan.name +
                       "' has as many points, but with other coordinates or in another "
                       "order");
}

std::size_t
replaySession(const SessionRecord& record,
              const std::string& path,
              LabelSession& session,
              const ExecutionOptions& execution)
{
  const std::size_t done = session.replay(record.actions, execution);
  if (done == record.actions.size() || record.lines[done] == record.lastLine())
    return done;
  try {
    session.apply(record.actions[done]);
  }
  catch (const CIDException& error) {
    throw impossible(path, record.lines[done], error);
  }
  return done;
}

void
replayParts(const SessionRecord& record,
            const std::string& path,
            PartSession& parts,
            const ExecutionOptions& execution)
{
  for (std::size_t k = 0; k < record.part_actions.size(); ++k)
    try {
      parts.apply(record.part_actions[k], execution);
    }
    catch (const CIDCancelled&) {
      throw;
    }
    catch (const CIDException& error) {
      throw impossible(path, record.part_lines[k], error);
    }
}

std::optional<PartAction>
partActionIn(const std::string& line)
{
  try {
    return partActionFrom(nlohmann::json::parse(line));
  }
  catch (const nlohmann::json::exception&) {
    throw CIDException("an action on parts is not JSON");
  }
}

/** The file, locked. */
class SessionFile::File {
public:
  explicit File(const std::string& path)
  : path_(path), file_(resolved(path), O_RDWR | O_CREAT)
  {
    if (file_.get() < 0)
      fail(path, "be opened", errno);
    if (const int reason = file_.lock())
      reason == EWOULDBLOCK
          ? throw CIDException(path + ": another program works on this session")
          : fail(path, "be locked", reason);
  }

  std::string
  readAll() const
  {
    try {
      return file_.readAll();
    }
    catch (const std::system_error& error) {
      fail(path_, "be read", error.code().value());
    }
  }

  /** Write at the end, and wait for the disk; what is there of it goes again when that
   *  fails. */
  void
  append(const std::string& text, std::size_t end)
  {
    try {
      if (lseek(file_.get(), static_cast<off_t>(end), SEEK_SET) < 0)
        throw std::system_error(errno, std::generic_category());
      file_.writeAll(text);
      if (fdatasync(file_.get()) != 0)
        throw std::system_error(errno, std::generic_category());
    }
    catch (const std::system_error& error) {
      // A line that is not whole is cut off when the file is opened again, in any case.
      static_cast<void>(ftruncate(file_.get(), static_cast<off_t>(end)) + 0);
      fail(path_, "be written", error.code().value());
    }
  }

  void
  cut(std::size_t end)
  {
    if (ftruncate(file_.get(), static_cast<off_t>(end)) != 0 ||
        fdatasync(file_.get()) != 0)
      fail(path_, "be written", errno);
  }

private:
  std::string path_;
  OpenFile file_;
};

SessionFile::SessionFile(std::string path,
                         const ScanIdentity& scan,
                         const SessionSettings& settings,
                         bool anew)
: path_(std::move(path)), file_(std::make_unique<File>(path_))
{
  const std::string text = anew ? "" : file_->readAll();
  const Lines lines(text);
  if (lines.texts.empty()) {
    requireTornHeader(text, path_);
    begin(scan, settings);
    return;
  }
  record_ = recordOf(lines, path_);
  requireScanOf(record_, scan, path_);
  end_ = lines.ends.back();
  before_last_ = lines.ends.size() > 1 ? lines.ends[lines.ends.size() - 2] : end_;
  if (end_ < text.size())
    file_->cut(end_);
}

void
SessionFile::begin(const ScanIdentity& scan, const SessionSettings& settings)
{
  file_->cut(0);
  write(lineOf(headerOf(scan, settings)));
  synchronizeFolderOf(path_);
  record_.scan = scan;
  record_.settings = settings;
}

void
SessionFile::moveTo(const std::string& path)
{
  std::error_code error;
  fs::rename(resolved(path_), resolved(path), error);
  if (error)
    fail(path, "be written", error.value());
  path_ = path;
  synchronizeFolderOf(path_);
}

SessionFile::~SessionFile() = default;

void
SessionFile::write(const std::string& line)
{
  file_->append(line, end_);
  before_last_ = end_;
  end_ += line.size();
}

void
SessionFile::append(const LabelAction& action)
{
  write(lineOf(toJson(action)));
}

void
SessionFile::append(const PartAction& action)
{
  write(lineOf(toJson(action)));
}

void
SessionFile::dropLast()
{
  file_->cut(before_last_);
  end_ = before_last_;
}

} // namespace pcl_cid
