#include "app/console/self_test_text.h"

#include <vector>

#include "app/console/text_layout.h"
#include "core/base/visible_text.h"
#include "core/self_test/self_test_words.h"

namespace alidade::console {

namespace {

std::string mark(std::size_t reason) {
  return "[" + std::to_string(reason + 1) + "]";
}

std::string sectionText(const CheckSection& section) {
  std::vector<std::vector<std::string>> rows{{"", "expected", "found", "deviation", "at most", ""}};
  for (const auto& [check, reason] : section.lines)
    rows.push_back({outcomeText(check->outcome) + "  " + visibleText(check->name),
                    visibleText(check->expected), visibleText(check->found), shareText(check->deviation),
                    shareText(check->tolerance), mark(reason)});
  std::string text = "\n" + paragraph(titleOf(section.group)) + "\n" + alignedColumns(rows);
  for (std::size_t i = 0; i < section.reasons.size(); ++i) {
    std::string reason = mark(i);
    reason += ' ';
    reason += section.reasons[i];
    text += paragraph(reason, 4);
  }
  return text;
}

}  // namespace

std::string selfTestText(const SelfTest& test, const std::string& program, const std::string& at) {
  std::string text = heading("Check of this installation");
  text += paragraph("program: " + program) + paragraph("at: " + at);
  for (const auto& [name, value] : test.environment) text += paragraph(name + ": " + value, 2);
  for (const CheckSection& section : sectionsOf(test)) text += sectionText(section);
  return text + "\n" + paragraph("Deviations and tolerances are relative to the expected number.") +
         paragraph(verdictSentence(test));
}

}  // namespace alidade::console
