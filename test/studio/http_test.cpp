/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * HTTP as browsers speak it, and as nobody should.
 */

#include "clients_of_tests.h"
#include "running_server.h"

#include <chrono>
#include <future>
#include <list>
#include <random>

#include <gtest/gtest.h>

namespace pcl_cid::studio::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

std::string
get(RunningServer& server, const std::string& target = "/")
{
  std::string request = "GET " + target + " HTTP/1.1\r\n";
  for (const auto& [name, value] : ownFields(*server))
    request += name + ": " + value + "\r\n";
  return request + "\r\n";
}

/** One body, whose end of use can be waited for. */
class WatchedResource : public Resources {
public:
  explicit WatchedResource(std::size_t bytes) : body_(bytes, 'x') {}

  std::optional<Resource>
  find(std::string_view /*path*/) const override
  {
    return Resource{"application/octet-stream",
                    false,
                    body_,
                    {body_.data(), [this](const void*) { given_back_.set_value(); }}};
  }

  const std::string&
  body() const
  {
    return body_;
  }

  void
  waitUntilGivenBack() const
  {
    given_back_.get_future().wait();
  }

private:
  std::string body_;
  mutable std::promise<void> given_back_;
};

TEST(HttpThreadTest, ServesABodyWithItsTypeAndLength)
{
  RunningServer server;
  const Answer answer = ask(*server, "/", ownFields(*server));
  EXPECT_EQ(answer.body(), "<!DOCTYPE html>page");
  EXPECT_EQ(answer["Content-Type"], "text/html; charset=utf-8");
  EXPECT_EQ(answer["Content-Length"], "19");
}

TEST(HttpThreadTest, HeadHasNoBody)
{
  RunningServer server;
  const Answer answer = ask(*server, "/", ownFields(*server), Verb::head);
  EXPECT_EQ(answer["Content-Length"], "19");
  RawConnection client(*server);
  std::string request = get(server).replace(0, 3, "HEAD");
  client.write(request.insert(request.size() - 2, "Connection: close\r\n"));
  const std::string all = client.readAll();
  EXPECT_EQ(all.substr(all.size() - 4), "\r\n\r\n");
}

TEST(HttpThreadTest, AnswersOnOneConnectionOneAfterTheOther)
{
  RunningServer server;
  RawConnection client(*server);
  for (int k = 0; k < 3; ++k) {
    client.write(get(server));
    EXPECT_EQ(client.read().body(), "<!DOCTYPE html>page");
  }
  client.write(get(server) + get(server, "/nothing") + get(server)); // pipelined
  EXPECT_EQ(client.read().result_int(), 200u);
  EXPECT_EQ(client.read().result_int(), 404u);
  EXPECT_EQ(client.read().result_int(), 200u);
}

TEST(HttpThreadTest, ClosesWhenTheClientWantsIt)
{
  RunningServer server;
  RawConnection client(*server);
  std::string request = get(server);
  client.write(request.insert(request.size() - 2, "Connection: close\r\n"));
  EXPECT_NE(client.readAll().find("Connection: close\r\n"), std::string::npos);
}

TEST(HttpThreadTest, ServesALargeBodyWithoutCopies)
{
  const WatchedResource large(std::size_t{200} << 20);
  RunningServer server(large, {});
  const Answer answer = ask(*server, "/", ownFields(*server));
  EXPECT_TRUE(answer.body() == large.body());
  large.waitUntilGivenBack();
}

TEST(HttpThreadTest, ServesAnEmptyBody)
{
  FewResources resources;
  resources.table["/"] = {"text/plain", false};
  RunningServer server(resources, {});
  EXPECT_EQ(ask(*server, "/", ownFields(*server))["Content-Length"], "0");
}

TEST(HttpThreadTest, ServesGzipToWhoTakesIt)
{
  FewResources resources;
  resources.table["/"] = textResource("gz", "text/css");
  resources.table["/"].is_gzip = true;
  RunningServer server(resources, {});
  Fields fields = ownFields(*server);
  EXPECT_EQ(statusOf(*server, "/", fields), 406u);
  for (const char* codings :
       {"gzip", "br, GZIP", "gzip;q=0.5", "*", "deflate, gzip;q=1.0, br"}) {
    fields["Accept-Encoding"] = codings;
    const Answer answer = ask(*server, "/", fields);
    EXPECT_EQ(answer.body(), "gz") << codings;
    EXPECT_EQ(answer["Content-Encoding"], "gzip");
  }
  for (const char* codings : {"", "br", "gzip;q=0", "gzip; q=0.000, br", "gzippy"}) {
    fields["Accept-Encoding"] = codings;
    EXPECT_EQ(statusOf(*server, "/", fields), 406u) << codings;
  }
}

TEST(HttpThreadTest, DoesNotLookForWhatIsOutside)
{
  RunningServer server;
  for (const char* target :
       {"/../etc/passwd", "/%2e%2e/", "//", "/.", "http://127.0.0.1/", "*", "x"})
    EXPECT_EQ(statusOf(*server, target, ownFields(*server)), 404u) << target;
}

TEST(HttpThreadTest, RefusesALongHeader)
{
  ServerLimits limits;
  limits.most_header = 4096;
  RunningServer server(limits);
  Fields fields = ownFields(*server);
  fields["X"] = std::string(3000, 'x');
  EXPECT_EQ(statusOf(*server, "/", fields), 200u);
  fields["X"] = std::string(5000, 'x');
  EXPECT_EQ(statusOf(*server, "/", fields), 431u);
  fields["X"] = std::string(5000000, 'x');
  RawConnection client(*server);
  client.write("GET /" + std::string(5000000, 'x')); // without end
  EXPECT_NE(client.readAll().find(" 431 "), std::string::npos);
  EXPECT_EQ(statusOf(*server, "/", ownFields(*server)), 200u);
}

TEST(HttpThreadTest, SurvivesGarbage)
{
  RunningServer server;
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    std::string bytes(random() % 3000, '\0');
    for (char& byte : bytes)
      byte = static_cast<char>(random());
    RawConnection client(*server);
    client.write(bytes);
    client.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send);
    const std::string answer = client.readAll();
    EXPECT_TRUE(answer.empty() || answer.find("HTTP/1.1 4") == 0) << answer;
  }
  EXPECT_EQ(statusOf(*server, "/", ownFields(*server)), 200u);
}

TEST(HttpThreadTest, SurvivesDamagedRequests)
{
  RunningServer server;
  const std::string request = get(server);
  std::mt19937 random(2);
  for (int round = 0; round < 300; ++round) {
    std::string damaged = request;
    for (int k = 0; k < 2; ++k)
      damaged[random() % damaged.size()] = static_cast<char>(random());
    RawConnection client(*server);
    client.write(damaged.substr(0, random() % (damaged.size() + 1)));
    client.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send);
    client.readAll();
  }
  EXPECT_EQ(statusOf(*server, "/", ownFields(*server)), 200u);
}

TEST(HttpThreadTest, SaysThatItIsNoRequest)
{
  RunningServer server;
  for (const char* bytes : {"\x16\x03\x01\x02\r\n\r\n", "\r\n\r\n", "GET\r\n\r\n"}) {
    RawConnection client(*server);
    client.write(bytes);
    EXPECT_EQ(client.readAll().substr(0, 12), "HTTP/1.1 400") << bytes;
  }
}

TEST(HttpThreadTest, GivesUpSlowRequests)
{
  ServerLimits limits;
  limits.request_time = milliseconds(100);
  RunningServer server(limits);
  const std::string request = get(server);
  for (const std::string& part : {std::string(), request.substr(0, 20)}) {
    const auto start = steady_clock::now();
    RawConnection client(*server);
    client.write(part);
    EXPECT_EQ(client.readAll(), ""); // returns when the server gives up
    EXPECT_GE(steady_clock::now() - start, milliseconds(90));
  }
}

/** A byte now and then is not enough. */
TEST(HttpThreadTest, GivesUpRequestsThatTrickle)
{
  ServerLimits limits;
  limits.request_time = milliseconds(100);
  RunningServer server(limits);
  RawConnection client(*server);
  boost::system::error_code error;
  while (!error) { // until the connection is reset
    client.socket().write_some(boost::asio::buffer("x", 1), error);
    std::this_thread::sleep_for(milliseconds(10));
  }
}

TEST(HttpThreadTest, GivesUpWhoDoesNotRead)
{
  const WatchedResource large(std::size_t{64} << 20);
  ServerLimits limits;
  limits.write_time = milliseconds(100);
  RunningServer server(large, limits);
  RawConnection client(*server);
  client.write(get(server));
  large.waitUntilGivenBack();
  EXPECT_LT(client.readAll().size(), large.body().size());
}

TEST(HttpThreadTest, LimitsConnections)
{
  ServerLimits limits;
  limits.most_connections = 4;
  RunningServer server(limits);
  const std::string request = get(server);
  std::list<RawConnection> clients;
  for (std::size_t k = 0; k < limits.most_connections; ++k) {
    clients.emplace_back(*server);
    clients.back().write(request);
    // What came before, as the question for the token, may not have gone yet.
    while (clients.back().read().result_int() == 503) {
      clients.pop_back();
      clients.emplace_back(*server);
      clients.back().write(request);
    }
  }
  RawConnection surplus(*server);
  EXPECT_EQ(surplus.readAll().substr(0, 12), "HTTP/1.1 503");
  clients.pop_front();
  for (bool is_in = false; !is_in;) { // as soon as the server sees that one has gone
    RawConnection next(*server);
    next.write(request);
    is_in = next.read().result_int() == 200;
  }
}

TEST(HttpThreadTest, SaysThatAPortIsInUse)
{
  RunningServer server;
  FewResources resources;
  RecordingHandler handler;
  try {
    const LocalServer second(resources, handler, server->port());
    FAIL() << "two servers on one port";
  }
  catch (const ServerError& error) {
    EXPECT_EQ(std::string(error.what()),
              "port " + std::to_string(server->port()) +
                  " of 127.0.0.1 is in use; choose another, or 0 for one that is free");
  }
}

TEST(HttpThreadTest, TakesAPortThatWasInUseBefore)
{
  std::uint16_t port = 0;
  {
    RunningServer first;
    port = first->port();
    EXPECT_EQ(statusOf(*first, "/", ownFields(*first)), 200u);
  }
  FewResources resources;
  RecordingHandler handler;
  const LocalServer second(resources, handler, port);
  EXPECT_EQ(second.port(), port);
}

/** Not at another address of this machine. */
TEST(HttpThreadTest, ListensForThisMachineOnly)
{
  RunningServer server;
  boost::asio::io_context context;
  boost::asio::ip::tcp::socket socket(context);
  boost::system::error_code error;
  socket.connect({boost::asio::ip::make_address("127.0.0.2"), server->port()}, error);
  EXPECT_EQ(error, boost::asio::error::connection_refused);
}

} // namespace
} // namespace pcl_cid::studio::test
