#include "tests/fuzz/typed_session.h"

#include <cmath>
#include <utility>

#include "core/effects/catalogue.h"
#include "core/simulation/simulate.h"
#include "tests/fuzz/steering.h"

namespace alidade::fuzz {

namespace {

Protocol planFrom(Steering& steering) {
  const std::vector<std::vector<int>> axes = {{0, 180}, {180, 0}, {0}, {180}};
  Protocol plan;
  plan.points = 1 + static_cast<int>(steering.below(60));
  const double arc = steering.between(2, 350);
  plan.first = Angle::fromDegrees(steering.between(0, 350));
  plan.step = Angle::fromDegrees(arc / plan.points);
  plan.rounds = 1 + static_cast<int>(steering.below(3));
  plan.faces = static_cast<FacePlan>(steering.below(3));
  plan.slider = steering.below(2) == 1;
  plan.axes = steering.oneOf(axes);
  plan.circleShift = Angle::fromDegrees(steering.between(0, 180));
  return plan;
}

/// A number between the bounds, uniform in its logarithm.
double decades(Steering& steering, double low, double high) {
  return std::pow(10, steering.between(std::log10(low), std::log10(high)));
}

Truth truthFrom(Steering& steering) {
  Truth truth = drawTruth(steering.below(256));
  truth.distance = decades(steering, 500, 50000);
  truth.radius = truth.nominalRadius = decades(steering, 50, 5000);
  truth.sigmaHorizontal = truth.sigmaVertical = Angle::fromArcseconds(decades(steering, 0.1, 60));
  truth.noiseFactor = steering.between(0, 4);
  truth.placeSpread = Angle::fromArcseconds(steering.between(0, 3600));
  if (steering.below(2) == 1) {
    truth.verticalCircle = VerticalCircle::Elevation;
    truth.verticalZero = {};
  }
  const std::size_t effects = steering.below(3);
  for (std::size_t i = 0; i < effects; ++i) {
    const EffectParameter& parameter = steering.oneOf(steering.oneOf(effectCatalogue()).parameters);
    truth.effects = {{parameter.term, parameter.plausible * steering.between(-8, 8)}};
  }
  return truth;
}

/// Types a session row by row.
class Typist {
 public:
  Typist(Steering& steering, Session intended)
      : m_steering(steering), m_intended(std::move(intended)), m_session(m_intended) {
    for (Position& position : m_session.positions) position.readings.clear();
    for (std::size_t i = m_steering.below(6); i > 0; --i) changeOption();
  }

  Session typed() {
    while (!m_steering.hasEnded()) act();
    return std::move(m_session);
  }

 private:
  void act() {
    switch (m_steering.below(16)) {
      case 0:
        return typeRows(1 + m_steering.below(60));
      case 1:
      case 2:
        return typeRows(1);
      case 3:
        return typeRows(1), slip(lastRow());
      case 4:
        return m_at = (m_at + 1) % m_session.positions.size(), void();
      case 5:
      case 6:
        return slip(anyRow());
      case 7:
        return blank(anyRow());
      case 8:
        return swapRows(anyRow(), anyRow());
      case 9:
        return swapCircles(anyRow());
      case 10:
        return exclude(anyRow());
      case 11:
        return remove();
      case 12:
        return rename(anyRow());
      case 13:
        return slipInZero();
      case 14:
        return repeat(anyRow());
      default:
        return changeOption();
    }
  }

  std::vector<Reading>& rows() { return m_session.positions[m_at].readings; }
  const std::vector<Reading>& intendedRows() const { return m_intended.positions[m_at].readings; }
  Reading* lastRow() { return rows().empty() ? nullptr : &rows().back(); }
  Reading* anyRow() { return rows().empty() ? nullptr : &rows()[m_steering.below(rows().size())]; }

  std::size_t allRows() const {
    std::size_t count = 0;
    for (const Position& position : m_session.positions) count += position.readings.size();
    return count;
  }

  /// Types the next rows of the plan, continuing with the next position once this one is complete.
  void typeRows(std::size_t count) {
    for (; count > 0 && allRows() < mostRows; --count) {
      if (rows().size() >= intendedRows().size()) m_at = (m_at + 1) % m_session.positions.size();
      if (rows().size() >= intendedRows().size()) return;
      rows().push_back(intendedRows()[rows().size()]);
    }
  }

  std::string& cell(Reading& reading) {
    std::string* const cells[] = {&reading.horizontal, &reading.vertical, &reading.slider};
    return *cells[m_steering.below(3)];
  }

  /// Makes a digit wrong, swaps two digits, or omits one.
  void slip(std::string& text) {
    std::vector<std::size_t> digits;
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
    if (digits.empty()) return;
    const std::size_t which = m_steering.below(digits.size());
    const std::size_t kind = m_steering.below(12);
    if (kind < 10) {
      text[digits[which]] = static_cast<char>('0' + kind);
    } else if (kind == 10) {
      std::swap(text[digits[which]], text[digits[(which + 1) % digits.size()]]);
    } else {
      text.erase(digits[which], 1);
    }
  }

  void slip(Reading* reading) {
    if (reading) slip(cell(*reading));
  }

  void slipInZero() {
    PointingZero& zero = m_session.positions[m_at].zero;
    slip(m_steering.below(2) == 0 ? zero.horizontal : zero.vertical);
  }

  void blank(Reading* reading) {
    if (reading) cell(*reading).clear();
  }

  void swapRows(Reading* one, Reading* other) {
    if (one && other && one != other) std::swap(*one, *other);
  }

  void swapCircles(Reading* reading) {
    if (reading) std::swap(reading->horizontal, reading->vertical);
  }

  void exclude(Reading* reading) {
    if (reading) reading->excluded = !reading->excluded;
  }

  void remove() {
    if (!rows().empty())
      rows().erase(rows().begin() + static_cast<std::ptrdiff_t>(m_steering.below(rows().size())));
  }

  void rename(Reading* reading) {
    if (!reading) return;
    std::string* const names[] = {&reading->point, &reading->round, &reading->face};
    const char* const texts[] = {"1", "2", "3", "17", "", "0", "-1", "999999999", "2.5", "x"};
    *names[m_steering.below(3)] = m_steering.oneOf(texts);
  }

  /// Copies the readings of the row above.
  void repeat(Reading* reading) {
    if (!reading) return;
    for (Reading& other : rows()) {
      other.horizontal = reading->horizontal;
      other.vertical = reading->vertical;
      if (m_steering.below(2) == 0) return;
    }
  }

  void changeOption() {
    const char* const sigmas[] = {"2", "0.1", "60", "", "1e-6", "3600", "0", "1e-160", "1e300", "-1", "x"};
    const char* const lengths[] = {"400", "0.5", "50", "5000", "", "1e-160", "1e300", "0", "-1", "x"};
    switch (m_steering.below(14)) {
      case 0:
        return m_session.model.verticalAngle = m_steering.below(2) == 0 ? "exact" : "planar", void();
      case 1:
        return changeRadiusModel();
      case 2:
        return m_session.model.effects.emplace_back(m_steering.oneOf(effectCatalogue()).id), void();
      case 3:
        return m_session.instrument.sigmaHorizontalArcsec = m_steering.oneOf(sigmas), void();
      case 4:
        return m_session.instrument.sigmaVerticalArcsec = m_steering.oneOf(sigmas), void();
      case 5:
        return m_session.instrument.sigmaZeroArcsec = m_steering.oneOf(sigmas), void();
      case 6:
        return m_session.instrument.sigmaSliderArcsec = m_steering.oneOf(sigmas), void();
      case 7:
        return m_session.geometry.sigmaDistanceMm = m_steering.oneOf(lengths), void();
      case 8:
        return m_session.geometry.sigmaRadiusMm = m_steering.oneOf(lengths), void();
      case 9:
        return m_session.geometry.distanceMm = m_steering.oneOf(lengths), void();
      case 10:
        return m_session.geometry.radiusMm = m_steering.oneOf(lengths), void();
      case 11:
        return m_session.acceptance.toleranceMm = m_steering.oneOf(lengths), void();
      case 12:
        return changeCoverage();
      default:
        return m_session.acceptance.referenceIntersectionMm = m_steering.oneOf(lengths), void();
    }
  }

  void changeRadiusModel() {
    const char* const models[] = {"free", "common", "known"};
    m_session.model.radius = m_steering.oneOf(models);
  }

  void changeCoverage() {
    const char* const levels[] = {"0.95", "0.5", "0.999999999", "1e-9", "0.99999999999999999", ""};
    m_session.acceptance.coverage = m_steering.oneOf(levels);
  }

  Steering& m_steering;
  const Session m_intended;
  Session m_session;
  std::size_t m_at = 0;  // position now being typed
};

}  // namespace

Session typedSession(std::string_view bytes) {
  Steering steering(bytes);
  const Protocol plan = planFrom(steering);
  const Truth truth = truthFrom(steering);
  Result<Session> intended = simulate(plan, truth, steering.below(256));
  if (!intended) return {};
  return Typist(steering, *std::move(intended)).typed();
}

}  // namespace alidade::fuzz
