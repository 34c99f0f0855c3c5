#include "core/series/instrument_check/check_findings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/angle.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr double halfMillimetre = plausibleOffset;  // the sentences say “half a millimetre”

std::string arcsec(double value) {
  return displayText(value, std::abs(value) < 100 ? 1 : 0) + "″";
}

std::string probability(double p) {
  constexpr double least = 0.001;
  return p < least ? "p < 0.001" : "p = " + displayText(p, 3);
}

/// The angle that an offset e of the line of sight causes at a distance, arcsec.
double shownAt(double metres, double millimetres) {
  return Angle::fromRadians(millimetres * 1e-3 / metres).arcseconds();
}

std::string metresText(double metres) {
  constexpr double near = 100;
  return displayText(metres, metres < near ? 1 : 0) + " m";
}

/// Sentences on one station, with its name if there are several.
class StationFindings {
 public:
  StationFindings(const StationCheck& station, bool isNamed, std::vector<Finding>& findings)
      : m_station(station), m_isNamed(isNamed), m_findings(findings) {}

  void report() {
    if (!m_station.parted.empty()) add(Severity::Warning, m_station.parted);
    reportLeftOut();
    reportExtent();
    if (m_station.pairs() == 0) return;
    reportIdentical();
    reportIndex();
    if (m_station.circles == CheckCircles::Both) {
      reportTilt();
      reportDistance();
    }
    reportCircles();
    reportTargets();
    reportCourse();
  }

 private:
  void add(Severity severity, const std::string& text, const std::string& remedy = {}) {
    m_findings.push_back({severity,
                          m_isNamed ? Phrase::of("Station %1: %2", quotation(m_station.station), text) : text,
                          remedy});
  }

  void reportLeftOut() {
    reportRounds();
    reportKind(LeftOut::RareTarget,
               PHRASE_LATER("Phrase", "Targets missing from most rounds are not used: %1."));
    reportKind(LeftOut::OneFace, PHRASE_LATER("Phrase", "Sighted in one face only and not used: %1."));
    reportKind(
        LeftOut::FarApart,
        PHRASE_LATER("Phrase", "The faces differ by more than 2° (different targets, or misread): %1."));
    reportKind(LeftOut::Repeated,
               PHRASE_LATER("Phrase", "Sighted several times in one face of a round, and averaged: %1."));
  }

  void reportRounds() {
    std::vector<std::string> rounds;
    for (const LeftOutReadings& left : m_station.leftOut)
      if (left.why == LeftOut::IncompleteRound)
        rounds.push_back(Phrase::of("%1 (lacks %2)", shortened(left.round, 40), quotation(left.target)));
    if (!rounds.empty())
      add(Severity::Note,
          Phrase::of("Rounds without both faces of every target are not used: %1.", firstOf(rounds)));
  }

  void reportKind(LeftOut why, const char* sentence) {
    std::vector<std::string> places;
    for (const LeftOutReadings& left : m_station.leftOut)
      if (left.why == why)
        places.push_back(left.round.empty() ? quotation(left.target)
                                            : Phrase::of("%1 in round %2", quotation(left.target),
                                                         shortened(left.round, 40)));
    if (!places.empty()) add(Severity::Note, Phrase::of(sentence, firstOf(places)));
  }

  static std::string firstOf(std::vector<std::string> entries) {
    constexpr std::size_t most = 5;
    if (entries.size() <= most) return listed(entries);
    const std::size_t more = entries.size() - most;
    entries.resize(most);
    return Phrase::of("%1 and %2 more", listed(entries), more);
  }

  void reportExtent() {
    if (m_station.pairs() == 0) {
      return add(
          Severity::Warning, Phrase::of("There is no complete round, with each target in both faces."),
          Phrase::of("Sight every target in face 1 and in face 2, and give it the same name in both."));
    }
    if (m_station.rounds == 1)
      return add(
          Severity::Warning,
          Phrase::of("One complete round shows collimation and index, but not how far readings scatter."),
          Phrase::of("Observe three rounds or more."));
    if (m_station.circles == CheckCircles::VerticalOnly) return;
    if (m_station.targets == 1)
      return add(
          Severity::Warning,
          Phrase::of(
              "With one target, the scatter of directions is unknown; only the vertical circle is checked."),
          Phrase::of("Sight four targets or more, spread around the horizon."));
    constexpr std::size_t fewestRounds = 3, fewestTargets = 4;
    if (m_station.rounds < fewestRounds || m_station.targets < fewestTargets)
      add(Severity::Note, Phrase::of("ISO 17123-3 requires at least three rounds to four targets; with %1 "
                                     "degrees of freedom, s of a direction is only a rough figure.",
                                     displayText(m_station.direction.degreesOfFreedom, 0)));
  }

  void reportCircles() {
    if (m_station.circles == CheckCircles::HorizontalOnly)
      add(Severity::Note, Phrase::of("Only directions were read: the collimation applies to targets near the "
                                     "horizon; index and zenith angles are not evaluated."));
    if (m_station.circles == CheckCircles::VerticalOnly)
      add(Severity::Note,
          Phrase::of("Only zenith angles were read: collimation and directions are not evaluated."));
  }

  void reportIdentical() {
    if (m_station.vertical.degreesOfFreedom + m_station.direction.degreesOfFreedom > 0 &&
        m_station.direction.sumOfSquares == 0 && m_station.vertical.sumOfSquares == 0)
      add(Severity::Warning, Phrase::of("All rounds are identical: s is 0."),
          Phrase::of("Check whether one round was entered several times."));
  }

  /// Question c) of ISO 17123-3: does the index differ from zero?
  void reportIndex() {
    const PairMean& index = m_station.index;
    if (!(index.u > 0)) return;
    const double p = twoSidedStudent(index.value, index.u, index.degreesOfFreedom);
    if (p < levelOfTests)
      add(Severity::Note, Phrase::of("The index of %1 differs from zero by more than its scatter (%2): "
                                     "correct readings in a single face for this index.",
                                     withU(index.value, index.u, "″"), probability(p)));
  }

  void reportTilt() {
    constexpr double spread = 0.5;  // degrees: the smallest spread of elevations in which a tilt is sought
    if (m_station.causes.tilt) return reportStatedTilt(*m_station.causes.tilt);
    if (!(m_station.highestDeg - m_station.lowestDeg > spread))
      return add(Severity::Note,
                 Phrase::of("All targets lie at about the same elevation (%1° to %2°): a tilt of the "
                            "trunnion axis is indistinguishable from collimation.",
                            displayText(m_station.lowestDeg, 1), displayText(m_station.highestDeg, 1)),
                 Phrase::of("Sight a steep target as well."));
    if (!std::isfinite(m_station.causes.tiltShows) || m_station.causes.isEither) return;
    add(Severity::Note,
        Phrase::of("A tilt of the trunnion axis is indistinguishable from collimation here: with elevations "
                   "from %2° to %3°, a tilt of 30″ amounts to only %1 standard uncertainties.",
                   displayText(m_station.causes.tiltShows, 1), displayText(m_station.lowestDeg, 1),
                   displayText(m_station.highestDeg, 1)),
        Phrase::of("Sight a steep target as well."));
  }

  void reportStatedTilt(const TwoCauses& tilt) {
    if (m_station.causes.isEither) reportEither();
    if (tilt.pValue < levelOfTests)
      add(Severity::Warning,
          Phrase::of(
              "The trunnion axis is tilted by %1 (%2); corrected for this tilt, the collimation is %3.",
              withU(tilt.other, tilt.uOther, "″"), probability(tilt.pValue), collimation()));
  }

  void reportEither() {
    add(Severity::Warning,
        Phrase::of("With these targets, a tilt of the trunnion axis is indistinguishable from an offset of "
                   "the line of sight: the result states the one whose size is more usual."),
        Phrase::of("Sight near and far targets at the same elevation as well."));
  }

  std::string collimation() const { return withU(m_station.collimation.value, m_station.collimation.u, "″"); }

  void reportDistance() {
    const double nearest = m_station.nearestM;
    if (!(nearest > 0))
      return add(Severity::Note,
                 Phrase::of("Not all distances are known. An offset e of the line of sight from the axis "
                            "shows as e/D, which at short distances looks like collimation: half a "
                            "millimetre is 43″ at 2.4 m and 2″ at 50 m."));
    if (m_station.causes.lineOfSight) return reportStatedOffset(*m_station.causes.lineOfSight);
    if (m_station.causes.isEither) return;
    const std::string half = arcsec(shownAt(nearest, halfMillimetre));
    if (!std::isfinite(m_station.causes.offsetShows)) return reportSameDistance(half);
    add(Severity::Note,
        Phrase::of("An offset e of the line of sight from the axis shows as e/D and looks like collimation. "
                   "These distances (%1 to %2) cannot separate the two: half a millimetre, %3 at the nearest "
                   "target, amounts to only %4 standard uncertainties.",
                   metresText(nearest), metresText(m_station.farthestM), half,
                   displayText(m_station.causes.offsetShows, 1)));
  }

  void reportSameDistance(const std::string& half) {
    constexpr double farAway = 200;  // m; half a millimetre is then half an arcsecond
    if (m_station.nearestM < farAway)
      add(Severity::Note,
          Phrase::of("All targets are at about the same distance. An offset e of the line of sight from the "
                     "axis shows as e/D and looks like collimation: half a millimetre is %1 at %2.",
                     half, metresText(m_station.nearestM)),
          Phrase::of("Sight targets at other distances as well."));
  }

  void reportStatedOffset(const TwoCauses& sight) {
    if (m_station.causes.isEither) reportEither();
    if (sight.pValue < levelOfTests)
      return add(Severity::Warning,
                 Phrase::of("The difference of the faces is proportional to 1/D: the line of sight is %1 "
                            "(%2) off the axis, which looks like a collimation of %3 at %4. Corrected for "
                            "this offset, the collimation is %5.",
                            withU(sight.other, sight.uOther, " mm"), probability(sight.pValue),
                            arcsec(shownAt(m_station.nearestM, sight.other)), metresText(m_station.nearestM),
                            collimation()));
    add(Severity::Note, Phrase::of("The difference of the faces does not depend significantly on the "
                                   "distance: the line of sight is %1 off the axis.",
                                   withU(sight.other, sight.uOther, " mm")));
  }

  void reportTargets() {
    if (m_station.targetsDifferP < levelOfTests && !m_station.causes.collimation)
      add(Severity::Note, Phrase::of("The collimation differs between targets by more than its scatter (%1): "
                                     "tilt of the trunnion axis, distance, or the way a target is sighted. "
                                     "Its u is taken from the differences between the targets.",
                                     probability(m_station.targetsDifferP)));
  }

  void reportCourse() {
    if (m_station.isCircleReset)
      add(Severity::Note, Phrase::of("The circle was reset between rounds, so a drift of the orientation "
                                     "between them does not show."));
    reportSlope(m_station.orientationSlope,
                PHRASE_LATER("Phrase", "The orientation drifts by %1 a round (%2)."));
    reportSlope(m_station.collimationSlope,
                PHRASE_LATER("Phrase", "The collimation drifts by %1 a round (%2)."));
    reportSlope(m_station.indexSlope, PHRASE_LATER("Phrase", "The index drifts by %1 a round (%2)."));
  }

  void reportSlope(const std::optional<RoundTrend>& slope, const char* sentence) {
    if (slope && slope->pValue < levelOfTests)
      add(Severity::Warning,
          Phrase::of(sentence, withU(slope->perRound, slope->u, "″"), probability(slope->pValue)));
  }

  const StationCheck& m_station;
  bool m_isNamed;
  std::vector<Finding>& m_findings;
};

void reportTest(const std::optional<SigmaTest>& test, const CheckScatter& scatter, const char* within,
                const char* beyond, std::vector<Finding>& findings) {
  if (!test) return;
  const std::string s = displayText(scatter.s(), 2) + "″", limit = displayText(test->limit, 2) + "″",
                    sigma = displayShortest(test->sigma) + "″", nu = displayText(scatter.degreesOfFreedom, 0);
  findings.push_back({test->isWithin() ? Severity::Note : Severity::Warning,
                      Phrase::of(test->isWithin() ? within : beyond, s, sigma, limit, nu)});
}

void reportStations(const InstrumentCheck& check, std::vector<Finding>& findings) {
  const auto report = [&](double p, const char* sentence) {
    if (p < levelOfTests) findings.push_back({Severity::Warning, Phrase::of(sentence, probability(p))});
  };
  for (const TwoSamples& sample : check.samples) {
    const auto reportSample = [&](double p, const char* ofTwo, const char* ofSeveral) {
      if (!(p < levelOfTests)) return;
      findings.push_back(
          {Severity::Warning,
           sample.second.empty()
               ? Phrase::of(ofSeveral, quotation(sample.first), probability(p))
               : Phrase::of(ofTwo, quotation(sample.first), quotation(sample.second), probability(p))});
    };
    reportSample(
        sample.directionP,
        PHRASE_LATER("Phrase", "s of a direction is not the same at stations %1 and %2 (F test, %3)."),
        PHRASE_LATER("Phrase",
                     "s of a direction at station %1 differs from that of the others (F test, %2)."));
    reportSample(
        sample.verticalP,
        PHRASE_LATER("Phrase", "s of a zenith angle is not the same at stations %1 and %2 (F test, %3)."),
        PHRASE_LATER("Phrase",
                     "s of a zenith angle at station %1 differs from that of the others (F test, %2)."));
  }
  report(
      check.collimationsDifferP,
      PHRASE_LATER("Phrase",
                   "The collimation differs between stations by more than its scatter (%1): the collimation "
                   "has changed, or an indistinguishable effect has."));
  report(
      check.indicesDifferP,
      PHRASE_LATER("Phrase",
                   "The index differs between stations by more than its scatter (%1): the index changed."));
}

}  // namespace

std::string withU(double value, double u, const std::string& unit) {
  constexpr int mostDecimals = 4, usual = 1;
  if (!std::isfinite(value)) return displayText(value, 0);
  const int decimals = std::min(decimalsFor(u, usual), mostDecimals);
  const std::string text = displayText(value, decimals) + unit;
  return std::isfinite(u) ? text + " ± " + displayText(u, decimals) + unit : text;
}

std::vector<Finding> checkFindings(const InstrumentCheck& check) {
  std::vector<Finding> findings;
  reportTest(
      check.directionTest, check.direction,
      PHRASE_LATER("Phrase",
                   "s of a direction, %1, is not significantly larger than the stated %2 (χ² test, 95 "
                   "%: s up to %3 with %4 degrees of freedom)."),
      PHRASE_LATER("Phrase",
                   "s of a direction, %1, is significantly larger than the stated %2 (χ² test, 95 %: s "
                   "up to %3 with %4 degrees of freedom)."),
      findings);
  reportTest(
      check.verticalTest, check.vertical,
      PHRASE_LATER("Phrase",
                   "s of a zenith angle, %1, is not significantly larger than the stated %2 (χ² test, "
                   "95 %: s up to %3 with %4 degrees of freedom)."),
      PHRASE_LATER("Phrase",
                   "s of a zenith angle, %1, is significantly larger than the stated %2 (χ² test, 95 %: "
                   "s up to %3 with %4 degrees of freedom)."),
      findings);
  reportStations(check, findings);
  for (const StationCheck& station : check.stations)
    StationFindings(station, check.stations.size() > 1, findings).report();
  return findings;
}

}  // namespace alidade
