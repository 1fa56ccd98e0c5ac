/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The socket: frames, the writer, and pages that misbehave.
 */

#include "clients_of_tests.h"
#include "running_server.h"

#include <atomic>
#include <chrono>
#include <list>
#include <thread>

#include <boost/asio/buffer.hpp>
#include <gtest/gtest.h>

namespace pcl_cid::studio::test {
namespace {

namespace websocket = boost::beast::websocket;
using nlohmann::json;
using std::chrono::milliseconds;
using Ids = std::vector<std::uint32_t>;
using Lines = std::vector<std::string>;

/** A frame of many numbers that begin with some. */
Frame
largeFrame(json header, std::size_t length)
{
  Frame frame = frameOf(std::move(header));
  Ids ids(length);
  for (std::size_t k = 0; k < length; ++k)
    ids[k] = static_cast<std::uint32_t>(k * 2654435761u);
  frame.arrays = {{"ids", std::move(ids)}};
  return frame;
}

TEST(SocketThreadTest, CarriesFramesBothWays)
{
  RunningServer server;
  SocketClient client(*server);
  for (const std::size_t length : {0, 1, 1000, 262143, 262144, 10000000}) {
    const Frame sent = largeFrame({{"id", length}}, length);
    client.send(sent);
    const Frame back = client.receive();
    EXPECT_TRUE(client.stream().got_binary());
    EXPECT_EQ(back.header, sent.header);
    ASSERT_EQ(back.arrays.size(), 1u);
    EXPECT_TRUE(back.arrays[0].values == sent.arrays[0].values) << length;
  }
}

TEST(SocketThreadTest, TheFirstPageIsTheWriter)
{
  RunningServer server;
  SocketClient first(*server);
  SocketClient second(*server);
  SocketClient third(*server);
  second.close();
  server.handler().waitFor(4);
  first.close();
  server.handler().waitFor(6);
  SocketClient fourth(*server);
  third.close();
  server.handler().waitFor(9);
  fourth.close();
  server.handler().waitFor(10);
  SocketClient fifth(*server);
  EXPECT_EQ(server.handler().waitFor(11),
            (Lines{"opened 1 writer",
                   "opened 2",
                   "opened 3",
                   "closed 2",
                   "closed 1",
                   "promoted 3",
                   "opened 4",
                   "closed 3",
                   "promoted 4",
                   "closed 4",
                   "opened 5 writer"}));
}

/** A page whose process was killed says no good-bye. */
TEST(SocketThreadTest, APageThatVanishesIsClosed)
{
  RunningServer server;
  {
    SocketClient client(*server);
    server.handler().waitFor(1);
  }
  EXPECT_EQ(server.handler().waitFor(2).back(), "closed 1");
}

TEST(SocketThreadTest, SendsToOneAndToAllButOne)
{
  RunningServer server;
  SocketClient first(*server);
  SocketClient second(*server);
  server.handler().waitFor(2);
  server->send(2, frameOf({{"n", 1}}));
  server->broadcast(frameOf({{"n", 2}}), 2);
  server->broadcast(frameOf({{"n", 3}}));
  server->send(77, frameOf({{"n", 4}})); // to nobody
  EXPECT_EQ(first.receive().header["n"], 2);
  EXPECT_EQ(first.receive().header["n"], 3);
  EXPECT_EQ(second.receive().header["n"], 1);
  EXPECT_EQ(second.receive().header["n"], 3);
}

TEST(SocketThreadTest, AnswersAMalformedFrameAndGoesOn)
{
  RunningServer server;
  SocketClient client(*server);
  for (const std::string& bytes : {std::string(),
                                   std::string("abc"),
                                   std::string("\xff\xff\xff\xff", 4),
                                   std::string("\2\0\0\0[]\0\0", 8),
                                   std::string("\2\0\0\0{}", 6),
                                   std::string("\2\0\0\0{}\0\0\0", 9)}) {
    client.sendBytes(bytes);
    const json answer = client.receive().header;
    EXPECT_TRUE(answer["id"].is_null());
    EXPECT_EQ(answer["ok"], false);
    EXPECT_FALSE(answer["error"].get<std::string>().empty());
  }
  client.send(frameOf({{"id", 5}}));
  EXPECT_EQ(client.receive().header["id"], 5);
  EXPECT_EQ(server.handler().waitFor(2).back(), "message 1");
}

TEST(SocketThreadTest, ClosesOnText)
{
  RunningServer server;
  SocketClient client(*server);
  client.sendBytes("{}", false);
  const auto reason = client.waitForEnd();
  EXPECT_EQ(reason.code, websocket::close_code::unknown_data);
  EXPECT_EQ(reason.reason, "Messages are binary.");
  EXPECT_EQ(server.handler().waitFor(2), (Lines{"opened 1 writer", "closed 1"}));
}

TEST(SocketThreadTest, ClosesOnAMessageThatIsTooLong)
{
  ServerLimits limits;
  limits.most_received = 1000;
  RunningServer server(limits);
  SocketClient client(*server);
  client.send(largeFrame({}, 200));
  EXPECT_EQ(client.receive().arrays.size(), 1u);
  client.sendBytes(std::string(1001, 'x'));
  EXPECT_EQ(client.waitForEnd().code, websocket::close_code::too_big);
  EXPECT_EQ(server.handler().waitFor(3).back(), "closed 1");
}

TEST(SocketThreadTest, ClosesOnBytesThatAreNoFrames)
{
  RunningServer server;
  SocketClient client(*server);
  const std::string unmasked("\x82\x01x", 3);
  client.stream().next_layer().write_some(boost::asio::buffer(unmasked));
  EXPECT_EQ(client.waitForEnd().code, websocket::close_code::protocol_error);
  EXPECT_EQ(server.handler().waitFor(2).back(), "closed 1");
}

TEST(SocketThreadTest, RefusesWhoDoesNotWaitForTheHandshake)
{
  RunningServer server;
  RawConnection client(*server);
  client.write("GET /api/session HTTP/1.1\r\nHost: " + hostOf(*server) +
               "\r\nOrigin: http://" + hostOf(*server) +
               "\r\nCookie: " + cookieOf(*server) +
               "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
               "Sec-WebSocket-Version: 13\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\nx");
  EXPECT_EQ(client.readAll().substr(0, 12), "HTTP/1.1 400");
}

/** From several threads at once, small ones and ones that go in pieces. */
TEST(SocketThreadTest, FramesOfThreadsArriveWholeAndInOrder)
{
  constexpr int threads = 4;
  constexpr int frames = 100;
  RunningServer server;
  SocketClient client(*server);
  server.handler().waitFor(1);
  std::list<std::thread> senders;
  for (int t = 0; t < threads; ++t)
    senders.emplace_back([&server, t] {
      for (int k = 0; k < frames; ++k) {
        const std::size_t length = k % 10 == 0 ? 700000 : static_cast<std::size_t>(k);
        Frame frame = largeFrame({{"thread", t}, {"number", k}}, length);
        if (k % 2 == 0)
          server->send(1, std::move(frame));
        else
          server->broadcast(std::move(frame));
      }
    });
  int next[threads] = {};
  for (int k = 0; k < threads * frames; ++k) {
    const Frame frame = client.receive();
    const int t = frame.header["thread"];
    ASSERT_EQ(frame.header["number"], next[t]++);
    const Ids& ids = *frame.array<std::uint32_t>("ids");
    ASSERT_TRUE(ids == *largeFrame({}, ids.size()).array<std::uint32_t>("ids"));
  }
  for (std::thread& sender : senders)
    sender.join();
}

/** What the thread of the server sends first arrives first, though another thread sends
 *  while that one is still busy. */
TEST(SocketThreadTest, FramesKeepTheirOrderAcrossThreads)
{
  LocalServer* server = nullptr;
  RunningServer running({}, [&](ClientId client, const Frame& /*frame*/) {
    server->send(client, frameOf({{"n", 1}}));
    std::thread([&] { server->send(client, frameOf({{"n", 2}})); }).join();
    server->send(client, frameOf({{"n", 3}}));
  });
  server = &*running;
  SocketClient client(*running);
  for (int round = 0; round < 50; ++round) {
    client.send(frameOf());
    for (int n = 1; n <= 3; ++n)
      ASSERT_EQ(client.receive().header["n"], n);
  }
}

TEST(SocketThreadTest, ClosesAPageThatDoesNotRead)
{
  ServerLimits limits;
  limits.most_waiting = std::size_t{4} << 20;
  RunningServer server(limits);
  SocketClient lazy(*server);
  SocketClient busy(*server);
  server.handler().waitFor(2);
  for (int k = 0; k < 64; ++k) { // 64 MB, more than the system keeps for a connection
    server->send(1, largeFrame({}, 250000));
    server->send(2, largeFrame({{"n", k}}, 1000));
    EXPECT_EQ(busy.receive().header["n"], k);
  }
  EXPECT_EQ(server.handler().waitFor(4),
            (Lines{"opened 1 writer", "opened 2", "closed 1", "promoted 2"}));
}

TEST(SocketThreadTest, SendsOneMessageOfAnyLength)
{
  ServerLimits limits;
  limits.most_waiting = 1000;
  RunningServer server(limits);
  SocketClient client(*server);
  server.handler().waitFor(1);
  server->send(1, largeFrame({}, 8000000));
  EXPECT_EQ(client.receive().array<std::uint32_t>("ids")->size(), 8000000u);
}

TEST(SocketThreadTest, GivesUpAPageThatDoesNotAnswerPings)
{
  ServerLimits limits;
  limits.ping_time = milliseconds(30);
  RunningServer server(limits);
  SocketClient dead(*server); // reads nothing, so it answers nothing
  EXPECT_EQ(server.handler().waitFor(2).back(), "closed 1");
}

TEST(SocketThreadTest, KeepsASilentPageThatAnswersPings)
{
  ServerLimits limits;
  limits.ping_time = milliseconds(100);
  RunningServer server(limits);
  SocketClient client(*server);
  int pings = 0;
  client.stream().control_callback([&](websocket::frame_type type, auto /*text*/) {
    if (type == websocket::frame_type::ping && ++pings == 6)
      server->send(1, frameOf({{"n", 1}}));
  });
  EXPECT_EQ(client.receive().header["n"], 1);
}

/** For longer than a page may be silent, twice, with a second page that only listens.
 */
TEST(SocketThreadTest, KeepsPagesWhileTheServerIsBusy)
{
  ServerLimits limits;
  limits.ping_time = milliseconds(100);
  LocalServer* server = nullptr;
  RunningServer running(limits, [&](ClientId /*client*/, Frame frame) {
    std::this_thread::sleep_for(milliseconds(500));
    server->broadcast(std::move(frame));
  });
  server = &*running;
  SocketClient working(*running);
  SocketClient listening(*running);
  running.handler().waitFor(2);
  std::thread listener([&] {
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(listening.receive().header["n"], k);
  });
  for (int k = 0; k < 3; ++k)
    working.send(frameOf({{"n", k}}));
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(working.receive().header["n"], k);
  listener.join();
}

} // namespace
} // namespace pcl_cid::studio::test
