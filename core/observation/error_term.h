#pragma once

#include <array>

#include "core/terms/error_term.h"

namespace alidade {

/// The sizes of all error terms; zero unless set.
template <typename T>
class ErrorTerms {
 public:
  /// `zero` is needed only if T(0) is not a valid zero, as for a jet of dynamic size.
  ErrorTerms() : ErrorTerms(T(0)) {}
  explicit ErrorTerms(const T& zero) { m_sizes.fill(zero); }

  void set(ErrorTerm term, const T& size) {
    m_sizes[static_cast<std::size_t>(term)] = size;
    m_isPerfect = false;
  }
  const T& operator[](ErrorTerm term) const { return m_sizes[static_cast<std::size_t>(term)]; }

  /// True if no term was set: the short formulas of the perfect model then apply.
  bool isPerfect() const { return m_isPerfect; }

 private:
  std::array<T, errorTermCount> m_sizes;
  bool m_isPerfect = true;
};

}  // namespace alidade
