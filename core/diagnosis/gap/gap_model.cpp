#include "core/diagnosis/gap/gap_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/adjustment/joint/sighted_zeros.h"

namespace alidade {

namespace {

template <typename T>
std::shared_ptr<const T> borrowed(const T& value) {
  return {std::shared_ptr<void>(), &value};
}

bool everyArcIsFitted(const Measurement& measurement, const SessionFit& fit) {
  return std::ranges::all_of(measurement.arcs,
                             [&](const ArcMeasurement& arc) { return fit.arcOfPosition(arc.position); });
}

}  // namespace

Result<GapModel, NoModel> modelOf(const Measurement& measurement) {
  struct Kept {
    Measurement measurement;
    SessionFit fit;
  };
  const auto kept = std::make_shared<const Kept>(Kept{measurement, fitSession(measurement)});
  const Result<GapModel, NoModel> borrowing = modelOf(kept->measurement, kept->fit);
  if (!borrowing) return borrowing;
  GapModel model = *borrowing;
  model.fit = std::shared_ptr<const JointFit>(kept, &kept->fit.joint);
  if (model.measurement.get() == &kept->measurement)
    model.measurement = std::shared_ptr<const Measurement>(kept, &kept->measurement);
  return model;
}

Result<GapModel, NoModel> modelOf(const Measurement& measurement, const SessionFit& fit) {
  if (fit.arcs.empty()) {
    const auto error = std::ranges::find(fit.findings, Severity::Error, &FitFinding::severity);
    return error == fit.findings.end() ? NoModel{} : NoModel{*error};
  }
  GapModel model{.measurement = everyArcIsFitted(measurement, fit)
                                    ? borrowed(measurement)
                                    : std::make_shared<const Measurement>(fittedPart(measurement, fit)),
                 .starts = {},
                 .options = {.terms = estimatedTerms(measurement)},
                 .fit = borrowed(fit.joint)};
  for (const ArcFit& arc : fit.arcs) model.starts.push_back(arc.circle);
  return model;
}

void GapModel::refit() {
  fit = std::make_shared<const JointFit>(fitJointly(*measurement, starts, options));
}

Measurement withNoise(Measurement measurement, double factor) {
  for (Angle* sigma : {&measurement.sigmaHorizontal, &measurement.sigmaVertical, &measurement.sigmaSlider})
    *sigma = *sigma * factor;
  if (!measurement.zerosAreReadings) return measurement;
  for (Angle* sigma : {&measurement.sigmaZeroHorizontal, &measurement.sigmaZeroVertical})
    *sigma = *sigma * factor;
  measurement.zeroScatter = std::max(1.0, measurement.zeroScatter / factor);
  return measurement;
}

std::optional<GapModel> closedModelOf(const GapModel& own) {
  if (!hasBothAxes(*own.measurement)) return std::nullopt;
  GapModel closed = own;
  closed.options.isClosed = true;
  closed.measurement = std::make_shared<const Measurement>(withZerosSighted(*own.measurement));
  closed.refit();
  if (!closed.fit->converged()) return std::nullopt;
  return closed;
}

GapModel openedModelOf(const GapModel& closed, const GapModel& own) {
  constexpr double held = 1e-6;  // factor of the prior σ, small enough to hold a term at its value
  if (!closed.options.isClosed) return closed;
  GapModel opened = closed;
  opened.options.isClosed = false;
  opened.measurement = own.measurement;
  if (closed.noise != own.noise)
    opened.measurement =
        std::make_shared<const Measurement>(withNoise(*own.measurement, closed.noise / own.noise));
  for (EstimatedTerm& term : opened.options.terms) {
    if (std::ranges::find(own.options.terms, term.term, &EstimatedTerm::term) != own.options.terms.end())
      continue;
    const std::size_t index = closed.fit->indexOf(term.term);
    const double value = closed.fit->values[index];
    term = {term.term, term.priorSigma * held, value, value};
  }
  // Without the closure, the sightings of zeros are no observations.
  std::erase_if(opened.options.without, [&](const ReadingRef& reading) {
    return reading.sighting >= own.measurement->arcs[reading.arc].sightings.size();
  });
  opened.refit();
  return opened;
}

Eigen::VectorXd influencePerSigma(const GapModel& model) {
  const std::vector<AdjustedReading>& readings = model.fit->readings;
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
