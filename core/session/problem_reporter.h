#pragma once

#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/base/result.h"

namespace alidade {

/// Collects problems of entries in the order of examination.
class ProblemReporter {
 protected:
  void report(const Problem& problem, const Place& where) { m_problems.push_back({problem.what, where}); }

  /// The value; empty, with the problem reported, if there is none.
  template <typename Value>
  std::optional<Value> take(const Result<Value>& result, const Place& where) {
    if (result) return *result;
    report(result.problem(), where);
    return std::nullopt;
  }

  std::vector<Problem> m_problems;
};

}  // namespace alidade
