#include "core/adjustment/session_fit.h"

#include <algorithm>
#include <cmath>

#include "core/adjustment/session_findings.h"

namespace alidade {

namespace {

Finding failure(const ArcMeasurement& arc, const Problem& problem) {
  return {Severity::Error,
          "The arc at " + std::to_string(arc.axisDeg) + "° " + problem.what + ".",
          {},
          problem.where};
}

}  // namespace

const ArcFit* SessionFit::arcAt(int axisDeg) const {
  const auto found = std::ranges::find(arcs, axisDeg, &ArcFit::axisDeg);
  return found == arcs.end() ? nullptr : &*found;
}

const ArcFit* SessionFit::arcOfPosition(std::size_t position) const {
  const auto found = std::ranges::find(arcs, position, &ArcFit::position);
  return found == arcs.end() ? nullptr : &*found;
}

SessionFit fitSession(const Measurement& measurement) {
  SessionFit fit;
  for (const ArcMeasurement& arc : measurement.arcs) {
    Result<ArcFit> fitted = fitArc(measurement, arc);
    if (fitted) {
      fit.arcs.push_back(*std::move(fitted));
      std::ranges::copy(fit.arcs.back().findings, std::back_inserter(fit.findings));
    } else {
      fit.findings.push_back(failure(arc, fitted.problem()));
    }
  }
  fit.noise = noiseScale(fit.arcs);
  for (const ArcFit& arc : fit.arcs) fit.sigmas.push_back(arcSigma(measurement, arc, fit.noise.factor));
  fit.intersection = intersect(measurement, fit.arcs);
  if (fit.intersection && measurement.tolerance)
    fit.verdict = decide(fit.intersection->value, fit.intersection->expanded, *measurement.tolerance);
  std::ranges::move(sessionFindings(measurement, fit), std::back_inserter(fit.findings));
  return fit;
}

PublishedSessionFit fitSessionAsPublished(const Measurement& measurement) {
  PublishedSessionFit fit;
  for (const ArcMeasurement& arc : measurement.arcs) {
    Result<PublishedFit> fitted = fitArcAsPublished(measurement, arc);
    if (fitted)
      fit.arcs.push_back(*std::move(fitted));
    else
      fit.findings.push_back(failure(arc, fitted.problem()));
  }
  const auto at = [&](int axisDeg) {
    return std::ranges::find_if(fit.arcs, [&](const PublishedFit& f) { return f.arc.axisDeg == axisDeg; });
  };
  const auto upper = at(0), lower = at(180);
  if (upper == fit.arcs.end() || lower == fit.arcs.end()) return fit;
  fit.intersection = (upper->arc.circle.y - lower->arc.circle.y) / 2;
  fit.intersectionAsPrinted = (upper->asPrinted.y - lower->asPrinted.y) / 2;
  fit.inPlane = std::hypot(upper->arc.circle.x - lower->arc.circle.x, *fit.intersection * 2) / 2;
  return fit;
}

}  // namespace alidade
