#include "core/series/history/epoch.h"

#include <algorithm>
#include <filesystem>

#include "core/answers/beforehand.h"
#include "core/base/phrase.h"
#include "core/diagnosis/diagnose.h"
#include "core/series/history/history_date.h"
#include "core/session/readings_digest.h"
#include "core/session/session_file.h"
#include "core/statement/headline.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

namespace {

void addLengths(Epoch& epoch, const Measurement& measurement, const SessionFit& fit) {
  const Measurement fitted = fittedPart(measurement, fit);
  const auto upper = arcAt(fitted, 0), lower = arcAt(fitted, 180);
  if (!upper || !lower) return;
  using Kind = Unknown::Kind;
  struct Wanted {
    const char* id;
    Unknown unknown;
  };
  std::vector<std::size_t> taken;
  std::vector<std::vector<double>> weights;
  for (const auto& [id, unknown] : {Wanted{"o1_x", {Kind::CentreX, *upper}},
                                    {"o1_y", {Kind::CentreY, *upper}},
                                    {"radius_0", {Kind::Radius, *upper}},
                                    {"o2_x", {Kind::CentreX, *lower}},
                                    {"o2_y", {Kind::CentreY, *lower}},
                                    {"radius_180", {Kind::Radius, *lower}}}) {
    const std::size_t index = fit.joint.indexOf(unknown);
    if (index >= fit.joint.unknowns.size() || std::ranges::find(taken, index) != taken.end()) continue;
    taken.push_back(index);
    epoch.lengths.push_back({id, fit.joint.values[index]});
    weights.push_back(unitWeights(fit.joint, unknown));
  }
  epoch.covariance = {weights.size(), {}};
  for (const std::vector<double>& one : weights)
    for (const std::vector<double>& other : weights)
      epoch.covariance.values.push_back(covarianceOf(fit.joint, one, other, fit.noise.factor));
  epoch.degreesOfFreedom = fit.noise.degreesOfFreedom;
}

}  // namespace

Epoch epochOf(const std::string& file, const Session& session, const Measurement& measurement,
              const SessionFit& fit, const Diagnosis& diagnosis) {
  Epoch epoch{
      .file = file,
      .title = session.title.empty() ? std::filesystem::path(file).filename().string() : session.title,
      .readings = readingsDigest(session, measurement),
      .device = session.device.name,
      .deviceSerial = session.device.serial,
      .instrument = session.instrument.name,
      .instrumentSerial = session.instrument.serial,
      .coverage = measurement.coverage,
      .circle = measurement.verticalCircle};
  if (const Result<HistoryDate> date = parseHistoryDate(session.measuredOn)) {
    epoch.date = date->text;
    epoch.day = date->day;
  }
  if (measurement.measurand == Measurand::Intersection) epoch.tolerance = measurement.tolerance;
  epoch.intersection = diagnosis.measured->estimate;
  epoch.ofFit = *fit.intersection;
  for (const UncertaintyShare& share : diagnosis.measured->budget) {
    const Effect* effect = effectById(share.effect, measurement);
    if (share.source == UncertaintySource::PlausibleSizes && effect &&
        (effect->source == ErrorSource::Instrument || effect->source == ErrorSource::Guideway))
      epoch.lasting.push_back({share.effect, effect->source, share.sigma});
  }
  for (const Cause& cause : diagnosis.causes)
    for (const CauseParameter& parameter : cause.parameters)
      epoch.causes.push_back(
          {cause.effect, parameter.name, parameter.unit, parameter.value, parameter.sigma});
  addLengths(epoch, measurement, fit);
  const Headline headline = headlineOf(measurement, fit, &diagnosis);
  epoch.verdict = headline.decided;
  epoch.judgement = {headline.verdictAndTolerance(), headline.condition()};
  return epoch;
}

Result<Epoch> epochOf(const std::string& file, const Session& session) {
  const Examined examined = examine(session);
  if (!examined.problems.empty()) {
    Problem first = examined.problems.front();
    if (examined.problems.size() > 1)
      first.what = Phrase::of("%1 (and %2 more)", first.what, examined.problems.size() - 1);
    return first;
  }
  const Measurement& measurement = *examined.measurement;
  const SessionFit fit = fitSession(measurement);
  if (auto problem = absence(measurement, fit.arcs.size(), fit.findings)) return *std::move(problem);
  const auto diagnosis = diagnose(measurement, fit);
  if (!diagnosis) return problemOf(diagnosis.problem());
  if (!fit.intersection || !diagnosis->measured)
    return Problem{Phrase::of("has no Δd: it needs readings at 0° and at 180°")};
  return epochOf(file, session, measurement, fit, *diagnosis);
}

Result<Epoch> loadEpoch(const std::string& file) {
  const Result<Session> session = loadSession(file);
  if (!session) return session.problem();
  return epochOf(file, *session);
}

}  // namespace alidade
