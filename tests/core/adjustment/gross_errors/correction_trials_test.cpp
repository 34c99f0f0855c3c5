#include "core/adjustment/gross_errors/correction_trials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/base/angle_text.h"
#include "tests/support/typed_slips.h"

namespace alidade::test {
namespace {

/// Compares with all readings of the session, at the usual risk.
CorrectionTrials trialsOf(const Session& session, const std::stop_token& stop = {}) {
  const Measurement measurement = *examine(session).measurement;
  const SessionFit fit = fitSession(measurement);
  return {session, fittedPart(measurement, fit), fit.joint, 0.01, stop};
}

Session sound(const char* plan) {
  return *simulate(*protocolByName(plan), drawTruth(4), 4);
}

/// The visit of a row as typed; the plans number their points and rounds.
Visited visitAt(const CorrectionTrials& trials, const Session& session, const Place& where) {
  const Reading& row = session.positions[*where.position].readings[*where.reading];
  return trials.visitOf(*where.position, row.round.empty() ? 1 : std::stoi(row.round), std::stoi(row.point));
}

bool restores(const Correction& correction, const std::vector<CellChange>& cure) {
  return std::ranges::is_permutation(correction.changes, cure,
                                     [](const CellChange& one, const CellChange& other) {
                                       return one.where == other.where && one.text == other.text;
                                     });
}

/// Types a wrong reading; returns its correction.
CellChange spoil(Session& session, const Place& where, TypedError error) {
  std::mt19937_64 random(1);
  const std::string intended = cell(session, where);
  cell(session, where) = typedWrongly(intended, error, random);
  return {where, intended};
}

TEST(CorrectionTrials, KnowWhatACellHolds) {
  using enum ReadingKind;
  for (const ReadingKind kind : {Horizontal, Vertical, Slider})
    EXPECT_EQ(kindOf(std::string(nameOf(kind))), kind);
  EXPECT_EQ(kindOf("face"), Horizontal);
}

TEST(CorrectionTrials, GatherTheRowsOfAVisit) {
  const Session session = sound("full");
  const CorrectionTrials trials = trialsOf(session);
  std::size_t rows = 0;
  for (std::size_t arc = 0; arc < 2; ++arc)
    for (const int round : {1, 2})
      for (int point = 1; point <= 17; ++point) {
        const Visited visit = trials.visitOf(arc, round, point);
        for (const std::size_t row : visit.rows) {
          const Reading& reading = session.positions[arc].readings[row];
          EXPECT_EQ(reading.point, std::to_string(point));
          EXPECT_EQ(reading.round, std::to_string(round));
          EXPECT_EQ(visit.with(row).rows, visit.rows) << "it is there already";
        }
        rows += visit.rows.size();
      }
  EXPECT_EQ(rows, trials.measurement().rows);
  EXPECT_EQ((Visited{0, 1, 2, {3, 9}}.with(5).rows), (std::vector<std::size_t>{3, 5, 9}));
  EXPECT_TRUE(trials.visitOf(0, 3, 1).rows.empty());
}

// Errors visible by ten σ and more: of single sightings, with the slider, and in two faces. The visit as
// typed is rejected. The right correction comes first and leaves some noise. All corrections that agree with
// the visit are ordered by score.
TEST(CorrectionTrials, PutWhatWasMeantFirst) {
  using enum TypedError;
  for (const char* plan : {"paper", "paper-slider", "two-face"})
    for (const TypedError error : {DegreeOff, TenMinutesOff, MinuteOff, NeighbouringRow})
      for (const std::uint64_t seed : {1u, 2u}) {
        if (error == NeighbouringRow && std::string(plan) == "two-face")
          continue;  // both rows are then of
                     // the same visit
        SCOPED_TRACE(std::string(plan) + " " + std::to_string(static_cast<int>(error)) + " " +
                     std::to_string(seed));
        const MistypedSession mistyped = mistypedSession(*protocolByName(plan), error, seed);
        CorrectionTrials trials = trialsOf(mistyped.session);
        const Visited visit = visitAt(trials, mistyped.session, mistyped.cure[0].where);
        EXPECT_EQ(trials.grossErrorsIn(visit).size(), 1u);
        EXPECT_EQ(trials.grossErrors().size(), mistyped.cure.size()) << "one in each visit";
        const VisitCheck check = trials.checkOf(visit);
        EXPECT_FALSE(trials.agreesAsTyped(visit, check));
        const std::vector<AgreeingCorrection> tried = trials.agreeing(visit, check);
        ASSERT_FALSE(tried.empty());
        EXPECT_TRUE(restores(tried[0].correction, mistyped.cure));
        EXPECT_LT(std::abs(tried[0].residual.arcseconds()), 5 * 2);
        EXPECT_TRUE(std::ranges::is_sorted(tried, std::ranges::greater(), &AgreeingCorrection::score));
      }
}

// In one face without slider, the score is the sum of three parts: the frequency of the slip, the
// agreement of the row with all others, and the gain in the visit of another changed row. Rounding: 1e-9.
TEST(CorrectionTrials, ScoreBySlipAndBothVisits) {
  using enum TypedError;
  int inOne = 0, inTwo = 0;
  for (const TypedError error : {MinuteOff, TenSecondsOff, NeighbouringRow})
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const MistypedSession mistyped = mistypedSession(*protocolByName("paper"), error, seed);
      CorrectionTrials trials = trialsOf(mistyped.session);
      RowReader reader(mistyped.session);
      const std::size_t arc = *mistyped.cure[0].where.position;
      const Visited visit = visitAt(trials, mistyped.session, mistyped.cure[0].where);
      const VisitCheck check = trials.checkOf(visit);
      for (const AgreeingCorrection& one : trials.agreeing(visit, check)) {
        double expected = std::log(one.correction.prior) + check.agreement({one.sighting}).logLikelihood;
        for (const auto& [row, reading] : one.correction.rows) {
          if (row == visit.rows[0]) continue;
          const Sighting &typed = trials.measurement().arcs[arc].sightings[row],
                         corrected = *reader.read(arc, row, reading);
          const Visited other = trials.visitOf(arc, typed.round, typed.point);
          const VisitCheck ofBoth = trials.checkOf(visit, &other);
          expected += ofBoth.agreement({corrected}).logLikelihood - ofBoth.agreement({typed}).logLikelihood;
        }
        EXPECT_NEAR(one.score, expected, 1e-9);
        ++(one.correction.changes.size() > 1 ? inTwo : inOne);
      }
    }
  EXPECT_GE(inOne, 6);
  EXPECT_GE(inTwo, 3);
}

// The larger of two possible texts for a cell leaves the larger residual, as read. This also holds on a
// zenith circle, in either face and for the slider, whose reading is the first row's. Sound rows read to 5″
// allow many texts.
TEST(CorrectionTrials, TellResidualsAsRead) {
  for (const char* plan : {"paper", "full"}) {
    Truth truth = drawTruth(4);
    truth.sigmaHorizontal = truth.sigmaVertical = Angle::fromArcseconds(5);
    const Session session = *simulate(*protocolByName(plan), truth, 4);
    CorrectionTrials trials = trialsOf(session);
    std::map<std::string, int> compared;
    for (const int point : {2, 7, 14}) {
      const Visited visit = trials.visitOf(1, 1, point);
      const std::vector<AgreeingCorrection> tried = trials.agreeing(visit, trials.checkOf(visit));
      for (std::size_t i = 0; i < tried.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const CellChange &one = tried[i].correction.changes[0], &other = tried[j].correction.changes[0];
          if (tried[i].correction.changes.size() > 1 || one.where != other.where) continue;
          if (one.where.field == "slider" && one.where.reading != visit.rows[0]) continue;
          const double apart = wrapped(*parseAngle(one.text) - *parseAngle(other.text)).radians();
          EXPECT_GT((tried[i].residual - tried[j].residual).radians() * apart, 0)
              << one.where.field << " " << one.text << " " << other.text;
          ++compared[one.where.field];
        }
    }
    EXPECT_EQ(compared.size(), std::string(plan) == "full" ? 3u : 2u);
    for (const auto& [field, times] : compared) EXPECT_GE(times, 10) << field;
  }
}

// At a probability of 10⁻⁴ each, none of 68 visits is expected to fail.
TEST(CorrectionTrials, LetSoundVisitsStandAsTyped) {
  for (const char* plan : {"paper", "full"}) {
    const Session session = sound(plan);
    CorrectionTrials trials = trialsOf(session);
    EXPECT_TRUE(trials.grossErrors().empty());
    for (int point = 1; point <= 17; ++point) {
      const Visited visit = trials.visitOf(1, 1, point);
      EXPECT_TRUE(trials.grossErrorsIn(visit).empty());
      EXPECT_TRUE(trials.agreesAsTyped(visit, trials.checkOf(visit))) << plan << " " << point;
    }
  }
}

// The check excludes the readings of the visit itself, whatever their error. It also excludes those of a
// second named visit, even if 3 σ are too little for a misreading. Two fits from different starts differ by a
// millionth.
TEST(CorrectionTrials, CheckByOtherVisitsAlone) {
  const Session session = sound("paper");
  Session changed = session;
  spoil(changed, {.position = 0, .reading = 5, .field = "vertical"}, TypedError::DegreeOff);
  std::string& neighbour = changed.positions[0].readings[9].vertical;
  neighbour = formatDms(*parseAngle(neighbour) + Angle::fromArcseconds(6), 1, AngleSigns::Typewriter);
  const CorrectionTrials trials = trialsOf(session), ofChanged = trialsOf(changed);
  ASSERT_EQ(ofChanged.grossErrors().size(), 1u);
  const Visited visit = trials.visitOf(0, 1, 6), other = trials.visitOf(0, 1, 10);
  const std::vector<Sighting> rows{trials.measurement().arcs[0].sightings[5]};
  const auto logLikelihood = [&](const CorrectionTrials& of, const Visited* besides) {
    return of.checkOf(visit, besides).agreement(rows).logLikelihood;
  };
  EXPECT_NEAR(logLikelihood(ofChanged, &other), logLikelihood(trials, &other), 1e-6);
  EXPECT_GT(std::abs(logLikelihood(ofChanged, nullptr) - logLikelihood(trials, nullptr)), 1e-3);
}

// The horizontal circle is wrong in face 1 and the vertical circle in face 2. A single slip cannot explain
// both; with either error subtracted, changes of the other cell alone correct the visit.
TEST(CorrectionTrials, MendTwoSlipsOfOneVisitOneByOne) {
  Session session = sound("full");
  const std::vector<CellChange> cures{
      spoil(session, {.position = 1, .reading = 12, .field = "horizontal"}, TypedError::DegreeOff),
      spoil(session, {.position = 1, .reading = 13, .field = "vertical"}, TypedError::TenMinutesOff)};
  CorrectionTrials trials = trialsOf(session);
  const Visited visit = visitAt(trials, session, cures[0].where);
  ASSERT_EQ(visit.rows, (std::vector<std::size_t>{12, 13}));
  const VisitCheck check = trials.checkOf(visit);
  EXPECT_TRUE(trials.agreeing(visit, check).empty());
  const std::vector<GrossError> errors = trials.grossErrorsIn(visit);
  ASSERT_EQ(errors.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const bool isFirst = trials.sightingOf(errors[i].cell).row == 12;
    const std::vector<AgreeingCorrection> tried =
        trials.agreeing(visit, check, {errors[1 - i]}, &errors[i].cell);
    ASSERT_FALSE(tried.empty());
    EXPECT_TRUE(restores(tried[0].correction, {cures[isFirst ? 0 : 1]}));
    for (const AgreeingCorrection& one : tried) {
      ASSERT_EQ(one.correction.changes.size(), 1u);
      EXPECT_EQ(one.correction.changes[0].where, tried[0].correction.changes[0].where);
    }
  }
}

// Both rows of each visit hold the same slider reading, and the fit uses the first. A wrongly typed second
// one is no misread sighting, but the slider needs correction. Of the possible texts for an error of 30″ the
// nearest comes first, 10″ = 2 σ from the next; for a degree, only one text fits.
TEST(CorrectionTrials, HoldTheSliderOfTwoRowsAgainstEachOther) {
  Session session = sound("full");
  std::vector<Reading>& readings = session.positions[0].readings;
  const Place where{.position = 0, .reading = 21, .field = "slider"};
  const std::string intended = readings[21].slider;
  std::string digit = intended;
  const std::size_t tens = digit.find('\'') + 1;
  digit[tens] = digit[tens] < '3' ? static_cast<char>(digit[tens] + 3) : static_cast<char>(digit[tens] - 3);
  std::mt19937_64 random(1);
  for (const std::string& typed : {digit, typedWrongly(intended, TypedError::DegreeOff, random)}) {
    readings[21].slider = typed;
    CorrectionTrials trials = trialsOf(session);
    EXPECT_TRUE(trials.grossErrors().empty());
    const Visited visit = visitAt(trials, session, where);
    const std::vector<AgreeingCorrection> tried = trials.agreeing(visit, trials.checkOf(visit));
    ASSERT_EQ(tried.size() > 1, typed == digit);
    EXPECT_TRUE(restores(tried[0].correction, {{where, intended}})) << typed << " " << intended;
    for (const AgreeingCorrection& one : tried) EXPECT_EQ(one.correction.changes[0].where.field, "slider");
  }
}

TEST(CorrectionTrials, MendRowsThatCouldNotBeUsed) {
  Session session = sound("paper");
  const Place where{.position = 1, .reading = 7, .field = "horizontal"};
  const std::string intended = cell(session, where);
  const std::size_t minutes = intended.find("°") + std::string("°").size();
  cell(session, where)[minutes] = '8';
  CorrectionTrials trials = trialsOf(session);
  const Visited usable = visitAt(trials, session, where), visit = usable.with(7);
  EXPECT_TRUE(usable.rows.empty());
  const VisitCheck check = trials.checkOf(visit);
  EXPECT_FALSE(trials.agreesAsTyped(visit, check));
  const std::vector<AgreeingCorrection> tried = trials.agreeing(visit, check);
  ASSERT_FALSE(tried.empty());
  EXPECT_TRUE(restores(tried[0].correction, {{where, intended}}));
}

// A row that was typed twice occurs in its visit twice, in one face: each copy is sound, but the visit is
// not.
TEST(CorrectionTrials, TakeEachFaceOfAVisitOnce) {
  Session session = sound("two-face");
  std::vector<Reading>& readings = session.positions[1].readings;
  readings.push_back(readings[12]);
  CorrectionTrials trials = trialsOf(session);
  const Visited visit = visitAt(trials, session, {.position = 1, .reading = 12, .field = ""});
  const VisitCheck check = trials.checkOf(visit);
  EXPECT_TRUE(trials.agreesAsTyped(visit, check));
  EXPECT_FALSE(trials.agreesAsTyped(visit.with(readings.size() - 1), check));
}

// The slip is in face 1: a text of face 2 cannot correct it, and exchanging rows changes more than one cell.
TEST(CorrectionTrials, ChangeOneCellAloneWhereAsked) {
  Session session = sound("two-face");
  const CellChange cure =
      spoil(session, {.position = 1, .reading = 12, .field = "horizontal"}, TypedError::TenMinutesOff);
  CorrectionTrials trials = trialsOf(session);
  const Visited visit = visitAt(trials, session, cure.where);
  const VisitCheck check = trials.checkOf(visit);
  for (const std::size_t sighting : {12u, 13u}) {
    const ReadingRef only{1, sighting, ReadingKind::Horizontal};
    EXPECT_EQ(trials.agreeing(visit, check, {}, &only).empty(), sighting == 13) << sighting;
  }
  const MistypedSession exchanged = mistypedSession(*protocolByName("paper"), TypedError::NeighbouringRow, 1);
  CorrectionTrials ofBoth = trialsOf(exchanged.session);
  const Visited one = visitAt(ofBoth, exchanged.session, exchanged.cure[0].where);
  const std::vector<GrossError> errors = ofBoth.grossErrorsIn(one);
  ReadingRef only = errors.at(0).cell;
  only.kind = exchanged.cure[0].where.field == "vertical" ? ReadingKind::Vertical : ReadingKind::Horizontal;
  EXPECT_FALSE(ofBoth.agreeing(one, ofBoth.checkOf(one)).empty());
  EXPECT_TRUE(ofBoth.agreeing(one, ofBoth.checkOf(one), {}, &only).empty());
}

// The slider turns back at its last place: two consecutive rows there read nearly the same and could replace
// each other. A wrongly typed text of one fits neither.
TEST(CorrectionTrials, MendNoRowAtTheCostOfItsNeighbour) {
  Session session = sound("there-and-back");
  const CellChange cure =
      spoil(session, {.position = 0, .reading = 16, .field = "horizontal"}, TypedError::TenMinutesOff);
  ASSERT_EQ(session.positions[0].readings[16].point, session.positions[0].readings[17].point);
  CorrectionTrials trials = trialsOf(session);
  const Visited visit = visitAt(trials, session, cure.where);
  const std::vector<AgreeingCorrection> tried = trials.agreeing(visit, trials.checkOf(visit));
  ASSERT_FALSE(tried.empty());
  EXPECT_TRUE(restores(tried[0].correction, {cure}));
  for (const AgreeingCorrection& one : tried) EXPECT_NE(one.correction.error, EntryError::NeighbouringRow);
}

// A collimation of 100″ that is in the session's model: a slip of a minute is visible. Without the effect all
// readings would scatter as much as the slip.
TEST(CorrectionTrials, KeepToTheModelOfTheSession) {
  Truth truth = drawTruth(4);
  truth.effects = {{ErrorTerm::Collimation, 100}};
  Session session = *simulate(*protocolByName("two-face"), truth, 4);
  session.model.effects = {"collimation"};
  const CellChange cure =
      spoil(session, {.position = 0, .reading = 20, .field = "horizontal"}, TypedError::MinuteOff);
  CorrectionTrials trials = trialsOf(session);
  EXPECT_EQ(trials.grossErrors().size(), 1u);
  const Visited visit = visitAt(trials, session, cure.where);
  const std::vector<AgreeingCorrection> tried = trials.agreeing(visit, trials.checkOf(visit));
  ASSERT_FALSE(tried.empty());
  EXPECT_TRUE(restores(tried[0].correction, {cure}));
}

TEST(CorrectionTrials, FindNothingOnceAskedToStop) {
  Session session = sound("paper");
  spoil(session, {.position = 0, .reading = 5, .field = "vertical"}, TypedError::DegreeOff);
  std::stop_source stop;
  EXPECT_EQ(trialsOf(session, stop.get_token()).grossErrors().size(), 1u);
  stop.request_stop();
  EXPECT_TRUE(trialsOf(session, stop.get_token()).grossErrors().empty());
}

}  // namespace
}  // namespace alidade::test
