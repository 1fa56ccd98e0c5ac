/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The thread that works on a session, and what it says to pages.
 */

#pragma once

#include "label_export.h"
#include "message_queue.h"
#include "part_desk.h"
#include "places.h"
#include "question_desk.h"
#include "recorded_session.h"
#include "server/session_handler.h"

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <thread>

namespace pcl_cid::studio {

class LocalServer;

/** \brief What takes long before a session is there. */
using OpenSession =
    std::function<std::unique_ptr<RecordedSession>(const ExecutionOptions& execution)>;

/** \brief One session, many pages. It listens to them on the thread of the server and
 *  works on a thread of its own: in the order in which they asked, one after another.
 */
class SessionWorker : public SessionHandler {
public:
  /** \param[in] places,scan,exporter,settings,part_exporter must outlive this
   *  \param[in] open called once, by the thread that works; its progress is told to the
   *  pages that are there
   *  \param[in] settings of hulls; its threads are those for all work on the session */
  SessionWorker(OpenSession open,
                const Places& places,
                const tools::LoadedScan& scan,
                LabelExporter& exporter,
                const tools::AbstractSettings& settings,
                const PartExporter& part_exporter);
  ~SessionWorker() override;

  /** \brief Begin to work.
   *  \param[in] server must outlive this, or stop(); it is stopped when the session
   *  cannot be opened, or when the work fails in another way than an action may */
  void
  start(LocalServer& server);

  /** \brief End the work, in the middle if need be, and wait until it has ended. */
  void
  stop() noexcept;

  /** \throws what made the work fail, if anything did; to be asked after stop() */
  void
  requireSuccess() const;

  void
  opened(ClientId client, bool is_writer) override;

  void
  message(ClientId client, Frame frame) override;

  void
  closed(ClientId client) override;

  void
  promoted(ClientId client) override;

private:
  void
  work();

  void
  handle(const Message& message);

  void
  tellPromotion(const Message& message);

  void
  change(const Message& message, const nlohmann::json& id);

  void
  changeLabels(const Message& message, const nlohmann::json& id);

  void
  changeParts(const PartAction& action,
              const Message& message,
              const nlohmann::json& id);

  void
  tellChange(const char* event,
             Frame frame,
             const Message& message,
             const nlohmann::json& id);

  void
  answer(const Message& message, const nlohmann::json& id);

  nlohmann::json
  summaryFor(bool is_writer) const;

  ExecutionOptions
  executionOf(const Message& message, const nlohmann::json& id);

  ProgressCallback
  progressTo(std::optional<ClientId> client,
             const nlohmann::json& id,
             std::function<bool()> goes_on);

  OpenSession open_;
  const Places& places_;
  const tools::LoadedScan& scan_;
  LabelExporter& exporter_;
  const tools::AbstractSettings& settings_;
  const PartExporter& part_exporter_;
  MessageQueue messages_;
  std::atomic<ClientId> writer_{0}; ///< 0: none
  LocalServer* server_ = nullptr;
  std::unique_ptr<RecordedSession> session_;
  std::unique_ptr<QuestionDesk> desk_;
  std::unique_ptr<PartDesk> part_desk_;
  std::exception_ptr failure_;
  std::thread thread_; ///< works with all that stands above
};

} // namespace pcl_cid::studio
