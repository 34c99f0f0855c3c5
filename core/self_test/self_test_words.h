#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/self_test/self_test.h"
#include "core/statement/statement.h"

namespace alidade {

/// The content of a group, as a heading.
std::string titleOf(CheckGroup group);

/// "passed", "failed", "left out".
std::string outcomeText(SelfCheck::Outcome outcome);

/// The lines of one group, and the reasons of their tolerances, each once.
struct CheckSection {
  struct Line {
    const SelfCheck* check;
    std::size_t reason;  ///< index into `reasons`
  };

  CheckGroup group = CheckGroup::Fits;
  std::vector<Line> lines = {};
  std::vector<std::string> reasons = {};  ///< in words
};

/// Returns the sections in the order of the groups; their lines point into `test`.
std::vector<CheckSection> sectionsOf(const SelfTest& test);

/// The lines of a section with expected and found number, relative deviation and tolerance; the sentences
/// give the reasons of the tolerances, "[1] …".
Statement sectionTable(const CheckSection& section);

/// A relative deviation or tolerance with two digits: "1.3e-12"; 0 as "0", absent as an empty text.
std::string shareText(const std::optional<double>& share);

/// The verdict over all lines, one sentence.
std::string verdictSentence(const SelfTest& test);

}  // namespace alidade
