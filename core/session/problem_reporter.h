#pragma once

#include <optional>
#include <vector>

#include "core/base/place.h"
#include "core/base/problem.h"
#include "core/base/result.h"

namespace alidade {

/// Keeps what is wrong with entries, in the order they are gone through.
class ProblemReporter {
 protected:
  void report(const Problem& problem, const Place& where) { m_problems.push_back({problem.what, where}); }

  /// The value; empty, and reported, where there is none.
  template <typename Value>
  std::optional<Value> take(const Result<Value>& result, const Place& where) {
    if (result) return *result;
    report(result.problem(), where);
    return std::nullopt;
  }

  std::vector<Problem> m_problems;
};

}  // namespace alidade
