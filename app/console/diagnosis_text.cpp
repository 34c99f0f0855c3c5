#include "app/console/diagnosis_text.h"

#include <algorithm>

#include "app/console/findings_text.h"
#include "app/console/statement_text.h"
#include "app/console/text_layout.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/statement/gap.h"

namespace alidade::console {

namespace {

/// "face 1", "180°", "30…60°", "horizontal".
std::string partText(const GapShare& share) {
  if (share.by == "position") return share.of + "°";
  if (share.by == "face" || share.by == "round") return share.by + " " + share.of;
  return share.of;
}

/// One line for each division of the readings (by face, by round, …) that has two or more parts. Omits parts
/// below one percent.
std::string whereText(const Diagnosis& diagnosis) {
  std::string text = "\nWhere the gap lies\n";
  for (auto first = diagnosis.where.begin(); first != diagnosis.where.end();) {
    const auto end = std::find_if(first, diagnosis.where.end(),
                                  [&](const GapShare& share) { return share.by != first->by; });
    std::vector<std::string> parts;
    for (auto share = first; share != end; ++share)
      if (share->share >= 0.01)
        parts.push_back(partText(*share) + ": " + fixedText(100 * share->share, 0) + " %");
    if (end - first > 1) text += paragraph("  by " + first->by + " – " + listed(parts), 4);
    first = end;
  }
  return text;
}

}  // namespace

std::string diagnosisText(const std::string& session, const Gap& gap, const std::vector<Finding>& findings) {
  const Statement verdict = gapVerdict(gap);
  std::string text = heading(session) + "\n" + verdict.title + "\n";
  for (const std::string& sentence : verdict.sentences) text += paragraph(sentence);
  text += statementText(gapStages(gap)) + statementText(gapCauses(gap)) + statementText(gapForms(gap)) +
          statementText(gapKnown(gap));
  if (gap.diagnosis->verdict != DiagnosisVerdict::WithinNoise) text += whereText(*gap.diagnosis);
  for (const Statement& statement :
       {gapClosures(gap), gapRequired(gap), gapAdvice(gap), gapUndetectable(gap)})
    text += statementText(statement);
  return text + findingsText(findings);
}

}  // namespace alidade::console
