/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The messages that wait for the thread that works on a session.
 */

#include "message_queue.h"

#include <utility>

namespace pcl_cid::studio {
namespace {

bool
isChange(const Frame& frame)
{
  return frame.header.contains("do");
}

} // namespace

MessageQueue::Topic
MessageQueue::topicOf(ClientId client, const Frame& frame)
{
  const auto asked = frame.header.find("ask");
  const bool is_text = asked != frame.header.end() && asked->is_string();
  return {client, is_text ? asked->get<std::string>() : ""};
}

void
MessageQueue::push(ClientId client, Frame frame, bool may_change)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++count_;
  if (isChange(frame))
    last_change_ = may_change ? count_ : last_change_;
  else
    last_asked_[topicOf(client, frame)] = count_;
  messages_.push_back({client, std::move(frame), count_, false});
  came_.notify_one();
}

void
MessageQueue::pushPromotion(ClientId client)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  messages_.push_back({client, {}, ++count_, true});
  came_.notify_one();
}

std::optional<Message>
MessageQueue::pop()
{
  std::unique_lock<std::mutex> lock(mutex_);
  came_.wait(lock, [&] { return is_closed_ || !messages_.empty(); });
  if (is_closed_)
    return std::nullopt;
  Message message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

bool
MessageQueue::isPointless(const Message& message) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_closed_)
    return true;
  if (isChange(message.frame))
    return false;
  const auto asked = last_asked_.find(topicOf(message.client, message.frame));
  return last_change_ > message.number ||
         (asked != last_asked_.end() && asked->second > message.number);
}

void
MessageQueue::close()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  is_closed_ = true;
  came_.notify_all();
}

bool
MessageQueue::isClosed() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_closed_;
}

} // namespace pcl_cid::studio
