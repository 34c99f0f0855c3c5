#include "core/adjustment/gross_errors/correction_trials.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

namespace {

/// A row agrees if its misfit has at least this probability. The limit is no stricter than the test that
/// names a misread reading.
constexpr double leastProbability = 1e-4;
constexpr double mostSliderDisagreement = 5;

}  // namespace

ReadingKind kindOf(const std::string& field) {
  if (field == "vertical") return ReadingKind::Vertical;
  return field == "slider" ? ReadingKind::Slider : ReadingKind::Horizontal;
}

Visited Visited::with(std::size_t row) const {
  Visited visit = *this;
  if (std::ranges::find(visit.rows, row) == visit.rows.end()) visit.rows.push_back(row);
  std::ranges::sort(visit.rows);
  return visit;
}

CorrectionTrials::CorrectionTrials(const Session& session, Measurement fitted, const JointFit& fit,
                                   double risk, const std::stop_token& stop)
    : m_session(session), m_fitted(std::move(fitted)), m_reader(session) {
  m_fitOptions.terms = estimatedTerms(m_fitted);
  m_search = searchGrossErrors(m_fitted, {.risk = risk, .fit = m_fitOptions, .known = &fit}, stop);
  if (stop.stop_requested()) return;
  m_sound = m_fitted;
  for (const GrossError& error : m_search.grossErrors) shiftReading(m_sound, error.cell, error.size);
  for (std::size_t arc = 0; arc < m_fitted.arcs.size(); ++arc) m_starts.push_back(m_search.fit.circleOf(arc));
}

Visited CorrectionTrials::visitOf(std::size_t arc, int round, int point) const {
  Visited visit{arc, round, point, {}};
  for (const Sighting& sighting : m_fitted.arcs[arc].sightings)
    if (sighting.round == round && sighting.point == point) visit.rows.push_back(sighting.row);
  return visit;
}

std::vector<GrossError> CorrectionTrials::grossErrorsIn(const Visited& visit) const {
  std::vector<GrossError> errors;
  std::ranges::copy_if(m_search.grossErrors, std::back_inserter(errors), [&](const GrossError& m) {
    const Sighting& sighting = sightingOf(m.cell);
    return m.cell.arc == visit.arc && sighting.round == visit.round && sighting.point == visit.point;
  });
  return errors;
}

// With very many rows the fit of all rows is used: one or two visits hardly change it.
VisitCheck CorrectionTrials::checkOf(const Visited& visit, const Visited* other) const {
  constexpr std::size_t veryMany = 2000;
  auto inQuestion = readingsOf(m_sound, visit.arc, visit.round, visit.point);
  if (other)
    std::ranges::copy(readingsOf(m_sound, other->arc, other->round, other->point),
                      std::back_inserter(inQuestion));
  JointFitOptions options = m_fitOptions;
  options.without = m_search.leftOut;
  options.without.insert(options.without.end(), inQuestion.begin(), inQuestion.end());
  if (m_fitted.rows > veryMany) return VisitCheck(m_sound, visit.arc, options.without, m_search.fit, options);
  return VisitCheck(m_sound, visit.arc, options.without, fitJointly(m_sound, m_starts, options), options);
}

/// The rows of the visit with a correction, minus the shifts of misread cells that the correction leaves
/// unchanged. Empty if a row cannot be used.
std::vector<Sighting> CorrectionTrials::rowsWith(const Visited& visit, const Correction& correction,
                                                 const std::vector<GrossError>& keptOff) {
  const std::size_t position = m_fitted.arcs[visit.arc].position;
  std::vector<Sighting> rows;
  for (const std::size_t row : visit.rows) {
    const auto changed = correction.rows.find(row);
    const Reading& reading =
        changed == correction.rows.end() ? m_session.positions[position].readings[row] : changed->second;
    const auto sighting = m_reader.read(position, row, reading);
    if (!sighting) return {};
    if (std::ranges::find(rows, sighting->face, &Sighting::face) != rows.end()) return {};
    rows.push_back(*sighting);
    for (const GrossError& error : keptOff) {
      if (sightingOf(error.cell).row != row) continue;
      Measurement alone;
      alone.arcs.resize(1);
      alone.arcs[0].sightings = {rows.back()};
      shiftReading(alone, {0, 0, error.cell.kind}, error.size);
      rows.back() = alone.arcs[0].sightings[0];
    }
  }
  return rows;
}

bool CorrectionTrials::agreesAsTyped(const Visited& visit, const VisitCheck& check) {
  const auto rows = rowsWith(visit, {}, {});
  return !rows.empty() && check.agreement(rows).probability >= leastProbability;
}

/// The gain in log likelihood of other visits whose rows the correction changes; empty if the correction
/// makes one of these visits disagree.
std::optional<double> CorrectionTrials::gainElsewhere(const Visited& visit, const Correction& correction) {
  const ArcMeasurement& arc = m_fitted.arcs[visit.arc];
  double gain = 0;
  for (const auto& [row, reading] : correction.rows) {
    if (std::ranges::find(visit.rows, row) != visit.rows.end()) continue;
    const auto other = m_reader.read(arc.position, row, reading);
    if (!other) return std::nullopt;
    const Visited otherVisit = visitOf(visit.arc, other->round, other->point).with(row);
    const auto as = rowsWith(otherVisit, {}, {}), corrected = rowsWith(otherVisit, correction, {});
    if (corrected.empty()) return std::nullopt;
    const VisitCheck check = checkOf(visit, &otherVisit);
    if (!check.canCheck()) return std::nullopt;
    const VisitAgreement after = check.agreement(corrected);
    if (after.probability < leastProbability) return std::nullopt;
    constexpr double unusable = -50;  // log likelihood of typed text that gives no sighting
    gain += after.logLikelihood - (as.empty() ? unusable : check.agreement(as).logLikelihood);
  }
  return gain;
}

/// The disagreement, in σ, between slider readings typed in both rows of a visit, which should be one
/// reading.
double CorrectionTrials::sliderDisagreement(const std::vector<Sighting>& rows) const {
  if (rows.size() < 2 || !rows[0].slider || !rows[1].slider) return 0;
  return std::abs(wrapped(*rows[0].slider - *rows[1].slider).radians()) / m_fitted.sigmaSlider.radians();
}

std::optional<AgreeingCorrection> CorrectionTrials::tryOut(const Visited& visit, const VisitCheck& check,
                                                           const Correction& correction,
                                                           const std::vector<GrossError>& keptOff) {
  const std::vector<Sighting> rows = rowsWith(visit, correction, keptOff);
  if (rows.empty()) return std::nullopt;
  const VisitAgreement agreement = check.agreement(rows);
  const double slider = sliderDisagreement(rows);
  if (agreement.probability < leastProbability || slider > mostSliderDisagreement) return std::nullopt;
  const auto elsewhere = gainElsewhere(visit, correction);
  if (!elsewhere) return std::nullopt;
  const Place& first = correction.changes.front().where;
  const auto row = std::ranges::find(rows, *first.reading, &Sighting::row);
  const ReadingKind kind = kindOf(first.field);
  const std::size_t index = kind == ReadingKind::Slider ? agreement.residuals.size() - 1
                                                        : 2 * static_cast<std::size_t>(row - rows.begin()) +
                                                              (kind == ReadingKind::Vertical ? 1 : 0);
  return AgreeingCorrection{
      correction, *row,
      std::log(correction.prior) + agreement.logLikelihood + *elsewhere - slider * slider / 2,
      Angle::fromRadians(agreement.residuals[index] * sideOf(m_fitted, row->face, kind)),
      agreement.offSpacing};
}

std::vector<AgreeingCorrection> CorrectionTrials::agreeing(const Visited& visit, const VisitCheck& check,
                                                           const std::vector<GrossError>& keptOff,
                                                           const ReadingRef* only) {
  std::vector<AgreeingCorrection> tried;
  if (!check.canCheck()) return tried;
  const std::size_t position = m_fitted.arcs[visit.arc].position;
  for (const std::size_t row : visit.rows) {
    if (only && sightingOf(*only).row != row) continue;
    for (const Correction& correction : correctionsOf(m_session, position, row)) {
      if (only &&
          (correction.changes.size() > 1 || correction.changes.front().where.field != nameOf(only->kind)))
        continue;
      if (auto one = tryOut(visit, check, correction, keptOff)) tried.push_back(*std::move(one));
    }
  }
  std::ranges::stable_sort(tried, std::ranges::greater(), &AgreeingCorrection::score);
  return tried;
}

}  // namespace alidade
