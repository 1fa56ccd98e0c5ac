/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The messages that wait for the thread that works on a session.
 */

#pragma once

#include "server/frame.h"
#include "server/session_handler.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace pcl_cid::studio {

/** \brief A message of a page. */
struct Message {
  ClientId client = 0;
  Frame frame;
  std::uint64_t number = 0;  ///< it came as the so-manyth
  bool is_promotion = false; ///< no message, but the news that the page is the writer
};

/** \brief Messages in the order in which they came, from one thread to another. It
 *  knows which questions have become pointless: a change came after them, or the same
 *  page has asked the same again. */
class MessageQueue {
public:
  /** \brief From the thread of the server.
   *  \param[in] may_change whether the page may change the session: what another one
   *  wants done makes no question pointless */
  void
  push(ClientId client, Frame frame, bool may_change);

  /** \brief Likewise: the page has become the writer. */
  void
  pushPromotion(ClientId client);

  /** \brief Wait for a message.
   *  \return nothing once the queue is closed */
  std::optional<Message>
  pop();

  /** \brief Whether nobody waits for the answer any more. Never a change. */
  bool
  isPointless(const Message& message) const;

  /** \brief Let pop() return nothing, and all be pointless. */
  void
  close();

  bool
  isClosed() const;

private:
  /** What is asked, and by whom. */
  using Topic = std::pair<ClientId, std::string>;

  static Topic
  topicOf(ClientId client, const Frame& frame);

  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::deque<Message> messages_;
  std::uint64_t count_ = 0;
  std::uint64_t last_change_ = 0;             ///< number of a message
  std::map<Topic, std::uint64_t> last_asked_; ///< likewise
  bool is_closed_ = false;
};

} // namespace pcl_cid::studio
