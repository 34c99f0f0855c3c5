#include "core/evaluation/findings.h"

#include "core/wording/findings.h"

namespace alidade {

std::vector<Finding> findingsOf(const Evaluation& evaluation) {
  std::vector<Finding> findings = inWords(evaluation.fit.findings);
  if (evaluation.searchFailure)
    findings.insert(findings.begin(),
                    {.severity = Severity::Warning, .text = sentencesOf(*evaluation.searchFailure)});
  if (evaluation.failure)
    findings.push_back({.severity = Severity::Error, .text = sentencesOf(*evaluation.failure)});
  return findings;
}

}  // namespace alidade
