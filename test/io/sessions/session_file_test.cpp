/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Sessions on the disk: they come back to the bit, torn or not.
 */

#include "cloud_files.h"
#include "clouds.h"
#include "prepared_points.h"
#include "random_actions.h"
#include "session_state.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/session_file.h>

#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include <sys/resource.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;

std::string
messageOfOpening(const std::string& path, const ScanIdentity& scan)
{
  try {
    SessionFile(path, scan, {});
    return "";
  }
  catch (const CIDException& error) {
    return error.what();
  }
}

class SessionFiles : public testing::Test {
protected:
  void
  SetUp() override
  {
    scan_ = prepared(twoBoxes(300, 7));
    identity_ = {"room.pcd", 300, 0x1234567890abcdefu};
  }

  /** Actions in a file, and the state that they lead to. */
  SessionState
  writeRandomSession(std::size_t count, std::uint64_t seed)
  {
    LabelSession session(scan_);
    SessionFile file(path_, identity_, {});
    for (const LabelAction& action : doRandomActions(count, seed, session))
      file.append(action);
    return SessionState(session);
  }

  SessionState
  replayed(const SessionRecord& record)
  {
    LabelSession session(scan_);
    replaySession(record, path_, session);
    return SessionState(session);
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("room.session");
  PreparedScan::ConstPtr scan_;
  ScanIdentity identity_;
};

TEST_F(SessionFiles, ComeBackToTheBit)
{
  const SessionState live = writeRandomSession(300, 5);
  const SessionRecord record = readSession(path_);
  EXPECT_EQ(record.actions.size(), 300u);
  EXPECT_EQ(record.scan.checksum, identity_.checksum);
  EXPECT_TRUE(replayed(record) == live);
  SessionFile again(path_, identity_, {});
  EXPECT_TRUE(replayed(again.record()) == live);
}

TEST_F(SessionFiles, KeepTheirSettings)
{
  SessionSettings settings;
  settings.preparation.normals = 0.017f;
  settings.preparation.density = DensityWeight::on;
  settings.preparation.random_seed = std::numeric_limits<std::uint64_t>::max();
  settings.preparation.start_index = 12;
  settings.grouping.samples = 57;
  settings.grouping.seeding = SeedingRule::soft;
  settings.keep_zeros = true;
  SessionFile(path_, identity_, settings);
  const SessionFile again(path_, identity_, {});
  const SessionSettings& kept = again.record().settings;
  EXPECT_EQ(kept.preparation.normals, 0.017f);
  EXPECT_EQ(kept.preparation.density, DensityWeight::on);
  EXPECT_EQ(kept.preparation.random_seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(kept.preparation.start_index, 12);
  EXPECT_EQ(kept.preparation.connected, settings.preparation.connected);
  EXPECT_EQ(kept.grouping.samples, 57);
  EXPECT_EQ(kept.grouping.seeding, SeedingRule::soft);
  EXPECT_TRUE(kept.keep_zeros);
}

TEST_F(SessionFiles, LoseOnlyTheLineThatWasTorn)
{
  writeRandomSession(12, 9);
  const std::string whole = readText(path_);
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const bool is_at_an_end = whole[size - 1] == '\n' || whole[size] == '\n';
    if (!is_at_an_end && size % 29 != 1) // each waits for the disk
      continue;
    writeText(path_, whole.substr(0, size));
    const auto lines = std::count(
        whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size), '\n');
    {
      SessionFile file(path_, identity_, {});
      ASSERT_EQ(file.record().actions.size(),
                static_cast<std::size_t>(std::max<std::ptrdiff_t>(lines - 1, 0)));
      file.append(action::Undo{});
    }
    const std::vector<LabelAction> actions = readSession(path_).actions;
    ASSERT_TRUE(std::holds_alternative<action::Undo>(actions.back()));
  }
}

TEST_F(SessionFiles, TakeBackWhatWasNotPossible)
{
  {
    SessionFile file(path_, identity_, {});
    file.append(action::Propose{3});
    file.append(action::Undo{});
    file.append(action::Undo{}); // not possible
  }
  LabelSession session(scan_);
  SessionFile file(path_, identity_, {});
  EXPECT_EQ(replaySession(file.record(), path_, session), 2u);
  file.dropLast();
  file.append(action::Redo{});
  EXPECT_EQ(readSession(path_).actions.size(), 3u);
}

TEST_F(SessionFiles, RefuseWhatIsNotPossibleInTheMiddle)
{
  {
    SessionFile file(path_, identity_, {});
    file.append(action::Remove{5});
    file.append(action::Propose{3});
  }
  try {
    replayed(readSession(path_));
    FAIL();
  }
  catch (const CIDException& error) {
    EXPECT_EQ(std::string(error.what()), path_ + ": line 2: point 5 is not a seed");
  }
}

TEST_F(SessionFiles, KeepActionsOnPartsBesideThoseOnLabels)
{
  const std::vector<PartAction> on_parts{part_action::Decompose{9},
                                         part_action::Cut{4},
                                         part_action::Split{0},
                                         part_action::Join{2, 1},
                                         part_action::Drop{3},
                                         part_action::Keep{3},
                                         part_action::Exact{1, true},
                                         part_action::Exact{1, false},
                                         part_action::Undo{},
                                         part_action::Redo{}};
  const auto write = [&](const std::string& path,
                         const std::vector<PartAction>& actions) {
    SessionFile file(path, identity_, {});
    for (const PartAction& action : actions) {
      file.append(action);
      file.append(LabelAction{action::Propose{1}});
    }
  };
  write(path_, on_parts);
  const SessionRecord record = readSession(path_);
  EXPECT_EQ(record.actions.size(), on_parts.size());
  ASSERT_EQ(record.part_actions.size(), on_parts.size());
  EXPECT_EQ(record.lastLine(), 1 + 2 * on_parts.size());
  EXPECT_EQ(record.part_lines.back() + 1, record.lines.back());
  // As each word has its own fields, the same bytes are the same actions.
  const std::string again = folder_.file("again.session");
  write(again, record.part_actions);
  EXPECT_EQ(readText(again), readText(path_));
  for (std::size_t k = 0; k < on_parts.size(); ++k)
    EXPECT_EQ(record.part_actions[k].index(), on_parts[k].index());
  EXPECT_EQ(std::get<part_action::Join>(record.part_actions[3]).with, 1);
  EXPECT_TRUE(std::get<part_action::Exact>(record.part_actions[6]).exact);
}

TEST_F(SessionFiles, SayWhichActionOnPartsIsNotPossible)
{
  {
    SessionFile file(path_, identity_, {});
    file.append(LabelAction{action::Propose{3}});
    file.append(PartAction{part_action::Decompose{4}});
    file.append(PartAction{part_action::Drop{77}});
  }
  PartSession parts(scan_);
  try {
    replayParts(readSession(path_), path_, parts);
    FAIL() << "there is no part 77";
  }
  catch (const CIDException& error) {
    EXPECT_EQ(error.what(),
              path_ + ": line 4: there is no part 77; a part goes by the number of its "
                      "lowest group");
  }
  for (const char* line : {"{\"do\":\"cut\"}",
                           "{\"do\":\"cut\",\"parts\":-1}",
                           "{\"do\":\"exact\",\"part\":1,\"exact\":1}",
                           "{\"do\":7}",
                           "cut"})
    EXPECT_THROW(partActionIn(line), CIDException) << line;
  EXPECT_FALSE(partActionIn("{\"do\":\"undo\"}"));
  EXPECT_TRUE(partActionIn("{\"do\":\"undo parts\",\"id\":3}"));
}

TEST_F(SessionFiles, AreOfOneScanAndOneProgram)
{
  const SessionFile file(path_, identity_, {});
  EXPECT_NE(messageOfOpening(path_, identity_).find("another program works on"),
            std::string::npos);
  const std::string copy = path_ + ".copy";
  fs::copy_file(path_, copy);
  EXPECT_EQ(messageOfOpening(copy, identity_), "");
  EXPECT_NE(messageOfOpening(copy, {"hall.pcd", 299, 1}).find("300 points"),
            std::string::npos);
  EXPECT_NE(messageOfOpening(copy, {"hall.pcd", 300, 1}).find("other coordinates"),
            std::string::npos);
  EXPECT_EQ(messageOfOpening(copy, {"renamed.pcd", 300, identity_.checksum}), "");
}

TEST_F(SessionFiles, RefuseDamagedOnesWithTheLine)
{
  writeRandomSession(8, 9);
  const std::string whole = readText(path_);
  const std::size_t second = whole.find('\n') + 1;
  const std::string header = whole.substr(0, second);
  const std::string rest = whole.substr(second);
  const auto refused = [&](const std::string& text, const std::string& reason) {
    writeText(path_, text);
    const std::string message = messageOfOpening(path_, identity_);
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(readText(path_), text) << "a file that was refused was changed";
  };
  refused("x,y,z\n1,2,3\n", "line 1 is not JSON");
  refused("seeds", "it is not a session");
  refused("{}\n", "line 1: 'format' is missing");
  refused("{\"format\": \"pcl_cid session\", \"version\": 2}\n", "version 2");
  refused(header + "{\"do\": \"jump\"}\n" + rest, "line 2: nothing is called 'jump'");
  refused(header + "\n" + rest, "line 2 is not JSON");
  refused(header + "[1]\n" + rest, "line 2: 'do' is missing");
  refused(header + "{\"do\": \"label\", \"seed\": -3000000000, \"label\": 1}\n",
          "line 2: 'seed' is -3000000000");
  refused(header + "{\"do\": \"label\", \"seed\": 1, \"label\": 1.5}\n",
          "'label' is 1.5");
  refused(header + "{\"do\": \"edit\", \"label\": 1, \"class\": 3, \"name\": \"\"}\n",
          "'class' is 3; it must be a text");
  refused(header + "{\"do\": \"paint\", \"label\": 1, \"runs\": [1]}\n", "'runs' must");
  refused(header +
              "{\"do\": \"paint\", \"label\": 1, \"runs\": [4000000000, 4000000000]}\n",
          "no cloud has so many");
  std::string odd = header;
  odd.replace(odd.find("\"connected\":\"on\""), 16, "\"connected\":\"no\"");
  refused(odd, "line 1: 'connected' is 'no'");
}

TEST_F(SessionFiles, RefuseWhatTheDiskCannotHold)
{
  SessionFile file(path_, identity_, {});
  file.append(action::Propose{3});
  const std::string before = readText(path_);
  // A file that must not grow stands for a full disk.
  rlimit old = {};
  getrlimit(RLIMIT_FSIZE, &old);
  const auto handler = signal(SIGXFSZ, SIG_IGN);
  const rlimit small{before.size() + 5, old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(file.append(action::Propose{4}), CIDException);
  setrlimit(RLIMIT_FSIZE, &old);
  signal(SIGXFSZ, handler);
  EXPECT_EQ(readText(path_), before);
  file.append(action::Undo{});
  EXPECT_EQ(readSession(path_).actions.size(), 2u);
}

TEST_F(SessionFiles, RefuseTextThatIsNotUtf8)
{
  SessionFile file(path_, identity_, {});
  EXPECT_THROW(file.append(action::Edit{1, "\xff\xfe", ""}), CIDException);
  file.append(action::Edit{1, "Stühle \"\\\n", "椅子"});
  const auto edit = std::get<action::Edit>(readSession(path_).actions.back());
  EXPECT_EQ(edit.class_name, "Stühle \"\\\n");
  EXPECT_EQ(edit.name, "椅子");
}

TEST(ScanIdentity, SeesEveryCoordinateAndNoPayload)
{
  pcl::PointCloud<pcl::PointXYZ> cloud = *toCloud(twoBoxes(50, 7));
  const auto checksum = [&] { return identityOf(toLabelledCloud(cloud)).checksum; };
  const std::uint64_t before = checksum();
  cloud[20].y = std::nextafter(cloud[20].y, 9.0f);
  EXPECT_NE(checksum(), before);
  cloud[20].y = std::numeric_limits<float>::quiet_NaN();
  const std::uint64_t with_nan = checksum();
  cloud[20].x = std::numeric_limits<float>::infinity();
  EXPECT_EQ(checksum(), with_nan);
  std::swap(cloud[3], cloud[4]);
  EXPECT_NE(checksum(), with_nan);
}

} // namespace
} // namespace pcl_cid::test
