/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The thread that works on a session, and what it says to pages.
 */

#include "session_worker.h"
#include "server/local_server.h"
#include "wire_action.h"
#include "wire_state.h"

#include <pcl_cid/exceptions.h>

#include <chrono>
#include <utility>

namespace pcl_cid::studio {
namespace {

using Json = nlohmann::json;

/** Work that is over before is not told of. */
constexpr auto worth_telling = std::chrono::milliseconds(300);

Frame
refusal(const Json& id, const std::string& sentence)
{
  return {{{"id", id}, {"ok", false}, {"error", sentence}}, {}};
}

} // namespace

SessionWorker::SessionWorker(OpenSession open,
                             const Places& places,
                             const tools::LoadedScan& scan,
                             LabelExporter& exporter,
                             const tools::AbstractSettings& settings,
                             const PartExporter& part_exporter)
: open_(std::move(open))
, places_(places)
, scan_(scan)
, exporter_(exporter)
, settings_(settings)
, part_exporter_(part_exporter)
{
}

SessionWorker::~SessionWorker()
{
  stop();
}

void
SessionWorker::start(LocalServer& server)
{
  server_ = &server;
  thread_ = std::thread([this] {
    try {
      work();
    }
    catch (...) {
      if (!messages_.isClosed())
        failure_ = std::current_exception();
      server_->stop();
    }
  });
}

void
SessionWorker::stop() noexcept
{
  messages_.close();
  if (thread_.joinable())
    thread_.join();
}

void
SessionWorker::requireSuccess() const
{
  if (failure_)
    std::rethrow_exception(failure_);
}

void
SessionWorker::opened(ClientId client, bool is_writer)
{
  if (is_writer)
    writer_ = client;
}

void
SessionWorker::message(ClientId client, Frame frame)
{
  messages_.push(client, std::move(frame), client == writer_);
}

void
SessionWorker::closed(ClientId client)
{
  ClientId writer = client;
  writer_.compare_exchange_strong(writer, 0);
}

void
SessionWorker::promoted(ClientId client)
{
  writer_ = client;
  messages_.pushPromotion(client);
}

void
SessionWorker::work()
{
  session_ = open_({settings_.threads, progressTo(std::nullopt, nullptr, [this] {
                      return !messages_.isClosed();
                    })});
  desk_ = std::make_unique<QuestionDesk>(
      session_->session(), places_, scan_.points, exporter_);
  part_desk_ =
      std::make_unique<PartDesk>(*session_, places_, scan_, settings_, part_exporter_);
  while (const std::optional<Message> message = messages_.pop())
    message->is_promotion ? tellPromotion(*message) : handle(*message);
}

void
SessionWorker::handle(const Message& message)
{
  const Json& header = message.frame.header;
  const auto found = header.find("id");
  const Json id = found == header.end() ? Json() : *found;
  try {
    if (messages_.isPointless(message))
      throw CIDCancelled();
    if (header.contains("do"))
      change(message, id);
    else
      answer(message, id);
  }
  catch (const CIDCancelled&) {
    server_->send(message.client, refusal(id, "cancelled"));
  }
  catch (const CIDException& error) {
    server_->send(message.client, refusal(id, error.what()));
  }
}

/** Nothing has changed but who the writer is. */
void
SessionWorker::tellPromotion(const Message& message)
{
  Json header = summaryFor(message.client == writer_);
  header["event"] = "changed";
  server_->send(message.client,
                {std::move(header), changedLabels(session_->session(), {}, places_)});
}

void
SessionWorker::change(const Message& message, const Json& id)
{
  if (message.client != writer_)
    throw CIDException("another page works on this session; this one looks on");
  const auto on_parts = partActionIn(message.frame.header.dump());
  on_parts ? changeParts(*on_parts, message, id) : changeLabels(message, id);
}

void
SessionWorker::changeLabels(const Message& message, const Json& id)
{
  const LabelAction action = actionFrom(message.frame, places_);
  const pcl::Indices changed = session_->apply(action, executionOf(message, id));
  tellChange("changed",
             {summaryFor(false), changedLabels(session_->session(), changed, places_)},
             message,
             id);
}

void
SessionWorker::changeParts(const PartAction& action,
                           const Message& message,
                           const Json& id)
{
  const ExecutionOptions execution = executionOf(message, id);
  session_->applyToParts(action, execution);
  tellChange("parts",
             {{{"revision", session_->revision()},
               {"writer", false},
               {"parts", part_desk_->summary(execution)}},
              {}},
             message,
             id);
}

/** An event for those who look on, and an answer for the one who works. */
void
SessionWorker::tellChange(const char* event,
                          Frame frame,
                          const Message& message,
                          const Json& id)
{
  frame.header["event"] = event;
  server_->broadcast(frame, message.client);
  frame.header.erase("event");
  frame.header.update({{"id", id}, {"ok", true}, {"writer", true}});
  server_->send(message.client, std::move(frame));
}

void
SessionWorker::answer(const Message& message, const Json& id)
{
  const ExecutionOptions execution = executionOf(message, id);
  Frame answer = PartDesk::answers(message.frame.header)
                     ? part_desk_->answer(message.frame, execution)
                     : desk_->answer(message.frame, execution);
  if (message.frame.header["ask"] == "state")
    answer.header.update(
        {{"revision", session_->revision()}, {"writer", message.client == writer_}});
  answer.header.update({{"id", id}, {"ok", true}});
  server_->send(message.client, std::move(answer));
}

Json
SessionWorker::summaryFor(bool is_writer) const
{
  Json summary = summaryOf(session_->session(), places_);
  summary.update({{"revision", session_->revision()}, {"writer", is_writer}});
  return summary;
}

/** Actions that come and go quickly are done to their end: the callback makes them work
 *  on a copy. A proposal or a decomposition may take long, and can be given up with the
 *  program. */
ExecutionOptions
SessionWorker::executionOf(const Message& message, const Json& id)
{
  const auto verb = message.frame.header.find("do");
  if (verb != message.frame.header.end() && *verb != "propose" && *verb != "decompose")
    return {settings_.threads, {}};
  return {settings_.threads, progressTo(message.client, id, [this, &message] {
            return !messages_.isPointless(message);
          })};
}

/** Tell a page, or all, how far work is that takes long. */
ProgressCallback
SessionWorker::progressTo(std::optional<ClientId> client,
                          const Json& id,
                          std::function<bool()> goes_on)
{
  using Clock = std::chrono::steady_clock;
  return [=, goes_on = std::move(goes_on), begin = Clock::now()](double share) {
    if (Clock::now() - begin > worth_telling) {
      Frame frame{{{"event", "progress"}, {"id", id}, {"share", share}}, {}};
      client ? server_->send(*client, std::move(frame))
             : server_->broadcast(std::move(frame));
    }
    return goes_on();
  };
}

} // namespace pcl_cid::studio
