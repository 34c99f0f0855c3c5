#include "app/console/diagnosis_text.h"

#include "app/console/text_layout.h"
#include "core/base/number_text.h"
#include "core/statement/gap.h"
#include "core/wording/effect_name.h"
#include "core/wording/form_sentence.h"
#include "core/wording/size_text.h"

namespace alidade::console {

std::string diagnosisText(const std::string& session, const Gap& gap, const std::vector<Finding>& findings) {
  const Statement verdict = gapVerdict(gap);
  std::string text = heading(session) + "\n" + verdict.title + "\n";
  for (const std::string& sentence : verdict.sentences) text += paragraph(sentence);
  text += statementText(gapStages(gap)) + statementText(gapCauses(gap)) + statementText(gapForms(gap)) +
          statementText(gapKnown(gap));
  if (gap.diagnosis->verdict != DiagnosisVerdict::WithinNoise)
    text += statementText(gapWhere(gap.diagnosis->where));
  for (const Statement& statement :
       {gapClosures(gap), gapRequired(gap), gapAdvice(gap), gapUndetectable(gap)})
    text += statementText(statement);
  return text + findingsText(findings);
}

namespace {

/// "0.180 mm (u 0.013)"; an exact number, such as an order, is without uncertainty.
std::string sizeOf(const FormNumber& number) {
  return isExact(number.value, number.sigma) ? displayShortest(number.value) + signOf(unitOf(number))
                                             : sizeWithStandard(number.value, number.sigma, unitOf(number));
}

}  // namespace

std::string formsText(const std::vector<FoundForm>& forms) {
  std::string text;
  for (const FoundForm& form : forms) {
    text += "\n" + paragraph(formSentence(form));
    for (const FormNumber& number : form.parameters)
      text += "  " + nameOf(number) + ": " + sizeOf(number) + "\n";
    if (const std::string alike = lookAlikesSentence(form); !alike.empty())
      text += paragraph("  " + alike, 2);
    if (const std::string clean = cleanRangeSentence(form); !clean.empty())
      text += paragraph("  " + clean, 2);
  }
  if (forms.empty()) return text;
  const std::string shrink = shrinkSentence(forms.front());
  return shrink.empty() ? text : text + paragraph("  " + shrink, 2);
}

std::string discoveryText(const std::string& table, const Discovery& discovery) {
  std::string text = heading(table) + "\n" + std::to_string(discovery.readings) + " residuals, rms " +
                     fixedText(discovery.rms, 2) + "″ outside the base columns, reduced χ² " +
                     fixedText(discovery.reducedChiSquare, 2) + "\n";
  if (discovery.noise > 1)
    text += "With the forms, the residuals scatter " + fixedText(discovery.noise, 2) +
            " times as much as stated.\n";
  if (discovery.forms.empty()) return text + "No form is 20 times as likely as none.\n";
  return text + formsText(discovery.forms);
}

}  // namespace alidade::console
