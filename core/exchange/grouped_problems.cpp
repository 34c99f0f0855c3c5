#include "core/exchange/grouped_problems.h"

#include <map>
#include <string_view>

#include "core/base/phrase.h"
#include "core/base/typed_text.h"

namespace alidade {

namespace {

/// The sentence without quotations and numbers.
std::string kindOf(std::string_view sentence) {
  constexpr std::string_view opens = "“", closes = "”";
  std::string kind;
  while (!sentence.empty()) {
    if (sentence.starts_with(opens)) {
      const std::size_t end = sentence.find(closes);
      if (end == std::string_view::npos) break;
      sentence.remove_prefix(end + closes.size());
    } else {
      const char c = sentence.front();
      if (!isDigit(c) && c != '.' && c != '-') kind += c;
      sentence.remove_prefix(1);
    }
  }
  return kind;
}

}  // namespace

std::string ProblemGroup::text() const {
  return count == 1 ? first.text() : Phrase::of("%1 (and %2 more of this kind)", first.text(), count - 1);
}

std::vector<ProblemGroup> grouped(const std::vector<LineProblem>& problems) {
  std::vector<ProblemGroup> groups;
  std::map<std::string, std::size_t> known;
  for (const LineProblem& problem : problems) {
    const auto [at, isNew] = known.emplace(kindOf(problem.what), groups.size());
    if (isNew)
      groups.push_back({.first = problem, .count = 1});
    else
      ++groups[at->second].count;
  }
  return groups;
}

}  // namespace alidade
