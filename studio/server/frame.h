/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The frames that go over the socket: a header in JSON and arrays of numbers.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::studio {

/** \brief These bytes are no frame; the message is one sentence. */
class BadFrame : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief An array of a frame. */
struct NamedArray {
  std::string name;
  std::variant<std::vector<std::uint32_t>, std::vector<float>> values;
};

/** \brief What one message of the socket says. */
struct Frame {
  /** \brief An object. `arrays` is not in it: encoding adds it, decoding takes it out.
   */
  nlohmann::json header = nlohmann::json::object();
  std::vector<NamedArray> arrays{}; ///< each name once

  /** \brief The values of an array; null where there is none of this name and type. */
  template <typename Number>
  const std::vector<Number>*
  array(std::string_view name) const
  {
    for (const NamedArray& candidate : arrays)
      if (candidate.name == name)
        return std::get_if<std::vector<Number>>(&candidate.values);
    return nullptr;
  }
};

/** \brief The longest header that is taken from a page. */
constexpr std::size_t most_header_bytes = std::size_t{1} << 20;

/** \brief Read a frame.
 *  \param[in] bytes the whole message
 *  \param[in] most_bytes the longest header to take: one that is parsed takes many
 *  times its bytes of memory
 *  \throws BadFrame */
Frame
decodeFrame(std::string_view bytes, std::size_t most_bytes = most_header_bytes);

/** \brief A frame that is ready to be sent, to one page or several. The arrays stay
 * where they are. */
class EncodedFrame {
public:
  /** \param[in] frame text in its header that is not UTF-8 is mended */
  explicit EncodedFrame(Frame frame);

  /** \brief The bytes, one piece after the other; valid as long as this object. */
  std::vector<std::string_view>
  pieces() const;

  /** \brief The number of bytes. */
  std::size_t
  size() const
  {
    return size_;
  }

private:
  std::string head_; ///< length, header and padding
  std::vector<NamedArray> arrays_;
  std::size_t size_;
};

} // namespace pcl_cid::studio
