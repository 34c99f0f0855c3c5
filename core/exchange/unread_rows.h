#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// Does the cell name a mean, a sum or a difference of other rows: `Mittel`, `Mean of 3`, `平均`?
bool namesMean(std::string_view cell);

/// Does the cell contain a digit of any script?
bool hasAnyDigit(std::string_view cell);

/// Skipped rows of a table, for one sentence per kind.
class UnreadRows {
 public:
  enum class Kind { Mean, HeadingAgain, NoReading };

  void add(Kind kind, std::size_t line) { m_lines[static_cast<std::size_t>(kind)].push_back(line); }
  std::vector<std::string> sentences() const;

 private:
  std::vector<std::size_t> m_lines[3];
};

}  // namespace alidade
