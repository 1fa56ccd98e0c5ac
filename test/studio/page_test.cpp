/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page from a folder and in the program.
 */

#include "server/content_type.h"
#include "server/embedded_page.h"
#include "server/page_folder.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <stdlib.h>
#include <sys/stat.h>

namespace pcl_cid::studio::test {
namespace {

namespace fs = std::filesystem;

void
writeText(const fs::path& file, const std::string& text)
{
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

std::string
readText(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/** A folder "page" with a folder "secret" beside it, for the time of a test. */
class PageFolderTest : public testing::Test {
protected:
  PageFolderTest()
  {
    std::string name = fs::temp_directory_path() / "pcl_cid_page_XXXXXX";
    if (!mkdtemp(name.data()))
      throw std::runtime_error("cannot make a folder");
    around_ = name;
    writeText(around_ / "page/index.html", "index");
    writeText(around_ / "page/assets/a.js", "script");
    writeText(around_ / "page/.hidden", "hidden");
    writeText(around_ / "secret/key.txt", "secret");
    writeText(around_ / "page2/key.txt", "secret");
  }

  ~PageFolderTest() override { fs::remove_all(around_); }

  std::string
  find(const std::string& path) const
  {
    const auto found = PageFolder(around_ / "page").find(path);
    return found ? std::string(found->body) : "nothing";
  }

  fs::path around_;
};

TEST_F(PageFolderTest, ServesItsFiles)
{
  EXPECT_EQ(find("/"), "index");
  EXPECT_EQ(find("/index.html"), "index");
  EXPECT_EQ(find("/assets/a.js"), "script");
  const auto script = PageFolder(around_ / "page").find("/assets/a.js");
  EXPECT_EQ(script->content_type, "text/javascript; charset=utf-8");
  EXPECT_FALSE(script->is_gzip);
}

TEST_F(PageFolderTest, ReadsAFileAgain)
{
  const PageFolder page(around_ / "page");
  const auto before = page.find("/");
  writeText(around_ / "page/index.html", "changed");
  EXPECT_EQ(page.find("/")->body, "changed");
  EXPECT_EQ(before->body, "index");
}

TEST_F(PageFolderTest, ServesNothingElse)
{
  for (const std::string& path : {std::string(),
                                  std::string("index.html"),
                                  std::string("/nothing"),
                                  std::string("/assets"),
                                  std::string("/assets/"),
                                  std::string("/index.html/"),
                                  std::string("//index.html"),
                                  std::string("/assets//a.js"),
                                  std::string("/./index.html"),
                                  std::string("/assets/../index.html"),
                                  std::string("/../secret/key.txt"),
                                  std::string("/../page2/key.txt"),
                                  std::string("/assets/../../secret/key.txt"),
                                  std::string("/%2e%2e/secret/key.txt"),
                                  "/" + (around_ / "secret/key.txt").string(),
                                  (around_ / "secret/key.txt").string(),
                                  std::string("/.hidden"),
                                  std::string("/index.html\0.js", 15),
                                  "/" + std::string(10000, 'x')})
    EXPECT_EQ(find(path), "nothing") << path;
}

TEST_F(PageFolderTest, FollowsLinksWithin)
{
  fs::create_symlink("index.html", around_ / "page/again.html");
  fs::create_symlink(around_ / "page", around_ / "link");
  EXPECT_EQ(find("/again.html"), "index");
  EXPECT_EQ(PageFolder(around_ / "link").find("/")->body, "index");
}

TEST_F(PageFolderTest, DoesNotFollowLinksThatLeave)
{
  fs::create_symlink("../secret/key.txt", around_ / "page/key.txt");
  fs::create_symlink(around_ / "secret", around_ / "page/folder");
  fs::create_symlink("../page2", around_ / "page/beside");
  fs::create_symlink("loop", around_ / "page/loop");
  for (const char* path : {"/key.txt", "/folder/key.txt", "/beside/key.txt", "/loop"})
    EXPECT_EQ(find(path), "nothing") << path;
}

/** Opening one would wait for who writes into it. */
TEST_F(PageFolderTest, DoesNotOpenWhatIsNoFile)
{
  ASSERT_EQ(mkfifo((around_ / "page/pipe").c_str(), 0600), 0);
  EXPECT_EQ(find("/pipe"), "nothing");
}

TEST_F(PageFolderTest, NeedsAFolder)
{
  EXPECT_THROW(PageFolder(around_ / "none"), fs::filesystem_error);
  EXPECT_THROW(PageFolder(around_ / "page/index.html"), fs::filesystem_error);
}

TEST(ContentTypeTest, GoesByTheExtension)
{
  EXPECT_EQ(contentType("/index.html"), "text/html; charset=utf-8");
  EXPECT_EQ(contentType("/a.b/c.svg"), "image/svg+xml");
  EXPECT_EQ(contentType("/a.css/c"), "application/octet-stream");
  EXPECT_EQ(contentType("/a.woff2"), "font/woff2");
  EXPECT_EQ(contentType("/a.js.map"), "application/json");
  EXPECT_EQ(contentType(""), "application/octet-stream");
}

/** What `gzip -d` makes of some bytes. */
std::string
unpacked(std::string_view bytes)
{
  const fs::path file = testing::TempDir() + "pcl_cid_embedded.gz";
  std::ofstream(file, std::ios::binary) << bytes;
  FILE* const pipe = popen(("gzip -dc '" + file.string() + "'").c_str(), "r");
  std::string text;
  std::array<char, 4096> some{};
  while (const std::size_t read = fread(some.data(), 1, some.size(), pipe))
    text.append(some.data(), read);
  EXPECT_EQ(pclose(pipe), 0);
  fs::remove(file);
  return text;
}

TEST(EmbeddedPageTest, HasAllFilesOfTheFolder)
{
  const fs::path folder = PCL_CID_SMALL_PAGE;
  for (const char* path : {"/index.html", "/assets/script-B_1.js", "/empty.css"}) {
    const auto found = embeddedPage().find(path);
    ASSERT_TRUE(found) << path;
    EXPECT_TRUE(found->is_gzip);
    EXPECT_EQ(unpacked(found->body), readText(folder / (path + 1))) << path;
    EXPECT_EQ(found->content_type, contentType(path));
  }
  EXPECT_EQ(embeddedPage().find("/")->body, embeddedPage().find("/index.html")->body);
}

TEST(EmbeddedPageTest, LeavesWhatIsCompressedAlready)
{
  const auto found = embeddedPage().find("/dot.png");
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->is_gzip);
  EXPECT_EQ(found->body, readText(fs::path(PCL_CID_SMALL_PAGE) / "dot.png"));
}

TEST(EmbeddedPageTest, HasNothingElse)
{
  for (const char* path : {"", "/nothing", "/assets", "index.html", "/assets/../"})
    EXPECT_FALSE(embeddedPage().find(path)) << path;
}

} // namespace
} // namespace pcl_cid::studio::test
