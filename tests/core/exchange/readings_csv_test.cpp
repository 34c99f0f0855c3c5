#include "core/exchange/readings_csv.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "core/exchange/import.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// The session without its rows, as the target of an import in the window.
Session withoutRows(Session session) {
  for (Position& position : session.positions) position.readings.clear();
  return session;
}

Import importedInto(const Session& base, const std::string& csv) {
  ImportOptions options;
  options.base = base;
  const Result<Import> import = importReadings({{.name = {}, .bytes = csv}}, options);
  EXPECT_TRUE(import) << import.problem().text();
  return import ? *import : Import{};
}

void expectSameRows(const Session& read, const Session& written) {
  ASSERT_EQ(read.positions.size(), written.positions.size());
  for (std::size_t p = 0; p < written.positions.size(); ++p) {
    const auto &is = read.positions[p].readings, &was = written.positions[p].readings;
    ASSERT_EQ(is.size(), was.size());
    for (std::size_t row = 0; row < was.size(); ++row) {
      EXPECT_EQ(is[row].horizontal, was[row].horizontal);
      EXPECT_EQ(is[row].vertical, was[row].vertical);
      EXPECT_EQ(is[row].slider, was[row].slider);
      EXPECT_EQ(is[row].excluded, was[row].excluded);
      EXPECT_EQ(is[row].note, was[row].note);
    }
  }
}

void expectSameMeasurement(const Session& read, const Session& written) {
  const Examined is = examine(read), was = examine(written);
  ASSERT_EQ(is.problems.size(), was.problems.size());
  ASSERT_EQ(is.measurement.has_value(), was.measurement.has_value());
  if (!was.measurement) return;
  ASSERT_EQ(is.measurement->arcs.size(), was.measurement->arcs.size());
  for (std::size_t arc = 0; arc < was.measurement->arcs.size(); ++arc) {
    const ArcMeasurement &a = is.measurement->arcs[arc], &b = was.measurement->arcs[arc];
    EXPECT_EQ(a.axisDeg, b.axisDeg);
    EXPECT_EQ(a.repeat, b.repeat);
    ASSERT_EQ(a.sightings.size(), b.sightings.size());
    for (std::size_t i = 0; i < b.sightings.size(); ++i) {
      const Sighting &one = a.sightings[i], &other = b.sightings[i];
      EXPECT_EQ(std::tuple(one.point, one.round, one.face, one.a.radians(), one.e.radians()),
                std::tuple(other.point, other.round, other.face, other.a.radians(), other.e.radians()));
      EXPECT_EQ(one.slider.has_value(), other.slider.has_value());
      if (one.slider && other.slider) {
        EXPECT_EQ(one.slider->radians(), other.slider->radians());
      }
    }
  }
}

void expectRoundTrip(const Session& session) {
  const Import import = importedInto(withoutRows(session), readingsCsv(session));
  EXPECT_EQ(import.format, "CSV");
  expectSameRows(import.session, session);
  expectSameMeasurement(import.session, session);
}

TEST(ReadingsCsv, EverySampleReadsBack) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ALIDADE_SAMPLES_DIR)) {
    if (entry.path().extension() != ".alidade") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const Result<Session> session = loadSession(entry.path().string());
    ASSERT_TRUE(session);
    expectRoundTrip(*session);
    ++count;
  }
  EXPECT_GE(count, 10);
}

// The sessions have any order of turns, with rounds, faces, slider readings and elevation circles.
TEST(ReadingsCsv, SimulatedSessionsReadBack) {
  const std::vector<std::vector<int>> orders{{0}, {180}, {0, 180}, {0, 180, 180}, {0, 180, 0, 180, 180}};
  for (const auto& axes : orders)
    for (const char* name : {"paper", "full"}) {
      Protocol protocol = *protocolByName(name);
      protocol.axes = axes;
      const Result<Session> session = simulate(protocol, drawTruth(3), 3);
      ASSERT_TRUE(session) << session.problem().text();
      SCOPED_TRACE(std::string(name) + ", turns " + std::to_string(axes.size()));
      expectRoundTrip(*session);
    }
}

TEST(ReadingsCsv, WhatSomebodyWroteReadsBack) {
  Session session = paperSession();
  std::vector<Reading>& rows = session.positions[0].readings;
  rows[0].note = "=HYPERLINK(\"http://x\";\"y\")";
  rows[1].note = "'+1, 'quoted' and # more";
  rows[2].note = "@all - wind, \"gusts\"; αβ";
  rows[3].note = "-12.5";
  rows[4].horizontal = "=2*3";  // protected in the table, and kept
  rows[5].excluded = true;
  rows[6].round = "7";
  rows[7].point = "200";
  rows[8].slider = "-12°30'";
  const std::string csv = readingsCsv(session);
  EXPECT_THAT(csv, HasSubstr(",'=2*3,"));
  EXPECT_THAT(csv, HasSubstr("\"'=HYPERLINK("));
  EXPECT_THAT(csv, HasSubstr(",-12.5\n")) << "a number stays one";
  EXPECT_THAT(csv, HasSubstr(",-12°30',"));
  expectRoundTrip(session);
}

TEST(ReadingsCsv, WhatCameFromTheInstrumentReadsBack) {
  Session session = paperSession();
  EXPECT_THAT(readingsCsv(session), Not(HasSubstr("taken_at"))) << "nothing came with any row";
  Reading& row = session.positions[1].readings[2];
  row.takenAt = "2026-03-14T15:09:26+01:00";
  row.returnCode = "1284";
  row.instrumentSerial = "0012";
  session.positions[0].zero.takenAt = "2026-03-14T15:00:00Z";
  const std::string csv = readingsCsv(session);
  EXPECT_THAT(csv, HasSubstr("2026-03-14T15:00:00Z"));
  const Import import = importedInto(withoutRows(session), csv);
  EXPECT_TRUE(import.problems.empty());
  expectSameRows(import.session, session);
  const Reading& read = import.session.positions[1].readings[2];
  EXPECT_EQ(read.takenAt, row.takenAt);
  EXPECT_EQ(read.returnCode, row.returnCode);
  EXPECT_EQ(read.instrumentSerial, row.instrumentSerial);
  expectSameMeasurement(import.session, session);
}

TEST(ReadingsCsv, NamesTheVerticalCircle) {
  Session session = paperSession();
  EXPECT_THAT(readingsCsv(session),
              StartsWith("axis,point,round,face,horizontal,zenith,slider,excluded,note\n"));
  session.geometry.verticalCircle = "elevation";
  EXPECT_THAT(readingsCsv(session), HasSubstr(",elevation,"));
  Session base = blankSession();
  base.geometry.verticalCircle.clear();
  EXPECT_EQ(importedInto(base, readingsCsv(session)).session.geometry.verticalCircle, "elevation");
}

TEST(ReadingsCsv, HoldsThePointingZeros) {
  Session session = paperSession();
  PointingZero& further = session.positions[0].zero;
  further.faceTwo = {"152°32'51\"", "270°00'05\""};
  further.after = {.horizontal = "332°32'40\"", .vertical = "90°00'10\"", .takenAt = "2026-03-14T15:00:00Z"};
  further.afterInTwo = {"152°32'41\"", "269°59'55\""};
  Session base = blankSession();
  base.positions.clear();
  const Session read = importedInto(base, readingsCsv(session)).session;
  ASSERT_EQ(read.positions.size(), 2u);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(read.positions[p].zero, session.positions[p].zero);
    EXPECT_EQ(read.positions[p].readings.size(), session.positions[p].readings.size());
  }
}

TEST(ReadingsCsv, LeavesOutRowsThatNobodyBegan) {
  Session session = paperSession();
  for (Reading& row : session.positions[1].readings) row.point.clear();
  session.positions[1].readings.insert(session.positions[1].readings.begin() + 2, Reading{});
  const std::string csv = readingsCsv(session);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 34 + 2);
  EXPECT_THAT(csv, HasSubstr("\n180,4,1,1,")) << "the row behind it keeps its number as its point";
  EXPECT_THAT(csv, Not(HasSubstr("\n180,3,")));
}

TEST(ReadingsCsv, ATurnThatIsNoneIsRefused) {
  const Import import = importedInto(blankSession(),
                                     "axis,turn,point,horizontal,zenith\n0,zero,1,10 00 00,80 00 00\n"
                                     "0,1,2,11 00 00,80 00 00\n");
  ASSERT_EQ(import.problems.size(), 1u);
  EXPECT_EQ(import.problems[0].text(),
            "line 2, column 3: “zero” is no turn: turns of the axis are numbered from 1");
}

TEST(ReadingsCsv, TurnsCountWithoutGaps) {
  Session base = blankSession();
  base.positions.clear();
  const Session read = importedInto(base,
                                    "axis,turn,point,horizontal,zenith\n0,3,1,10 00 00,80 00 00\n"
                                    "0,900000000,1,11 00 00,80 00 00\n")
                           .session;
  ASSERT_EQ(read.positions.size(), 2u);
  EXPECT_EQ(read.positions[1].readings[0].horizontal, "11 00 00");
}

}  // namespace
}  // namespace alidade::test
