/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Frames go through the socket unchanged, and what is no frame is refused.
 */

#include "clients_of_tests.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace pcl_cid::studio::test {
namespace {

using nlohmann::json;
using Ids = std::vector<std::uint32_t>;
using Floats = std::vector<float>;

/** A header as it is written, with padding, and what comes after it. */
std::string
rawFrame(const std::string& header, const std::string& rest = "")
{
  const auto length = static_cast<std::uint32_t>(header.size());
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &length, 4);
  return bytes + header + std::string((4 - header.size() % 4) % 4, '\0') + rest;
}

std::string
complaintOf(const std::string& bytes)
{
  try {
    decodeFrame(bytes);
  }
  catch (const BadFrame& error) {
    return error.what();
  }
  return "";
}

TEST(FrameTest, ComesBackAsItWas)
{
  for (const std::string word : {"", "a", "ab", "abc", "abcd"}) {
    Frame frame = frameOf({{"id", 7}, {"word", word}});
    frame.arrays = {{"places", Ids{0, 1, 4294967295u}},
                    {"none", Floats{}},
                    {"cid", Floats{-1.5f, std::numeric_limits<float>::infinity()}}};
    const EncodedFrame encoded(frame);
    const std::string bytes = bytesOf(encoded);
    EXPECT_EQ(bytes.size(), encoded.size());
    EXPECT_EQ(bytes.size() % 4, 0u);

    const Frame back = decodeFrame(bytes);
    EXPECT_EQ(back.header, json({{"id", 7}, {"word", word}}));
    ASSERT_EQ(back.arrays.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(back.arrays[k].name, frame.arrays[k].name);
      EXPECT_EQ(back.arrays[k].values, frame.arrays[k].values);
    }
  }
}

TEST(FrameTest, IsLaidOutAsTheProtocolSays)
{
  Frame frame;
  frame.arrays = {{"p", Ids{258}}};
  const std::string header = R"({"arrays":[{"length":1,"name":"p","type":"u32"}]})";
  EXPECT_EQ(bytesOf(EncodedFrame(frame)), rawFrame(header, {"\2\1\0\0", 4}));
  EXPECT_EQ(bytesOf(EncodedFrame(frameOf({{"a", 1}}))), rawFrame(R"({"a":1})"));
}

TEST(FrameTest, FindsArraysByNameAndType)
{
  Frame frame;
  frame.arrays = {{"a", Ids{1}}, {"b", Floats{2}}};
  EXPECT_EQ(*frame.array<std::uint32_t>("a"), Ids{1});
  EXPECT_EQ(*frame.array<float>("b"), Floats{2});
  EXPECT_EQ(frame.array<float>("a"), nullptr);
  EXPECT_EQ(frame.array<float>("c"), nullptr);
}

TEST(FrameTest, KeepsNaN)
{
  Frame frame;
  frame.arrays = {{"doubt", Floats{std::numeric_limits<float>::quiet_NaN()}}};
  const Frame back = decodeFrame(bytesOf(EncodedFrame(frame)));
  EXPECT_TRUE(std::isnan(back.array<float>("doubt")->at(0)));
}

TEST(FrameTest, DoesNotMoveTheArraysWhenItIsEncoded)
{
  Frame frame;
  frame.arrays = {{"large", Ids(1000)}};
  const void* const values = frame.array<std::uint32_t>("large")->data();
  const EncodedFrame encoded(std::move(frame));
  EXPECT_EQ(static_cast<const void*>(encoded.pieces().at(1).data()), values);
}

TEST(FrameTest, MendsTextThatIsNotUtf8)
{
  const Frame back = decodeFrame(bytesOf(EncodedFrame(frameOf({{"name", "\xff"}}))));
  EXPECT_EQ(back.header["name"], "\xef\xbf\xbd");
}

TEST(FrameTest, TakesAnEmptyListOfArrays)
{
  EXPECT_EQ(decodeFrame(rawFrame(R"({"arrays": []})")).header, json::object());
}

struct BadCase {
  const char* name;
  std::string bytes;
  const char* complaint; ///< a part of the sentence
};

std::string
listing(const std::string& entries)
{
  return R"({"arrays": [)" + entries + "]}";
}

const std::vector<BadCase> bad_cases = {
    {"Empty", "", "0 bytes"},
    {"Short", std::string("\1\0\0", 3), "3 bytes"},
    {"NoHeader", std::string(4, '\0'), "not JSON"},
    {"HeaderBeyondTheFrame", rawFrame("{}").substr(0, 5), "more than the frame"},
    {"NoPadding", rawFrame("{}").substr(0, 6), "more than the frame"},
    {"OtherPadding", rawFrame("{}").replace(7, 1, "x"), "not 0"},
    {"SpacesForPadding", std::string("\2\0\0\0{}  ", 8), "not 0"},
    {"LargestHeader", std::string("\xff\xff\xff\xff{}\0\0", 8), "at most"},
    {"LongHeader", rawFrame("{" + std::string(1u << 20, ' ') + "}"), "at most"},
    {"NotJson", rawFrame("{\"a\": }"), "not JSON"},
    {"NotUtf8", rawFrame("{\"a\": \"\xff\"}"), "not JSON"},
    {"HugeNumber", rawFrame("{\"a\": 1e999}"), "not JSON"},
    {"TextAfterTheObject", rawFrame("{} {}"), "not JSON"},
    {"Text", rawFrame("\"text\""), "not an object"},
    {"List", rawFrame("[1]"), "not an object"},
    {"Null", rawFrame("null"), "not an object"},
    {"Deep",
     rawFrame("{\"a\": " + std::string(100000, '[') + std::string(100000, ']') + "}"),
     "nested"},
    {"DeepAndOpen", rawFrame(std::string(100000, '[')), "nested"},
    {"ArraysNoList", rawFrame(R"({"arrays": {}})"), "not a list"},
    {"EntryNoObject", rawFrame(listing("1")), "needs a name"},
    {"NoName", rawFrame(listing(R"({"type": "u32", "length": 0})")), "needs a name"},
    {"NameNoText",
     rawFrame(listing(R"({"name": 1, "type": "u32", "length": 0})")),
     "needs a name"},
    {"UnknownType",
     rawFrame(listing(R"({"name": "a", "type": "u16", "length": 0})")),
     "needs a name"},
    {"TypeNoText",
     rawFrame(listing(R"({"name": "a", "type": 32, "length": 0})")),
     "needs a name"},
    {"NoLength", rawFrame(listing(R"({"name": "a", "type": "u32"})")), "needs a name"},
    {"NegativeLength",
     rawFrame(listing(R"({"name": "a", "type": "u32", "length": -1})")),
     "needs a name"},
    {"FractionalLength",
     rawFrame(listing(R"({"name": "a", "type": "u32", "length": 1.0})"), "1234"),
     "needs a name"},
    {"UnknownKey",
     rawFrame(listing(R"({"name": "a", "type": "u32", "length": 0, "x": 0})")),
     "nothing else"},
    {"SameName",
     rawFrame(listing(R"({"name": "a", "type": "u32", "length": 0},)"
                      R"({"name": "a", "type": "f32", "length": 0})")),
     "same name"},
    {"TooFewNumbers",
     rawFrame(listing(R"({"name": "a", "type": "u32", "length": 2})"), "1234"),
     "longer than the frame"},
    {"HalfANumber",
     rawFrame(listing(R"({"name": "a", "type": "u32", "length": 2})"), "123456"),
     "longer than the frame"},
    {"OverflowingLength",
     rawFrame(listing(R"({"name": "a", "type": "u32", "length": 4611686018427387905})"),
              "1234"),
     "longer than the frame"},
    {"LengthsThatAddUpToOverflow",
     rawFrame(
         listing(R"({"name": "a", "type": "u32", "length": 1},)"
                 R"({"name": "b", "type": "u32", "length": 18446744073709551615})"),
         "1234"),
     "longer than the frame"},
    {"BytesLeft",
     rawFrame(listing(R"({"name": "a", "type": "u32", "length": 1})"), "12345678"),
     "4 bytes more"},
    {"BytesWithoutArrays", rawFrame("{}", "1"), "1 bytes more"},
};

class BadFrameTest : public testing::TestWithParam<BadCase> {};

TEST_P(BadFrameTest, IsRefusedInASentence)
{
  EXPECT_NE(complaintOf(GetParam().bytes).find(GetParam().complaint), std::string::npos)
      << complaintOf(GetParam().bytes);
}

INSTANTIATE_TEST_SUITE_P(FrameTest,
                         BadFrameTest,
                         testing::ValuesIn(bad_cases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(FrameTest, IsRefusedWhereverItIsCut)
{
  Frame frame = frameOf({{"id", 1}});
  frame.arrays = {{"a", Ids{1, 2, 3}}, {"b", Floats{4}}};
  const std::string bytes = bytesOf(EncodedFrame(frame));
  EXPECT_EQ(complaintOf(bytes), "");
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(complaintOf(bytes.substr(0, size)), "") << size;
}

TEST(FrameTest, SurvivesDamage)
{
  Frame frame = frameOf({{"id", 1}});
  frame.arrays = {{"a", Ids{1, 2, 3}}, {"b", Floats{4}}};
  const std::string bytes = bytesOf(EncodedFrame(frame));
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    std::string damaged = bytes;
    for (int k = 0; k < 3; ++k)
      damaged[random() % damaged.size()] = static_cast<char>(random());
    try {
      decodeFrame(damaged);
    }
    catch (const BadFrame&) {
    }
  }
}

} // namespace
} // namespace pcl_cid::studio::test
