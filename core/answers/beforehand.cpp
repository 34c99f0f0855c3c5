#include "core/answers/beforehand.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "core/adjustment/result/session_findings.h"
#include "core/adjustment/result/setup_findings.h"
#include "core/base/phrase.h"
#include "core/wording/findings.h"

namespace alidade {

std::optional<Problem> absence(const Measurement& measurement, std::size_t fitted,
                               const std::vector<FitFinding>& findings) {
  const auto read = std::ranges::count_if(measurement.arcs,
                                          [](const ArcMeasurement& arc) { return !arc.sightings.empty(); });
  if (fitted > 0 && static_cast<std::ptrdiff_t>(fitted) == read) return std::nullopt;
  const auto error = std::ranges::find(findings, Severity::Error, &FitFinding::severity);
  if (error == findings.end())
    return Problem{Phrase::of("there are no readings to fit; enter the readings of the axis positions")};
  const Finding finding = inWords(*error);
  return Problem{sentencesOf(finding), finding.where};
}

Result<std::vector<Finding>> findingsBeforehand(const Measurement& measurement, const SessionFit& fit) {
  if (auto problem = absence(measurement, fit.arcs.size(), fit.findings)) return *std::move(problem);
  std::vector<FitFinding> findings = missingPositions(measurement);
  std::ranges::move(setupFindings(measurement, fit), std::back_inserter(findings));
  std::ranges::move(modelFindings(measurement), std::back_inserter(findings));
  return inWords(findings);
}

}  // namespace alidade
