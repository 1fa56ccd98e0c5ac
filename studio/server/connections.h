/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The connections that are open.
 */

#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <vector>

namespace pcl_cid::studio {

class Connections;

/** \brief A connection, which is among the Connections as long as it lives. It lives as
 *  long as an operation on it is pending. */
class Connection : public std::enable_shared_from_this<Connection> {
public:
  explicit Connection(Connections& all);
  virtual ~Connection();

  Connection(const Connection&) = delete;
  Connection&
  operator=(const Connection&) = delete;

  /** \brief Let it end soon, politely where that is possible. */
  virtual void
  end() = 0;

protected:
  /** \brief This object as what it is, for the handlers of its operations to keep. */
  template <typename Kind>
  std::shared_ptr<Kind>
  self()
  {
    return std::static_pointer_cast<Kind>(shared_from_this());
  }

private:
  Connections& all_;
};

/** \brief All connections; they must not outlive it. */
class Connections {
public:
  std::size_t
  count() const
  {
    return all_.size();
  }

  void
  endAll()
  {
    std::vector<std::shared_ptr<Connection>> ending; // one may end at once
    for (Connection* connection : all_)
      ending.push_back(connection->shared_from_this());
    for (const auto& connection : ending)
      connection->end();
  }

private:
  friend class Connection;

  std::set<Connection*> all_;
};

inline Connection::Connection(Connections& all) : all_(all)
{
  all_.all_.insert(this);
}

inline Connection::~Connection()
{
  all_.all_.erase(this);
}

} // namespace pcl_cid::studio
