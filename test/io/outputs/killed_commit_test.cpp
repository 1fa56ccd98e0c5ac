/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * All outputs of a run or none, wherever it is killed and whatever call fails.
 */

#include "cloud_files.h"
#include "disturbed_calls.h"

#include <pcl_cid/io/output_files.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <ostream>

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

/** Files of an earlier run in two folders, and a run that replaces, removes and adds.
 */
class KilledCommitTest : public testing::Test {
protected:
  static const Files old;
  static const Files all_new;

  void
  makeOld() const
  {
    for (const char* const name : {"one", "two"}) {
      fs::remove_all(file(name));
      fs::create_directory(file(name));
    }
    for (const auto& [name, text] : old)
      writeText(file(name), text);
  }

  /** All files, hidden ones too. */
  Files
  files() const
  {
    Files all;
    for (const char* const folder : {"one", "two"})
      for (const fs::directory_entry& entry : fs::directory_iterator(file(folder)))
        all[folder + ("/" + entry.path().filename().string())] =
            readText(entry.path().string());
    return all;
  }

  void
  runOnce() const
  {
    OutputFiles outputs({});
    for (const char* const name : {"one/a", "one/added", "two/b"})
      outputs.announce(file(name));
    for (const char* const name : {"one/a", "one/gone", "two/gone"})
      outputs.announceRemoval(file(name));
    for (const char* const name : {"one/a", "one/added", "two/b"})
      outputs.write(file(name), [](std::ostream& stream) { stream << "new"; });
    outputs.commit();
  }

  /** A run that has outputs in these folders, and ends without any. */
  void
  runNext(const std::vector<std::string>& folders = {"one", "two"}) const
  {
    OutputFiles outputs({});
    for (const std::string& folder : folders)
      outputs.announceFolder(file(folder));
  }

  std::string
  file(const std::string& name) const
  {
    return folder_.file(name);
  }

  TemporaryFolder folder_;
};

const Files KilledCommitTest::old{
    {"one/a", "old"}, {"one/gone", "old"}, {"two/b", "old"}, {"two/gone", "old"}};
const Files KilledCommitTest::all_new{
    {"one/a", "new"}, {"one/added", "new"}, {"two/b", "new"}};

/** How a child ended. */
struct End {
  bool disturbed = false; ///< the call has come
  bool threw = false;
  bool said_in_place = false;
};

constexpr int done = 10; // and more for what is true of the End

int
exitCodeOf(const std::function<void()>& work)
{
  End end;
  try {
    work();
  }
  catch (const CIDException& error) {
    end.threw = true;
    end.said_in_place =
        std::string(error.what()).find("all outputs are in place") != std::string::npos;
  }
  return done + (wasDisturbed() ? 1 : 0) + (end.threw ? 2 : 0) +
         (end.said_in_place ? 4 : 0);
}

/** Start work in a child, of which one call is disturbed. */
pid_t
start(const std::function<void()>& work, Disturbance disturbance, int call)
{
  const pid_t child = fork();
  if (child == 0) {
    disturb(disturbance, call);
    _exit(exitCodeOf(work));
  }
  return child;
}

End
endOf(pid_t child)
{
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
    return {true, false, false};
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) - done : -1;
  EXPECT_GE(code, 0) << "the child ended with status " << status;
  return {(code & 1) != 0, (code & 2) != 0, (code & 4) != 0};
}

End
endOf(const std::function<void()>& work, Disturbance disturbance, int call)
{
  return endOf(start(work, disturbance, call));
}

TEST_F(KilledCommitTest, LeavesAllOrNoneToTheNextRun)
{
  int ended_old = 0;
  int ended_new = 0;
  for (int call = 0;; ++call) {
    SCOPED_TRACE(call);
    makeOld();
    if (!endOf([&] { runOnce(); }, Disturbance::kill, call).disturbed)
      break;
    runNext();
    const Files left = files();
    EXPECT_TRUE(left == old || left == all_new) << testing::PrintToString(left);
    (left == old ? ended_old : ended_new) += 1;
  }
  EXPECT_EQ(files(), all_new);
  EXPECT_GE(ended_old, 15); // so many calls there are before the commit, at least
  EXPECT_GE(ended_new, 5);
}

TEST_F(KilledCommitTest, IsBroughtToItsEndFromAnyFolder)
{
  for (int call = 0;; ++call) {
    SCOPED_TRACE(call);
    makeOld();
    if (!endOf([&] { runOnce(); }, Disturbance::kill, call).disturbed)
      break;
    runNext({"two"});
    Files left = files();
    EXPECT_EQ(left.at("one/a"), left.at("two/b"));
    EXPECT_EQ(left.at("one/a") == "new", left.count("one/added") == 1);
    EXPECT_EQ(left.at("one/a") == "new", left.count("two/gone") == 0);
    runNext({"one"});
    left = files();
    EXPECT_TRUE(left == old || left == all_new) << testing::PrintToString(left);
  }
}

TEST_F(KilledCommitTest, IsBroughtToItsEndEvenWhenTheNextRunIsKilledToo)
{
  for (int call = 0, tried = 1; tried > 0; call += 4) {
    tried = 0;
    for (int next_call = 0;; ++next_call, ++tried) {
      SCOPED_TRACE(testing::Message() << call << ", then " << next_call);
      makeOld();
      if (!endOf([&] { runOnce(); }, Disturbance::kill, call).disturbed)
        break;
      const bool was_killed =
          endOf([&] { runNext(); }, Disturbance::kill, next_call).disturbed;
      runNext();
      const Files left = files();
      ASSERT_TRUE(left == old || left == all_new) << testing::PrintToString(left);
      if (!was_killed)
        break;
    }
  }
}

TEST_F(KilledCommitTest, LeavesAllOrNoneWhenACallFails)
{
  for (int call = 0;; ++call) {
    SCOPED_TRACE(call);
    makeOld();
    const End end = endOf([&] { runOnce(); }, Disturbance::fail, call);
    if (!end.disturbed)
      break;
    Files left = files();
    for (auto each = left.begin(); each != left.end();) // seen to by the next run
      each = each->first.find("/.") == std::string::npos ? std::next(each)
                                                         : left.erase(each);
    EXPECT_EQ(left, !end.threw || end.said_in_place ? all_new : old);
    runNext();
    EXPECT_EQ(files(), left);
  }
}

TEST_F(KilledCommitTest, LeavesAllOrNoneToTheNextRunWhenAllCallsFail)
{
  for (int call = 0;; ++call) {
    SCOPED_TRACE(call);
    makeOld();
    const End end = endOf([&] { runOnce(); }, Disturbance::fail_from_there, call);
    if (!end.disturbed)
      break;
    runNext();
    const Files left = files();
    EXPECT_TRUE(left == old || left == all_new) << testing::PrintToString(left);
    EXPECT_EQ(left == all_new, !end.threw || end.said_in_place);
  }
}

Files
withoutEmptyLocks(Files files)
{
  for (auto each = files.begin(); each != files.end();)
    each = each->second.empty() && fs::path(each->first).extension() == ".run"
               ? files.erase(each)
               : std::next(each);
  return files;
}

TEST_F(KilledCommitTest, IsLeftAloneWhileItsRunIsAlive)
{
  for (int call = 0;; ++call) {
    SCOPED_TRACE(call);
    makeOld();
    const pid_t child = start([&] { runOnce(); }, Disturbance::stop, call);
    int status = 0;
    waitpid(child, &status, WUNTRACED);
    if (!WIFSTOPPED(status))
      break;
    // Before it has locked a folder, the run may have to begin anew.
    const Files before = withoutEmptyLocks(files());
    runNext();
    EXPECT_EQ(withoutEmptyLocks(files()), before);
    kill(child, SIGCONT);
    EXPECT_FALSE(endOf(child).threw);
    runNext();
    EXPECT_EQ(files(), all_new);
  }
}

TEST_F(KilledCommitTest, DoesNotTouchWhatSomebodyElsePutThere)
{
  for (int call = 0;; ++call) {
    SCOPED_TRACE(call);
    makeOld();
    if (!endOf([&] { runOnce(); }, Disturbance::kill, call).disturbed)
      break;
    for (const char* const name : {"one/a", "one/gone"}) {
      fs::remove(file(name));
      writeText(file(name), "of somebody else");
    }
    writeText(file("one/.hidden"), "of somebody else");
    writeText(file("one/.pcl_cid-1-0-1.partial"), "of somebody else");
    runNext();
    const Files left = files();
    for (const char* const name :
         {"one/a", "one/gone", "one/.hidden", "one/.pcl_cid-1-0-1.partial"})
      EXPECT_EQ(left.at(name), "of somebody else") << name;
  }
}

TEST_F(KilledCommitTest, MayMoveWithItsFolders)
{
  for (int call = 0;; ++call) {
    SCOPED_TRACE(call);
    makeOld();
    if (!endOf([&] { runOnce(); }, Disturbance::kill, call).disturbed)
      break;
    fs::create_directory(file("moved"));
    for (const char* const name : {"one", "two"})
      fs::rename(file(name), file("moved/") + name);
    runNext({"moved/one", "moved/two"});
    for (const char* const name : {"one", "two"})
      fs::rename(file("moved/") + name, file(name));
    const Files left = files();
    EXPECT_TRUE(left == old || left == all_new) << testing::PrintToString(left);
  }
}

TEST_F(KilledCommitTest, IsNotTakenFromAFileThatOnlyHasTheNameOfARecord)
{
  makeOld();
  const std::string mark = std::string("0 0 0 0") + '\0';
  const std::string head = std::string("pcl_cid commit 1") + '\0';
  const std::string end = std::string("end") + '\0';
  const std::string names = std::string("a") + '\0' + '\0' + "../two/b" + '\0';
  writeText(file("one/.pcl_cid-1-0.run"), ".pcl_cid-1-0\n");
  for (const std::string& text :
       {std::string(), std::string("text"), head, head + names + mark + end}) {
    writeText(file("one/.pcl_cid-1-0.undo"), text);
    try {
      runNext();
      FAIL() << "accepted: " << text;
    }
    catch (const CIDException& error) {
      EXPECT_NE(std::string(error.what()).find(".pcl_cid-1-0.undo"), std::string::npos)
          << error.what();
    }
    EXPECT_EQ(readText(file("two/b")), "old");
    EXPECT_EQ(readText(file("one/a")), "old");
  }
}

} // namespace
} // namespace pcl_cid::test
