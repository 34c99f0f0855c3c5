#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

#include "core/base/problem.h"

namespace alidade {

/// A value, or the one sentence that says why there is none. For bad input; our own bugs are asserts and
/// what the data say about themselves is a Finding.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : m_content(std::move(value)) {}
  Result(Problem problem) : m_content(std::move(problem)) {}

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

  const Problem& problem() const {
    assert(!*this);
    return std::get<Problem>(m_content);
  }

 private:
  std::variant<T, Problem> m_content;
};

}  // namespace alidade
