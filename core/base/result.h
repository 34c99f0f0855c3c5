#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

#include "core/base/problem.h"

namespace alidade {

/// A value, or the reason why there is none: one sentence, or a `Reason` that `core/wording/` puts into
/// words. It is for invalid input; faults of the program are asserts, statements on the data are findings.
template <typename T, typename Reason = Problem>
class [[nodiscard]] Result {
 public:
  Result(T value) : m_content(std::move(value)) {}
  Result(Reason reason) : m_content(std::move(reason)) {}

  explicit operator bool() const { return std::holds_alternative<T>(m_content); }

  const T& operator*() const& {
    assert(*this);
    return std::get<T>(m_content);
  }
  T&& operator*() && {
    assert(*this);
    return std::get<T>(std::move(m_content));
  }
  const T* operator->() const { return &**this; }

  const Reason& problem() const {
    assert(!*this);
    return std::get<Reason>(m_content);
  }

 private:
  std::variant<T, Reason> m_content;
};

}  // namespace alidade
