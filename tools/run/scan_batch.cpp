/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scan after scan in one call, each as a run of its own.
 */

#include "scan_batch.h"

#include "failed_scans.h"
#include "interruption.h"
#include "run.h"
#include "words.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_blocks.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <ostream>
#include <utility>

#include <unistd.h>

namespace pcl_cid::tools {
namespace {

/** The scans of a call, and what became of them so far. */
class ScanBatch {
public:
  ScanBatch(const ScanWork& work, const ManyScans& many, bool quiet)
  : work_(work), many_(many), console_(quiet)
  {
    for (const std::string& scan : many.scans)
      rows_.push_back({scan, nameOfScan(scan), "", std::nullopt, 0.0});
  }

  /** All that is read; a scan that cannot be read fails. */
  std::vector<std::string>
  gatherInputs()
  {
    std::vector<std::string> all{many_.list};
    for (ScanRow& row : rows_) {
      std::vector<std::string> inputs{row.scan};
      attemptWith(row, [&] {
        inputs = work_.inputs(row.scan);
        requireReadable(row.scan, inputs);
      });
      all.insert(all.end(), inputs.begin(), inputs.end());
    }
    return all;
  }

  /** Make sure that all outputs can be written, each for one scan.
   *  \param[in] outputs of the call itself */
  void
  checkOutputs(const OutputFiles& outputs) const
  {
    std::map<std::string, std::string> writer;
    for (const std::string& file : outputs.files())
      writer.emplace(file, "--summary");
    for (const ScanRow& row : rows_) {
      if (!row.error.empty())
        continue;
      ToolOutputs of_scan({}); // the inputs are those of the call
      work_.announce(row.scan, of_scan);
      for (const std::string& file : of_scan.files())
        if (const auto [other, is_new] = writer.emplace(file, row.scan); !is_new)
          throw CIDException(file + ": would be written for " + other->second +
                             " and for " + row.scan + "; choose other names");
    }
  }

  /** \throws Interrupted */
  void
  run()
  {
    std::size_t number = 0;
    for (ScanRow& row : rows_) {
      ++number;
      if (!row.error.empty())
        continue;
      console_.begin(std::string(work_.doing) + " " + row.scan + " (" +
                     std::to_string(number) + " of " + std::to_string(rows_.size()) +
                     ")");
      attemptWith(row, [&] {
        const ScanFigures figures = work_.run(row.scan);
        row.seconds = console_.end(wordsOf(figures));
        row.figures = figures;
      });
    }
  }

  const std::vector<ScanRow>&
  rows() const
  {
    return rows_;
  }

  /** What is left of a run that was asked to end. */
  Interrupted
  interrupted() const
  {
    const auto done = std::count_if(rows_.begin(), rows_.end(), [](const ScanRow& row) {
      return row.figures.has_value();
    });
    return Interrupted("done: " + std::to_string(done) + " of " +
                       std::to_string(rows_.size()) +
                       " scans; nothing was written for the others");
  }

  void
  requireAllDone() const
  {
    requireNoFailure(failed_, rows_.size(), work_.done, FailureList::reasons);
  }

private:
  /** What can be told about a scan and the files that belong to it without reading
   *  them. */
  void
  requireReadable(const std::string& scan, const std::vector<std::string>& inputs) const
  {
    // It may have been recognized by its content; if not, the reader knows why.
    if (!work_.has_format && !isScan(scan) && !isFileNamedAsScan(scan)) {
      if (work_.in_blocks)
        CloudBlockReader reader(scan);
      else
        readScan(scan);
    }
    for (const std::string& input : inputs)
      if (!input.empty() && access(input.c_str(), R_OK) != 0)
        throw CIDException(input + ": cannot be opened: " + std::strerror(errno));
  }

  /** Whether its name says how it is read, although not every such file is a scan. */
  static bool
  isFileNamedAsScan(const std::string& path)
  {
    const std::vector<std::string> extensions = scanExtensions();
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) &&
           std::count(extensions.begin(), extensions.end(), extensionOf(path)) > 0;
  }

  void
  attemptWith(ScanRow& row, const std::function<void()>& work)
  {
    if (!attempt(work_.tool, row.scan, work, failed_))
      row.error = failed_.back().error;
  }

  const ScanWork& work_;
  const ManyScans& many_;
  Console console_;
  std::vector<ScanRow> rows_;
  std::vector<FailedScan> failed_;
};

void
writeSummary(const ScanWork& work,
             const ManyScans& many,
             const std::vector<ScanRow>& rows,
             OutputFiles& outputs)
{
  if (many.summary.empty())
    return;
  outputs.write(many.summary, [&](std::ostream& stream) {
    stream << summaryFor(many.summary, work.tool, rows);
  });
  outputs.commit();
}

} // namespace

void
doEachScan(const ScanWork& work, const ManyScans& many, bool quiet)
{
  ScanBatch batch(work, many, quiet);
  // Those of the scans come and go while these are there, and keep off their inputs.
  ToolOutputs outputs(batch.gatherInputs());
  outputs.announceFolder(many.output_dir);
  if (!many.summary.empty())
    outputs.announce(many.summary);
  batch.checkOutputs(outputs);
  try {
    batch.run();
  }
  catch (const Interrupted&) {
    writeSummary(work, many, batch.rows(), outputs);
    throw batch.interrupted();
  }
  writeSummary(work, many, batch.rows(), outputs);
  batch.requireAllDone();
}

} // namespace pcl_cid::tools
