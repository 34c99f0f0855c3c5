#include "app/console/self_test_text.h"

#include "app/console/text_layout.h"
#include "core/self_test/self_test_words.h"

namespace alidade::console {

std::string selfTestText(const SelfTest& test, const std::string& program, const std::string& at) {
  std::string text = heading("Check of this installation");
  text += paragraph("program: " + program) + paragraph("at: " + at);
  for (const auto& [name, value] : test.environment) text += paragraph(name + ": " + value, 2);
  for (const CheckSection& section : sectionsOf(test)) text += statementText(sectionTable(section));
  return text + "\n" + paragraph("Deviations and tolerances are relative to the expected number.") +
         paragraph(verdictSentence(test));
}

}  // namespace alidade::console
