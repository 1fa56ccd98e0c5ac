/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The pages that are connected, and which of them is the writer.
 */

#pragma once

#include "frame.h"
#include "session_handler.h"

#include <map>
#include <memory>
#include <optional>

namespace pcl_cid::studio {

/** \brief One end of a socket, as the Clients see it. */
class Client {
public:
  virtual ~Client() = default;

  virtual void
  send(std::shared_ptr<const EncodedFrame> frame) = 0;
};

/** \brief The pages that are connected. The one that came first is the writer. Belongs
 * to the thread of the server. */
class Clients {
public:
  explicit Clients(SessionHandler& handler) : handler_(handler) {}

  /** \brief A page has come.
   *  \param[in] client must not go before it is removed */
  ClientId
  add(Client& client);

  /** \brief A page has gone. */
  void
  remove(ClientId id);

  void
  received(ClientId id, Frame frame)
  {
    handler_.message(id, std::move(frame));
  }

  /** \brief To one page; nothing happens where it is gone. */
  void
  send(ClientId id, const std::shared_ptr<const EncodedFrame>& frame);

  /** \brief To all pages, or all but one. */
  void
  broadcast(const std::shared_ptr<const EncodedFrame>& frame,
            std::optional<ClientId> but_not);

  /** \brief From here on nobody becomes the writer: all are about to go. */
  void
  end()
  {
    is_ending_ = true;
  }

private:
  SessionHandler& handler_;
  std::map<ClientId, Client*> clients_; ///< in the order in which they came
  ClientId last_ = 0;
  bool is_ending_ = false;
};

} // namespace pcl_cid::studio
