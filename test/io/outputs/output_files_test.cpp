/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Outputs appear whole or not at all, and never over an input.
 */

#include "cloud_files.h"

#include <pcl_cid/io/output_files.h>

#include <csignal>
#include <filesystem>
#include <ostream>

#include <gtest/gtest.h>

#include <sys/resource.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

const auto write_new = [](std::ostream& stream) { stream << "new"; };

class OutputFilesTest : public testing::Test {
protected:
  TemporaryFolder folder_;
};

TEST_F(OutputFilesTest, AppearTogetherAtTheCommit)
{
  OutputFiles outputs({});
  outputs.announce(folder_.file("a"));
  outputs.announce(folder_.file("b"));
  outputs.write(folder_.file("a"), write_new);
  outputs.write(folder_.file("b"), write_new);
  EXPECT_FALSE(fs::exists(folder_.file("a")));
  outputs.commit();
  EXPECT_EQ(folder_.names(), (Names{"a", "b"}));
  EXPECT_EQ(readText(folder_.file("a")), "new");
}

TEST_F(OutputFilesTest, LeaveNothingWithoutCommit)
{
  writeText(folder_.file("old"), "old");
  {
    OutputFiles outputs({});
    outputs.announce(folder_.file("old"));
    outputs.announce(folder_.file("other"));
    outputs.write(folder_.file("old"), write_new);
  }
  EXPECT_EQ(folder_.names(), Names{"old"});
  EXPECT_EQ(readText(folder_.file("old")), "old");
}

TEST_F(OutputFilesTest, ReplaceOlderFiles)
{
  writeText(folder_.file("old"), "a longer text");
  OutputFiles outputs({});
  outputs.announce(folder_.file("old"));
  outputs.write(folder_.file("old"), write_new);
  outputs.commit();
  EXPECT_EQ(folder_.names(), Names{"old"});
  EXPECT_EQ(readText(folder_.file("old")), "new");
}

TEST_F(OutputFilesTest, PassExceptionsOfTheWriterOn)
{
  {
    OutputFiles outputs({});
    outputs.announce(folder_.file("a"));
    EXPECT_THROW(outputs.write(folder_.file("a"),
                               [](std::ostream&) { throw CIDException("no"); }),
                 CIDException);
  }
  EXPECT_EQ(folder_.names(), Names{});
}

TEST_F(OutputFilesTest, NoticeAFullDisk)
{
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  {
    OutputFiles outputs({});
    outputs.announce(folder_.file("small"));
    outputs.announce(folder_.file("large"));
    outputs.write(folder_.file("small"), write_new);
    rlimit limit = before;
    limit.rlim_cur = 4096;
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_THROW(outputs.write(folder_.file("large"),
                               [](std::ostream& s) { s << std::string(100000, 'x'); }),
                 CIDException);
    // Small enough for the stream's buffer, so that only closing it can fail.
    EXPECT_THROW(outputs.write(folder_.file("large"),
                               [](std::ostream& s) { s << std::string(4100, 'x'); }),
                 CIDException);
    setrlimit(RLIMIT_FSIZE, &before);
  }
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(folder_.names(), Names{});
}

TEST_F(OutputFilesTest, NeverWriteOverAnInput)
{
  const std::string input = folder_.file("input");
  writeText(input, "precious");
  fs::create_symlink("input", folder_.file("link"));
  fs::create_hard_link(input, folder_.file("hard"));
  fs::create_directory(folder_.file("sub"));
  OutputFiles outputs({input, ""});
  for (const char* const name : {"input", "./input", "sub/../input", "link", "hard"})
    EXPECT_THROW(outputs.announce(folder_.file(name)), CIDException) << name;
  EXPECT_EQ(readText(input), "precious");
  EXPECT_EQ(folder_.names(), (Names{"hard", "input", "link", "sub"}));
}

TEST_F(OutputFilesTest, ThatAreOneFileAreRefused)
{
  OutputFiles outputs({});
  outputs.announce(folder_.file("a"));
  EXPECT_THROW(outputs.announce(folder_.file("a")), CIDException);
  EXPECT_THROW(outputs.announce(folder_.file("./a")), CIDException);
  EXPECT_NO_THROW(outputs.announce(folder_.file("b")));
}

TEST_F(OutputFilesTest, NeedAFolderAndAFreeName)
{
  fs::create_directory(folder_.file("sub"));
  OutputFiles outputs({});
  for (const std::string& path :
       {folder_.file("nowhere/a"), folder_.file("sub"), std::string("/dev/null")}) {
    try {
      outputs.announce(path);
      FAIL() << path << " was accepted";
    }
    catch (const CIDException& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path, 0), 0u) << error.what();
    }
  }
}

TEST_F(OutputFilesTest, FollowLinks)
{
  fs::create_directory(folder_.file("sub"));
  writeText(folder_.file("sub/real"), "old");
  fs::create_symlink("sub/real", folder_.file("link"));
  OutputFiles outputs({});
  outputs.announce(folder_.file("link"));
  outputs.write(folder_.file("link"), write_new);
  outputs.commit();
  EXPECT_TRUE(fs::is_symlink(folder_.file("link")));
  EXPECT_EQ(readText(folder_.file("sub/real")), "new");
}

TEST_F(OutputFilesTest, FollowLinksToWhatIsNotThereYet)
{
  fs::create_directory(folder_.file("sub"));
  fs::create_symlink("sub/middle", folder_.file("link"));
  fs::create_symlink("real", folder_.file("sub/middle"));
  OutputFiles outputs({});
  outputs.announce(folder_.file("link"));
  outputs.write(folder_.file("link"), write_new);
  outputs.commit();
  EXPECT_TRUE(fs::is_symlink(folder_.file("link")));
  EXPECT_TRUE(fs::is_symlink(folder_.file("sub/middle")));
  EXPECT_EQ(readText(folder_.file("sub/real")), "new");
}

TEST_F(OutputFilesTest, MayHaveTheLongestNamesThereAre)
{
  for (const std::size_t length : {1, 200, 249, 255}) {
    const std::string path = folder_.file(std::string(length, 'a'));
    for (int round = 0; round < 2; ++round) {
      OutputFiles outputs({});
      outputs.announce(path);
      outputs.write(path, write_new);
      outputs.commit();
      EXPECT_EQ(readText(path), "new");
    }
    fs::remove(path);
  }
}

TEST_F(OutputFilesTest, RefuseNamesThatLeadNowhere)
{
  fs::create_symlink("loop", folder_.file("loop"));
  fs::create_symlink("nowhere/a", folder_.file("into nowhere"));
  OutputFiles outputs({folder_.file("loop")});
  for (const std::string& path : {folder_.file("loop"),
                                  folder_.file("loop/a"),
                                  folder_.file("into nowhere"),
                                  folder_.file(std::string(256, 'a')),
                                  folder_.file(std::string(5000, 'a'))}) {
    EXPECT_THROW(outputs.announceFolder(path + "/b"), CIDException);
    EXPECT_THROW(outputs.announceRemoval(path + "/b"), CIDException);
    try {
      outputs.announce(path);
      FAIL() << path << " was accepted";
    }
    catch (const CIDException& error) {
      EXPECT_EQ(std::string(error.what()).rfind(path, 0), 0u) << error.what();
    }
  }
}

TEST_F(OutputFilesTest, DisappearAgainWhenOneCannotBePlaced)
{
  writeText(folder_.file("older"), "old");
  {
    OutputFiles outputs({});
    for (const char* const name : {"a", "older", "b"}) {
      outputs.announce(folder_.file(name));
      outputs.write(folder_.file(name), write_new);
    }
    fs::create_directory(folder_.file("b")); // somebody was faster
    EXPECT_THROW(outputs.commit(), CIDException);
    EXPECT_FALSE(fs::exists(folder_.file("a")));
  }
  EXPECT_EQ(folder_.names(), (Names{"b", "older"}));
  EXPECT_EQ(readText(folder_.file("older")), "old");
}

TEST_F(OutputFilesTest, MakeAFolderForThem)
{
  const std::string folder = folder_.file("new");
  {
    OutputFiles outputs({});
    outputs.announceFolder(folder + "/");
    outputs.announceFolder(folder + "/inner");
    outputs.announce(folder + "/a");
    outputs.write(folder + "/a", write_new);
  }
  EXPECT_EQ(folder_.names(), Names{}) << "without commit";
  OutputFiles outputs({});
  outputs.announceFolder(folder);
  outputs.announceFolder(folder); // is there by now
  outputs.announce(folder + "/a");
  outputs.write(folder + "/a", write_new);
  outputs.commit();
  EXPECT_EQ(readText(folder + "/a"), "new");
}

TEST_F(OutputFilesTest, KeepAFolderThatIsNotTheirs)
{
  fs::create_directory(folder_.file("mine"));
  {
    OutputFiles outputs({});
    outputs.announceFolder(folder_.file("mine"));
    outputs.announceFolder(folder_.file("new"));
    writeText(folder_.file("new/of somebody else"), "text");
  }
  EXPECT_EQ(folder_.names(), (Names{"mine", "new"}));
  EXPECT_EQ(readText(folder_.file("new/of somebody else")), "text");
}

TEST_F(OutputFilesTest, RefuseWhatCannotBeAFolderForThem)
{
  writeText(folder_.file("file"), "text");
  OutputFiles outputs({});
  for (const std::string& path :
       {folder_.file("file"), folder_.file("nowhere/new"), std::string("/proc/new")}) {
    try {
      outputs.announceFolder(path);
      FAIL() << path << " was accepted";
    }
    catch (const CIDException& error) {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos)
          << error.what();
    }
  }
}

TEST_F(OutputFilesTest, RemoveWhatIsOfAnEarlierRun)
{
  for (const char* const name : {"a", "b", "old", "precious"})
    writeText(folder_.file(name), "old");
  fs::create_symlink("precious", folder_.file("link"));
  const auto announceAll = [&](OutputFiles& outputs) {
    outputs.announce(folder_.file("a"));
    for (const char* const name : {"a", "old", "link"})
      outputs.announceRemoval(folder_.file(name));
    outputs.write(folder_.file("a"), write_new);
  };
  {
    OutputFiles outputs({});
    announceAll(outputs);
  }
  EXPECT_EQ(folder_.names(), (Names{"a", "b", "link", "old", "precious"}));
  OutputFiles outputs({});
  announceAll(outputs);
  outputs.commit();
  EXPECT_EQ(folder_.names(), (Names{"a", "b", "precious"}));
  EXPECT_EQ(readText(folder_.file("a")), "new");
}

TEST_F(OutputFilesTest, NeverRemoveAnInput)
{
  writeText(folder_.file("input"), "precious");
  OutputFiles outputs({folder_.file("input")});
  EXPECT_THROW(outputs.announceRemoval(folder_.file("input")), CIDException);
}

TEST_F(OutputFilesTest, DisappearAgainWhenAnEarlierFileCannotBeRemoved)
{
  fs::create_directory(folder_.file("old"));
  writeText(folder_.file("old/file"), "text");
  writeText(folder_.file("a"), "old");
  writeText(folder_.file("older"), "old");
  OutputFiles outputs({});
  outputs.announce(folder_.file("a"));
  for (const char* const name : {"older", "old"})
    outputs.announceRemoval(folder_.file(name));
  outputs.write(folder_.file("a"), write_new);
  EXPECT_THROW(outputs.commit(), CIDException);
  EXPECT_EQ(folder_.names(), (Names{"a", "old", "older"}));
  for (const char* const name : {"a", "older"})
    EXPECT_EQ(readText(folder_.file(name)), "old");
}

TEST_F(OutputFilesTest, MustBeAnnounced)
{
  OutputFiles outputs({});
  EXPECT_THROW(outputs.write(folder_.file("a"), write_new), CIDException);
}

} // namespace
} // namespace pcl_cid::test
