/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels written as SemanticKITTI has them.
 */

#include "cloud_files.h"
#include "python_reader.h"

#include <pcl_cid/io/semantic_kitti.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Strings = std::vector<std::string>;
using Labels = std::vector<std::uint32_t>;
using Json = nlohmann::json;

class SemanticKitti : public testing::Test {
protected:
  void
  write(const LabelledInstances& scan,
        const SemanticClasses& classes = semanticKittiClasses())
  {
    OutputFiles outputs({});
    writeSemanticKitti(scan, classes, path_, outputs);
    outputs.commit();
  }

  Json
  writeAndRead(const LabelledInstances& scan,
               const SemanticClasses& classes = semanticKittiClasses())
  {
    write(scan, classes);
    return readByPython({"kitti", path_});
  }

  std::string
  complaint(const LabelledInstances& scan,
            const SemanticClasses& classes = semanticKittiClasses())
  {
    return complaintAbout(path_, [&] { write(scan, classes); });
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("000000.label");
};

LabelledInstances
manyInstances(std::uint32_t count)
{
  LabelledInstances scan;
  for (std::uint32_t i = 0; i < count; ++i) {
    scan.label.push_back(1000000 - i);
    scan.instances.push_back({1000000 - i, "car", ""});
  }
  return scan;
}

TEST_F(SemanticKitti, HasClassAndInstanceInOneWord)
{
  const Json read = writeAndRead(
      {{70, 0, 8, 8, 70}, {{70, "building", "the \"old\" one"}, {8, "car", ""}}});
  EXPECT_EQ(read["class"], (Labels{50, 0, 10, 10, 50}));
  EXPECT_EQ(read["instance"], (Labels{2, 0, 1, 1, 2}));
  EXPECT_EQ(read["labels"]["0"], "unlabeled");
  EXPECT_EQ(read["labels"]["10"], "car");
  EXPECT_EQ(read["labels"].size(), semanticKittiClasses().size() + 1);
  EXPECT_EQ(read["instances"]["1"], Json({10, 8, ""}));
  EXPECT_EQ(read["instances"]["2"], Json({50, 70, "the \"old\" one"}));
  // The bytes, whatever machine reads them.
  EXPECT_EQ(readText(path_).substr(0, 4), std::string("\x32\x00\x02\x00", 4));
}

TEST_F(SemanticKitti, NumbersOtherClassesAfterThoseOfTheTable)
{
  const LabelledInstances scan = {{1, 2, 3, 4, 5, 6},
                                  {{1, "sofa", ""},
                                   {2, "a: {b}\n#", ""},
                                   {3, "", ""},
                                   {4, "unlabeled", "\x7F \xE2\x80\xA8 \xC2\x85"},
                                   {5, "St\xC3\xBChle", ""},
                                   {6, "sofa", "\xF0\x9F\x9B\x8B"}}};
  const Json read = writeAndRead(scan);
  EXPECT_EQ(read["class"], (Labels{262, 261, 0, 0, 260, 262}));
  EXPECT_EQ(read["instance"], (Labels{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(read["labels"]["260"], "St\xC3\xBChle");
  EXPECT_EQ(read["labels"]["261"], "a: {b}\n#");
  EXPECT_EQ(read["instances"]["4"][2], "\x7F \xE2\x80\xA8 \xC2\x85");
  EXPECT_EQ(read["instances"]["6"][2], "\xF0\x9F\x9B\x8B");
  EXPECT_EQ(writeAndRead(scan, {{5, "sofa"}})["class"], (Labels{5, 7, 0, 0, 6, 5}));
  EXPECT_EQ(writeAndRead(scan, {})["class"], (Labels{3, 2, 0, 0, 1, 3}));
}

TEST_F(SemanticKitti, MayHaveNoPointAndNoInstance)
{
  EXPECT_EQ(writeAndRead({})["class"], Json::array());
  EXPECT_EQ(readText(path_), "");
  const Json read = writeAndRead({{0, 0}, {{3, "car", ""}}});
  EXPECT_EQ(read["class"], (Labels{0, 0}));
  EXPECT_EQ(read["instance"], (Labels{0, 0}));
  EXPECT_EQ(read["instances"], Json::object());
}

TEST_F(SemanticKitti, HoldsSixteenBitsOfEach)
{
  const Json most = writeAndRead(manyInstances(65535));
  EXPECT_EQ(most["instance"][0], 65535);
  EXPECT_EQ(most["instance"][65534], 1);
  EXPECT_EQ(most["class"][0], 10);
  EXPECT_EQ(complaint(manyInstances(70000)),
            ": the scan has 70000 instances; a .label holds at most 65535");
  EXPECT_EQ(complaint({{1}, {{1, "b", ""}}}, {{65535, "a"}}),
            ": the class 'b' has the number 65536; a .label holds at most 65535");
  EXPECT_EQ(complaint({}, {{4294967295, "a"}}),
            ": the class 'a' has the number 4294967295; a .label holds at most 65535");
}

TEST_F(SemanticKitti, RefusesOtherNamesAndLabels)
{
  EXPECT_EQ(
      complaint({{3}, {}}),
      ": point 0 has the label 3, which is of no instance; it must be that of one, "
      "or 0");
  path_ = folder_.file("000000.bin");
  EXPECT_EQ(complaint({}),
            ": is no name for labels of SemanticKITTI; it must end with .label");
  EXPECT_EQ(folder_.names(), Strings{});
}

} // namespace
} // namespace pcl_cid::test
