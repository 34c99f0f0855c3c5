#include "core/diagnosis/gap/gap_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace alidade {

Result<GapModel, NoModel> modelOf(const Measurement& measurement) {
  return modelOf(measurement, fitSession(measurement));
}

Result<GapModel, NoModel> modelOf(const Measurement& measurement, SessionFit fit) {
  if (fit.arcs.empty()) {
    const auto error = std::ranges::find(fit.findings, Severity::Error, &FitFinding::severity);
    return error == fit.findings.end() ? NoModel{} : NoModel{*error};
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
