#pragma once

#include <string>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/fit_finding.h"
#include "core/base/finding.h"

namespace alidade {

/// Converts the findings of a fit to sentences.
Finding inWords(const FitFinding& finding);
std::vector<Finding> inWords(const std::vector<FitFinding>& findings);

/// Also converts the suspects, if there are any, to one finding, which comes first.
std::vector<Finding> inWords(const std::vector<FitFinding>& findings, const std::vector<Suspect>& suspects);

/// Joins two sentences; either may be empty.
std::string inTurn(const std::string& first, const std::string& second);

/// The finding, and what to do about it.
inline std::string sentencesOf(const Finding& finding) {
  return inTurn(finding.text, finding.remedy);
}

}  // namespace alidade
