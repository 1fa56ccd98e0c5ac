/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the parts of the server share.
 */

#pragma once

#include "clients.h"
#include "connections.h"
#include "request_guard.h"
#include "resource.h"
#include "server_limits.h"

#include <cstdint>

namespace pcl_cid::studio {

/** \brief What the connections of one server share; they must not outlive it. */
struct ServerParts {
  std::uint16_t port;
  ServerLimits limits;
  RequestGuard guard;
  const Resources& resources;
  Clients clients;
  Connections connections{};
};

} // namespace pcl_cid::studio
