/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Frames on their way from any thread to the thread of the server.
 */

#pragma once

#include "frame.h"
#include "session_handler.h"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_cid::studio {

/** \brief A frame, and for whom it is. */
struct Parcel {
  std::shared_ptr<const EncodedFrame> frame;
  std::optional<ClientId> to{};      ///< nothing: all
  std::optional<ClientId> but_not{}; ///< of all
};

/** \brief Keeps the order in which threads have sent: what they post to Asio one by one
 *  may overtake what its own thread posts. */
class Outbox {
public:
  /** \return whether it was empty: then somebody has to come and take */
  bool
  put(Parcel parcel)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    parcels_.push_back(std::move(parcel));
    return parcels_.size() == 1;
  }

  std::vector<Parcel>
  takeAll()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(parcels_, {});
  }

private:
  std::mutex mutex_;
  std::vector<Parcel> parcels_;
};

} // namespace pcl_cid::studio
