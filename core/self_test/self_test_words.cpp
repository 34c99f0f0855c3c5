#include "core/self_test/self_test_words.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

std::string titleOf(CheckGroup group) {
  switch (group) {
    case CheckGroup::Fits:
      return Phrase::of("Sessions fitted at 60 digits by another implementation (stated σ, readings alone)");
    case CheckGroup::Published:
      return Phrase::of("The figures that the paper prints, by the published method");
    case CheckGroup::Diagnosis:
      return Phrase::of("Simulated sessions whose cause is known");
    case CheckGroup::Distributions:
      return Phrase::of(
          "Coverage factors (t), tails of χ² and F, normal quantiles: reference values with 50 digits");
    case CheckGroup::Angles:
      return Phrase::of("Conversion of typed angles: reference values with 50 digits");
    case CheckGroup::Random:
      return Phrase::of("Random numbers and a simulated session, by a second implementation");
    case CheckGroup::Installed:
      return Phrase::of("Files installed with the programs");
    case CheckGroup::Window:
      break;
  }
  return Phrase::of("Contents built into the desktop program, and its fonts");
}

std::string outcomeText(SelfCheck::Outcome outcome) {
  switch (outcome) {
    case SelfCheck::Outcome::Passed:
      return Phrase::of("passed");
    case SelfCheck::Outcome::Failed:
      return Phrase::of("failed");
    case SelfCheck::Outcome::LeftOut:
      break;
  }
  return Phrase::of("left out");
}

std::vector<CheckSection> sectionsOf(const SelfTest& test) {
  std::vector<CheckSection> sections;
  for (const SelfCheck& check : test.checks) {
    if (sections.empty() || sections.back().group != check.group) sections.push_back({.group = check.group});
    CheckSection& section = sections.back();
    const std::string reason = Phrase::of(check.reason);
    const auto at = std::ranges::find(section.reasons, reason);
    const auto index = static_cast<std::size_t>(at - section.reasons.begin());
    if (at == section.reasons.end()) section.reasons.push_back(reason);
    section.lines.push_back({&check, index});
  }
  return sections;
}

Statement sectionTable(const CheckSection& section) {
  const auto mark = [](std::size_t reason) { return "[" + std::to_string(reason + 1) + "]"; };
  Statement statement{.id = "self_test",
                      .title = titleOf(section.group),
                      .columns = {{"line", Phrase::of("Line"), Statement::Column::Role::Name},
                                  {"expected", Phrase::of("Expected")},
                                  {"found", Phrase::of("Found")},
                                  {"deviation", Phrase::of("Deviation")},
                                  {"tolerance", Phrase::of("At most")}},
                      .rows = {}};
  for (const auto& [check, reason] : section.lines) {
    const std::string most = shareText(check->tolerance);
    statement.rows.push_back(
        {.cells = {outcomeText(check->outcome) + "  " + visibleText(check->name),
                   visibleText(check->expected), visibleText(check->found), shareText(check->deviation),
                   (most.empty() ? "" : most + " ") + mark(reason)},
         .isNotable = check->outcome == SelfCheck::Outcome::Failed});
  }
  for (std::size_t i = 0; i < section.reasons.size(); ++i)
    statement.sentences.push_back(mark(i) + " " + section.reasons[i]);
  return statement;
}

std::string shareText(const std::optional<double>& share) {
  if (!share) return {};
  if (*share == 0) return "0";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", *share);
  return text.data();
}

std::string verdictSentence(const SelfTest& test) {
  const std::size_t failed = test.count(SelfCheck::Outcome::Failed);
  const std::size_t passed = test.count(SelfCheck::Outcome::Passed);
  if (failed == 0 && passed == 0)
    return Phrase::of("This installation does not pass: nothing could be checked.");
  if (failed > 0)
    return Phrase::of(
        "This installation does not pass: %1 of %2 lines failed. Do not use its results until this is "
        "explained.",
        failed, failed + passed);
  return Phrase::of("This installation passes: all %1 lines are within their tolerance.", passed);
}

}  // namespace alidade
