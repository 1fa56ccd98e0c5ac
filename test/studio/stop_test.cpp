/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The server ends in order, whatever is going on.
 */

#include "clients_of_tests.h"
#include "running_server.h"

#include <chrono>
#include <csignal>
#include <future>
#include <list>
#include <set>
#include <thread>

#include <boost/asio/buffer.hpp>
#include <gtest/gtest.h>

namespace pcl_cid::studio::test {
namespace {

namespace websocket = boost::beast::websocket;
using Lines = std::vector<std::string>;

TEST(StopThreadTest, SaysGoodbyeToThePages)
{
  RunningServer server;
  SocketClient first(*server);
  SocketClient second(*server);
  std::thread reader(
      [&] { EXPECT_EQ(first.waitForEnd().code, websocket::close_code::going_away); });
  server.handler().waitFor(2);
  server->stop();
  EXPECT_EQ(second.waitForEnd().code, websocket::close_code::going_away);
  reader.join();
  server.join();
  const Lines lines = server.handler().waitFor(4);
  EXPECT_EQ((std::set<std::string>{lines[2], lines[3]}),
            (std::set<std::string>{"closed 1", "closed 2"}));
}

TEST(StopThreadTest, MayComeBeforeTheRun)
{
  FewResources resources;
  RecordingHandler handler;
  LocalServer server(resources, handler);
  server.stop();
  server.stop();
  server.run();
}

TEST(StopThreadTest, NeedsNoRun)
{
  FewResources resources;
  RecordingHandler handler;
  LocalServer server(resources, handler);
  server.send(1, frameOf());
}

TEST(StopThreadTest, MayComeAgainAndAfterTheRun)
{
  RunningServer server;
  std::list<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&] { server->stop(); });
  for (std::thread& thread : threads)
    thread.join();
  server.join();
  server->stop();
  server->broadcast(frameOf());
}

TEST(StopThreadTest, DoesNotWaitForWhoDoesNotListen)
{
  ServerLimits limits;
  limits.close_time = std::chrono::milliseconds(50);
  RunningServer server(limits);
  SocketClient silent(*server); // does not answer the good-bye
  SocketClient clogged(*server);
  RawConnection idle(*server);
  RawConnection half(*server);
  half.write("GET / HT");
  server.handler().waitFor(2);
  Frame large;
  large.arrays = {{"a", std::vector<float>(std::size_t{16} << 20)}};
  server->send(2, std::move(large));
  server->stop();
  server.join(); // would wait forever
}

TEST(StopThreadTest, CutsDownloads)
{
  FewResources resources;
  resources.table["/"] = textResource(std::string(std::size_t{64} << 20, 'x'));
  RunningServer server(resources, {});
  RawConnection client(*server);
  client.write("GET / HTTP/1.1\r\nHost: " + hostOf(*server) +
               "\r\nCookie: " + cookieOf(*server) + "\r\n\r\n");
  char byte = 0;
  client.socket().read_some(boost::asio::buffer(&byte, 1)); // it has begun
  server->stop();
  server.join();
  EXPECT_LT(client.readAll().size(), std::size_t{64} << 20);
}

TEST(StopThreadTest, WhileThreadsSend)
{
  RunningServer server;
  SocketClient client(*server);
  server.handler().waitFor(1);
  std::thread sender([&] {
    for (int k = 0; k < 1000; ++k)
      server->send(1, frameOf({{"n", k}}));
  });
  client.receive();
  server->stop();
  EXPECT_EQ(client.waitForEnd().code, websocket::close_code::going_away);
  sender.join();
  server.join();
}

TEST(StopThreadTest, FromAMessage)
{
  LocalServer* server = nullptr;
  RunningServer running({}, [&](ClientId, const Frame&) { server->stop(); });
  server = &*running;
  SocketClient client(*running);
  client.send(frameOf());
  EXPECT_EQ(client.waitForEnd().code, websocket::close_code::going_away);
  running.join();
}

TEST(StopThreadTest, BySignals)
{
  for (const int signal : {SIGINT, SIGTERM}) {
    FewResources resources;
    RecordingHandler handler;
    LocalServer server(resources, handler);
    server.stopOnSignals();
    std::thread thread([&] { server.run(); });
    std::raise(signal);
    thread.join();
  }
}

/** What is behind the sockets must not throw; if it does, nothing is left behind. */
TEST(StopThreadTest, AFailureOfTheHandlerEndsTheRun)
{
  FewResources resources;
  RecordingHandler handler;
  handler.on_message = [](ClientId, const Frame&) { throw std::runtime_error("bug"); };
  LocalServer server(resources, handler);
  std::thread thread([&] { EXPECT_THROW(server.run(), std::runtime_error); });
  SocketClient client(server);
  client.send(frameOf());
  thread.join();
}

} // namespace
} // namespace pcl_cid::studio::test
