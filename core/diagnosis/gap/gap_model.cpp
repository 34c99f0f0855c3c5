#include "core/diagnosis/gap/gap_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

Result<GapModel> modelOf(const Measurement& measurement) {
  SessionFit fit = fitSession(measurement);
  if (fit.arcs.empty()) {
    for (const Finding& finding : fit.findings)
      if (finding.severity == Severity::Error) return Problem{finding.text, finding.where};
    return Problem{"there are no readings; enter those of the axis positions"};
  }
  GapModel model{.measurement = std::make_shared<const Measurement>(fittedPart(measurement, fit)),
                 .starts = {},
                 .options = {.terms = estimatedTerms(measurement)},
                 .fit = std::move(fit.joint)};
  for (const ArcFit& arc : fit.arcs) model.starts.push_back(arc.circle);
  return model;
}

Eigen::VectorXd influencePerSigma(const GapModel& model) {
  const std::vector<AdjustedReading>& readings = model.fit.readings;
  Eigen::VectorXd influence(static_cast<Eigen::Index>(readings.size()));
  for (Eigen::Index i = 0; i < influence.size(); ++i) {
    const AdjustedReading& reading = readings[static_cast<std::size_t>(i)];
    influence[i] = reading.perReading * reading.sigma;
  }
  return influence;
}

ReadingRef readingRef(const Leftover& leftover, Eigen::Index index) {
  const LinearReading& reading = leftover.reading(index);
  return {reading.arc, reading.sighting, reading.kind};
}

}  // namespace alidade
