/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The rules that keep everybody but the user's own page out, one by one.
 */

#include "clients_of_tests.h"
#include "running_server.h"

#include <regex>

#include <gtest/gtest.h>

namespace pcl_cid::studio::test {
namespace {

class GuardThreadTest : public testing::Test {
protected:
  unsigned int
  status(const Fields& fields, const std::string& target = "/", Verb verb = Verb::get)
  {
    return statusOf(*server_, target, fields, verb);
  }

  Fields
  with(const std::string& name, const std::string& value)
  {
    Fields fields = own_;
    fields[name] = value;
    return fields;
  }

  Fields
  without(const std::string& name)
  {
    Fields fields = own_;
    fields.erase(name);
    return fields;
  }

  /** The fields of a request for a socket. */
  Fields
  socketFields()
  {
    Fields fields = own_;
    fields["Origin"] = "http://" + host_;
    fields["Connection"] = "Upgrade";
    fields["Upgrade"] = "websocket";
    fields["Sec-WebSocket-Version"] = "13";
    fields["Sec-WebSocket-Key"] = "dGhlIHNhbXBsZSBub25jZQ==";
    return fields;
  }

  RunningServer server_;
  const std::string host_ = hostOf(*server_);
  const std::string port_ = std::to_string(server_->port());
  const Fields own_ = ownFields(*server_);
};

TEST_F(GuardThreadTest, LetsTheOwnPageIn)
{
  EXPECT_EQ(status(own_), 200u);
  EXPECT_EQ(status(with("Host", "localhost:" + port_)), 200u);
  EXPECT_EQ(status(with("Origin", "http://" + host_)), 200u);
  EXPECT_EQ(status(with("Sec-Fetch-Site", "same-origin")), 200u);
  EXPECT_EQ(status(with("Sec-Fetch-Site", "none")), 200u);
  EXPECT_EQ(status(own_, "/?anything"), 200u);
  EXPECT_EQ(status(own_, "/nothing"), 404u);
}

TEST_F(GuardThreadTest, RefusesAForeignHost)
{
  for (const std::string& host : {std::string("evil.example"),
                                  "evil.example:" + port_,
                                  std::string("127.0.0.1"),
                                  std::string("localhost"),
                                  "127.0.0.1:1" + port_,
                                  "127.0.0.2:" + port_,
                                  "localhost.evil.example:" + port_,
                                  "x@127.0.0.1:" + port_,
                                  std::string()}) {
    EXPECT_EQ(status(with("Host", host)), 403u) << host;
    EXPECT_EQ(status({{"Host", host}}, entryOf(*server_)), 403u) << host;
  }
  EXPECT_EQ(status(without("Host")), 403u);
}

TEST_F(GuardThreadTest, RefusesTwoHosts)
{
  RawConnection client(*server_);
  client.write("GET / HTTP/1.1\r\nHost: " + host_ +
               "\r\nHost: evil.example\r\nCookie: " + own_.at("Cookie") + "\r\n\r\n");
  EXPECT_EQ(client.read().result_int(), 403u);
}

TEST_F(GuardThreadTest, RefusesAForeignOrigin)
{
  for (const std::string& origin : {std::string("http://evil.example"),
                                    std::string("null"),
                                    "https://" + host_,
                                    "http://localhost:" + port_,
                                    "http://" + host_ + "0",
                                    std::string("http://127.0.0.1"),
                                    std::string()}) {
    EXPECT_EQ(status(with("Origin", origin)), 403u) << origin;
    Fields fields = socketFields();
    fields["Origin"] = origin;
    EXPECT_EQ(status(fields, "/api/session"), 403u) << origin;
  }
}

TEST_F(GuardThreadTest, RefusesWhatAnotherSiteMakesTheBrowserAsk)
{
  for (const char* site : {"cross-site", "same-site", "", "None"})
    EXPECT_EQ(status(with("Sec-Fetch-Site", site)), 403u) << site;
}

TEST_F(GuardThreadTest, RefusesWhoHasNoCookie)
{
  const std::string cookie = own_.at("Cookie");
  const std::string name = cookie.substr(0, cookie.find('='));
  const std::string other_digit = cookie.back() == '0' ? "1" : "0";
  EXPECT_EQ(status(without("Cookie")), 401u);
  for (const std::string& wrong : {std::string(),
                                   name,
                                   name + "=",
                                   cookie + "0",
                                   cookie.substr(0, cookie.size() - 1),
                                   cookie.substr(0, cookie.size() - 1) + other_digit,
                                   "x" + cookie,
                                   "x=" + cookie,
                                   cookie.substr(cookie.find('=') + 1),
                                   std::string(";;=; =;")})
    EXPECT_EQ(status(with("Cookie", wrong)), 401u) << wrong;
  EXPECT_EQ(status(without("Cookie"), "/nothing"), 401u) << "tells what there is";
  EXPECT_EQ(status(with("Cookie", "a=b; " + cookie + "; c=d")), 200u);
  EXPECT_EQ(status(with("Cookie", name + "=old; " + cookie)), 200u);
}

TEST_F(GuardThreadTest, GivesACookieForTheToken)
{
  const Answer answer = ask(*server_, entryOf(*server_), {{"Host", host_}});
  EXPECT_EQ(answer.result_int(), 303u);
  EXPECT_EQ(answer["Location"], "/");
  const std::string cookie(answer["Set-Cookie"]);
  const std::regex form("pcl_cid_studio_" + port_ +
                        "=[0-9a-f]{32}; HttpOnly; SameSite=Strict; Path=/");
  EXPECT_TRUE(std::regex_match(cookie, form)) << cookie;
  const std::regex url("http://127\\.0\\.0\\.1:" + port_ + "/\\?token=[0-9a-f]{32}");
  EXPECT_TRUE(std::regex_match(server_->url(), url)) << server_->url();
  EXPECT_EQ(cookie.find(entryOf(*server_).substr(8)), std::string::npos)
      << "the cookie tells the token";
}

TEST_F(GuardThreadTest, LeadsOnFromAnotherSiteByItsOwnPage)
{
  const Answer answer = ask(
      *server_, entryOf(*server_), {{"Host", host_}, {"Sec-Fetch-Site", "cross-site"}});
  EXPECT_EQ(answer.result_int(), 200u);
  EXPECT_NE(answer["Set-Cookie"], "");
  EXPECT_NE(answer.body().find("url=/\""), std::string::npos);
}

TEST_F(GuardThreadTest, RefusesAWrongToken)
{
  const std::string entry = entryOf(*server_);
  for (const std::string& wrong : {std::string("/?token="),
                                   std::string("/?token=0"),
                                   entry + "0",
                                   entry + "&a=b",
                                   entry.substr(0, entry.size() - 1),
                                   "/?token=" + std::string(32, '0')}) {
    const Answer answer = ask(*server_, wrong, own_);
    EXPECT_EQ(answer.result_int(), 401u) << wrong;
    EXPECT_EQ(answer.count("Set-Cookie"), 0u);
    EXPECT_EQ(answer["Content-Type"], "text/plain; charset=utf-8");
    EXPECT_NE(answer.body().find("token"), std::string::npos);
  }
}

TEST_F(GuardThreadTest, TokensAndCookiesDifferBetweenServers)
{
  RunningServer other;
  EXPECT_NE(entryOf(*server_), entryOf(*other));
  Fields fields = ownFields(*other);
  EXPECT_EQ(statusOf(*other, "/", fields), 200u);
  fields["Cookie"] = own_.at("Cookie");
  EXPECT_EQ(statusOf(*other, "/", fields), 401u);
  fields["Cookie"] = own_.at("Cookie") + "; " + cookieOf(*other);
  EXPECT_EQ(statusOf(*other, "/", fields), 200u);
}

TEST_F(GuardThreadTest, AnswersGetAndHeadOnly)
{
  for (const Verb verb : {Verb::post,
                          Verb::put,
                          Verb::delete_,
                          Verb::options,
                          Verb::trace,
                          Verb::connect,
                          Verb::patch}) {
    const Answer answer = ask(*server_, "/", own_, verb);
    EXPECT_EQ(answer.result_int(), 405u) << verb;
    EXPECT_EQ(answer["Allow"], "GET, HEAD");
  }
  EXPECT_EQ(status(own_, "/", Verb::head), 200u);
  RawConnection client(*server_);
  client.write("BREW / HTTP/1.1\r\nHost: " + host_ + "\r\n\r\n");
  EXPECT_EQ(client.read().result_int(), 405u);
}

TEST_F(GuardThreadTest, DoesNotReadTheBodyOfAPost)
{
  RawConnection client(*server_);
  client.write("POST / HTTP/1.1\r\nHost: " + host_ +
               "\r\nCookie: " + own_.at("Cookie") +
               "\r\nContent-Length: 1000000000\r\n\r\n" + std::string(100000, 'x'));
  EXPECT_EQ(client.read().result_int(), 405u);
}

TEST_F(GuardThreadTest, RefusesAGetWithABody)
{
  RawConnection client(*server_);
  client.write("GET / HTTP/1.1\r\nHost: " + host_ + "\r\nCookie: " + own_.at("Cookie") +
               "\r\nContent-Length: 3\r\n\r\nabc");
  const Answer answer = client.read();
  EXPECT_EQ(answer.result_int(), 400u);
  EXPECT_FALSE(answer.keep_alive());
}

TEST_F(GuardThreadTest, LetsTheOwnPageHaveASocket)
{
  const Answer answer = ask(*server_, "/api/session", socketFields());
  EXPECT_EQ(answer.result_int(), 101u);
  EXPECT_EQ(answer["Sec-WebSocket-Extensions"], "");
}

TEST_F(GuardThreadTest, RefusesASocketToOthers)
{
  for (const char* field : {"Host", "Origin", "Cookie"}) {
    Fields fields = socketFields();
    fields.erase(field);
    const unsigned int expected = field == std::string("Cookie") ? 401 : 403;
    EXPECT_EQ(status(fields, "/api/session"), expected) << field;
  }
  Fields fields = socketFields();
  fields["Sec-Fetch-Site"] = "cross-site";
  EXPECT_EQ(status(fields, "/api/session"), 403u);
}

TEST_F(GuardThreadTest, NeedsAnUpgradeForASocket)
{
  Fields fields = socketFields();
  fields.erase("Upgrade");
  EXPECT_EQ(status(fields, "/api/session"), 426u);
  fields = socketFields();
  fields.erase("Sec-WebSocket-Key");
  EXPECT_EQ(status(fields, "/api/session"), 400u);
  EXPECT_EQ(status(socketFields(), "/"), 200u) << "an upgrade elsewhere is ignored";
}

TEST_F(GuardThreadTest, EveryAnswerProtectsThePage)
{
  Fields foreign = own_;
  foreign["Host"] = "evil.example";
  for (const Answer& answer : {ask(*server_, "/", own_),
                               ask(*server_, entryOf(*server_), {{"Host", host_}}),
                               ask(*server_, "/nothing", own_),
                               ask(*server_, "/", foreign),
                               ask(*server_, "/", own_, Verb::post),
                               ask(*server_, "/", own_, Verb::head),
                               ask(*server_, "/api/session", socketFields())}) {
    SCOPED_TRACE(answer.result_int());
    EXPECT_EQ(answer["Content-Security-Policy"],
              "default-src 'none'; script-src 'self'; style-src 'self'; "
              "font-src 'self'; img-src 'self' data: blob:; worker-src 'self' blob:; "
              "connect-src 'self' ws://127.0.0.1:" +
                  port_ + " ws://localhost:" + port_ +
                  "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
    EXPECT_EQ(answer["X-Content-Type-Options"], "nosniff");
    EXPECT_EQ(answer["Referrer-Policy"], "no-referrer");
    EXPECT_EQ(answer["Cross-Origin-Opener-Policy"], "same-origin");
    EXPECT_EQ(answer["Cross-Origin-Resource-Policy"], "same-origin");
    EXPECT_EQ(answer["Cache-Control"], "no-store");
    EXPECT_EQ(answer.count("Access-Control-Allow-Origin"), 0u);
  }
}

} // namespace
} // namespace pcl_cid::studio::test
