#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

namespace alidade::fuzz {

/// Choices determined by bytes. After the last byte every choice is the first, so any bytes are valid.
class Steering {
 public:
  explicit Steering(std::string_view bytes) : m_bytes(bytes) {}

  bool hasEnded() const { return m_bytes.empty(); }

  /// One of `count` (1…256) choices.
  std::size_t below(std::size_t count) {
    if (m_bytes.empty()) return 0;
    const auto byte = static_cast<unsigned char>(m_bytes.front());
    m_bytes.remove_prefix(1);
    return byte % count;
  }

  /// A member of a non-empty array or vector.
  template <typename List>
  const auto& oneOf(const List& list) {
    return list[below(std::size(list))];
  }

  /// Returns a number from `low` to `high` in 255 steps.
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(below(256)) / 255;
  }

 private:
  std::string_view m_bytes;
};

}  // namespace alidade::fuzz
