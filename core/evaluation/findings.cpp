#include "core/evaluation/findings.h"

#include "core/wording/findings.h"

namespace alidade {

std::vector<Finding> findingsOf(const Evaluation& evaluation) {
  std::vector<Finding> findings = inWords(evaluation.fit.findings);
  if (!evaluation.searchFailure.empty())
    findings.insert(findings.begin(), {.severity = Severity::Warning, .text = evaluation.searchFailure});
  if (!evaluation.failure.empty())
    findings.push_back({.severity = Severity::Error, .text = evaluation.failure});
  return findings;
}

}  // namespace alidade
