#include <cmath>
#include <string>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/diagnosis/diagnose.h"
#include "core/self_test/check_families.h"
#include "core/self_test/references.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"

namespace alidade {

namespace {

constexpr const char* byTruth = PHRASE_LATER("Phrase", "the diagnosis must name exactly what was simulated");
constexpr const char* threeSigma =
    PHRASE_LATER("Phrase", "3 σ of the estimate: the readings hold noise, which is the same every time");

struct KnownTruth {
  const char* file;
  const char* verdict;
  const char* cause;  ///< id of the effect; null: none
  const char* size;   ///< of the cause's first parameter, in its unit; null: not checked
};

constexpr KnownTruth truths[] = {{"clean-session.alidade", "within-noise", nullptr, nullptr},
                                 {"trunnion-tilt.alidade", "single-cause", "trunnion_tilt", "25"},
                                 {"misreading.alidade", "single-cause", "gross_error", nullptr}};

void addDiagnosis(std::vector<SelfCheck>& checks, const KnownTruth& truth) {
  constexpr auto group = CheckGroup::Diagnosis;
  const std::string name = truth.file;
  const Result<Session> session = readSession(referenceText(name));
  if (!session) return checks.push_back(brokenCheck(group, name, session.problem().text()));
  const Examined examined = examine(*session);
  if (!examined.measurement) return checks.push_back(brokenCheck(group, name, "no measurement"));
  const auto diagnosis = diagnose(*examined.measurement);
  if (!diagnosis) return checks.push_back(brokenCheck(group, name, "no diagnosis"));
  checks.push_back(
      textCheck(group, name + ": verdict", truth.verdict, std::string(nameOf(diagnosis->verdict)), byTruth));
  if (!truth.cause) return;
  const bool isOne = diagnosis->causes.size() == 1;
  checks.push_back(textCheck(group, name + ": cause", truth.cause,
                             isOne ? diagnosis->causes.front().effect : "no single one", byTruth));
  if (!truth.size || !isOne || diagnosis->causes.front().parameters.empty()) return;
  const CauseParameter& found = diagnosis->causes.front().parameters.front();
  checks.push_back(numberCheck(group, name + ": " + found.name + " (" + found.unit + ")", truth.size,
                               found.value, {.absolute = 3 * found.sigma, .reason = threeSigma}));
}

}  // namespace

std::vector<SelfCheck> diagnosisChecks() {
  std::vector<SelfCheck> checks;
  for (const KnownTruth& truth : truths) addDiagnosis(checks, truth);
  return checks;
}

}  // namespace alidade
