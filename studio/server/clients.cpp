/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The pages that are connected, and which of them is the writer.
 */

#include "clients.h"

namespace pcl_cid::studio {

ClientId
Clients::add(Client& client)
{
  const ClientId id = ++last_;
  clients_.emplace(id, &client);
  handler_.opened(id, clients_.begin()->first == id);
  return id;
}

void
Clients::remove(ClientId id)
{
  const bool was_writer = clients_.begin()->first == id;
  clients_.erase(id);
  handler_.closed(id);
  if (was_writer && !clients_.empty() && !is_ending_)
    handler_.promoted(clients_.begin()->first);
}

void
Clients::send(ClientId id, const std::shared_ptr<const EncodedFrame>& frame)
{
  const auto client = clients_.find(id);
  if (client != clients_.end())
    client->second->send(frame);
}

void
Clients::broadcast(const std::shared_ptr<const EncodedFrame>& frame,
                   std::optional<ClientId> but_not)
{
  for (const auto& [id, client] : clients_)
    if (id != but_not)
      client->send(frame);
}

} // namespace pcl_cid::studio
