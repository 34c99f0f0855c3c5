#include "ui/report/acceptance_report.h"
#include "core/base/version.h"
#include "core/diagnosis/diagnose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <algorithm>

#include "core/evaluation/evaluation.h"
#include "core/session/session_file.h"
#include "core/session/sighting_protocol.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/statement/budget.h"
#include "core/statement/gap.h"
#include "core/wording/size_text.h"
#include "core/wording/suspects.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"
#include "ui/report/empty_fields.h"
#include "ui/text/cause_text.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

TEST(AcceptanceReport, PrintsTheResultWithItsUncertaintyAndVerdict) {
  const Printed report(paperSession());
  const Evaluation evaluation = evaluate(paperSession());
  const Intersection& found = *evaluation.fit.intersection;
  const QString& front = report.page(0);
  EXPECT_TRUE(front.contains(QStringLiteral("Acceptance report")));
  EXPECT_TRUE(front.contains(QString::fromStdString(evaluation.session.title)));
  EXPECT_TRUE(front.contains(QStringLiteral("Accepted")));
  EXPECT_TRUE(front.contains(QStringLiteral("Δd, fit only: ") +
                             qText(sizeWithExpanded(found.value, found.expanded, "mm"))));
  for (const char* value :
       {"tolerance ± 2.5 mm", "2405 mm", "400 mm", "O1 at 0° −0.834", "401.954", "O2 at 180°", "403.914",
        "9.37 53.35", "8.33 42.17", "|O1 − O2|/2 = 1.35 ± 0.21 mm", "zenith", "σ pointing zero", "95 %",
        "Warning", "Operator, date"}) {
    EXPECT_TRUE(front.contains(QString::fromUtf8(value))) << value << "\n" << front.toStdString();
  }
}

TEST(AcceptanceReport, NamesAProtocolThatWasChosen) {
  Session session = paperSession();
  SightingProtocol protocol = usualProtocol();
  session.protocol = protocolText(protocol);
  EXPECT_FALSE(Printed(session).contains("17 places, one face")) << "nobody chose it";
  protocol.isYielding = false;
  session.protocol = protocolText(protocol);
  EXPECT_TRUE(Printed(session).contains("17 places, one face"));
}

// Δz is in the headline with and without a verdict.
TEST(AcceptanceReport, TellsWhatLiesAcrossThePlane) {
  const auto front = [](const char* coverage) {
    Session session = paperSession();
    session.acceptance.coverage = coverage;
    return Printed(session).page(0).simplified();
  };
  const QString verdict =
      QStringLiteral("perpendicular to it, the arc's centre is 5.9 mm ± 1.2 mm from the axis");
  EXPECT_TRUE(
      front("0.95").contains(QStringLiteral("Across the plane of the arc: Δz = −5.9 ± 1.2 mm, not judged")));
  EXPECT_TRUE(front("0.95").contains(verdict));
  EXPECT_TRUE(front("0.8").contains(QStringLiteral("Across the plane of the arc: Δz = −5.9")));
  EXPECT_FALSE(front("0.8").contains(verdict)) << "the verdict is withheld";
}

TEST(AcceptanceReport, PrintsTheModelEffectsThatWereEstimatedAlong) {
  const Session session = *readSession(paperTextWithEffects({"trunnion_tilt"}));
  const EffectEstimate effect = evaluate(session).fit.effects.at(0);
  const int decimals = decimalsFor(effect.sigma);
  const QString row = QStringLiteral("trunnion tilt %1″ %2″")
                          .arg(numberText(effect.value, decimals), numberText(effect.sigma, decimals));
  const Printed report(session);
  EXPECT_TRUE(report.contains("Model effects"));
  EXPECT_TRUE(report.text().contains(row)) << row.toStdString() << report.text().toStdString();
  EXPECT_FALSE(Printed(paperSession()).contains("Model effects"));
}

QString estimateText(const std::optional<IntersectionEstimate>& estimate) {
  return qText(sizeWithExpanded(estimate->value, estimate->expanded, ""));
}

TEST(AcceptanceReport, TellsTheGapAndItsCause) {
  const QString folder = QStringLiteral(ALIDADE_REFERENCE_DIR "/trials/sessions/");
  Session session = *loadSession((folder + QStringLiteral("117223.alidade")).toStdString());  // gravity sag
  const Diagnosis diagnosis = *diagnose(*examine(session).measurement);
  const CauseParameter& sag = diagnosis.causes.at(0).parameters.at(0);
  constexpr double coverageFactor = 1.95996;  // of 95 %, normal distribution
  const Printed report(session);
  EXPECT_TRUE(report.contains("Gap between model and readings"));
  EXPECT_TRUE(report.contains("One cause: gravity sag."));
  for (const QString& text :
       {QStringLiteral("Gravity sag ") +
            qText(sizeWithExpanded(sag.value, coverageFactor * sag.sigma, sag.unit)),
        QStringLiteral("fit only ") + numberText(diagnosis.gap.rms, 2), estimateText(diagnosis.before),
        QStringLiteral("+ gravity sag ") + numberText(diagnosis.after.rms, 2),
        estimateText(diagnosis.afterwards),
        QStringLiteral("measured — — ") + estimateText(diagnosis.measured->estimate)})
    EXPECT_TRUE(report.text().contains(text)) << text.toStdString() << report.text().toStdString();
  const QString paper = Printed(paperSession()).text().simplified();
  EXPECT_TRUE(paper.contains(QStringLiteral("With the causes in the model, the two positions agree.")))
      << paper.toStdString();
  session.model.effects = {"gravity_sag"};
  EXPECT_TRUE(Printed(session).contains("in the model: gravity sag"));
  const Session clean = *loadSession((folder + QStringLiteral("827247.alidade")).toStdString());
  EXPECT_FALSE(Printed(clean).contains("Gap between")) << "there is none";
}

TEST(AcceptanceReport, PrintsWhatMustAgreeBeforeAndWithTheCauses) {
  const Session session = paperSession();
  const Diagnosis diagnosis = *diagnose(*examine(session).measurement);
  ASSERT_EQ(diagnosis.closures.size(), 4u) << "radius, centre, and both circles of the zeros";
  const Printed report(session);
  EXPECT_TRUE(report.contains("Closures: what must agree"));
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(session)));
  for (const Statement::Row& closure : gapClosures(gap).rows) {
    QStringList cells;
    for (std::size_t i = 1; i < closure.cells.size(); ++i) cells.append(qText(closure.cells[i]));
    const QString row = cells.join(u' ');
    EXPECT_TRUE(report.text().contains(row)) << row.toStdString() << report.text().toStdString();
  }
  EXPECT_FALSE(report.contains("Sizes that would explain")) << "no σ of the reference is stated";
  Session half = session;
  half.positions.resize(1);
  EXPECT_FALSE(Printed(half).contains("Closures: what must agree"));
}

TEST(AcceptanceReport, PrintsWhatItWouldTakeToExplainTheReference) {
  const QString path = QStringLiteral(ALIDADE_REFERENCE_DIR "/closures/sessions/292351.alidade");
  const Session session = *loadSession(path.toStdString());
  const Diagnosis diagnosis = *diagnose(*examine(session).measurement);
  ASSERT_GE(diagnosis.whatItWouldTake.size(), 2u);
  const Printed report(session);
  EXPECT_TRUE(report.contains("Sizes that would explain Δd − reference"));
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(session)));
  const std::vector<Statement::Row> rows = gapRequired(gap).rows;
  ASSERT_EQ(rows.size(), diagnosis.whatItWouldTake.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Required& required = diagnosis.whatItWouldTake[i];
    EXPECT_EQ(rows[i].cells[1], sizeText(required.size, required.unit));
    QStringList cells;
    for (const std::string& cell : rows[i].cells) cells.append(qText(cell));
    const QString row = cells.join(u' ');
    EXPECT_TRUE(report.text().contains(row)) << row.toStdString() << report.text().toStdString();
  }
  EXPECT_TRUE(report.contains("(u 0.02 mm)")) << "σ of the reference";
}

TEST(AcceptanceReport, StatesTheSigmaOfR0WhereItIsStated) {
  Session session = paperSession();
  EXPECT_FALSE(Printed(session).contains("400 mm, σ"));
  session.geometry.sigmaRadiusMm = "0.05";
  EXPECT_TRUE(Printed(session).contains("400 mm, σ 0.05 mm"));
}

// No plan of readings detects a jump between the zero and the first place; only sighting the zero again does.
// Both faces and slider readings detect the other effects that this plan misses.
TEST(AcceptanceReport, TellsWhatTheReadingsWouldNotShow) {
  const Session onePlan = *simulate(*protocolByName("paper"), drawTruth(1), 1);
  const Diagnosis diagnosis = *diagnose(*examine(onePlan).measurement);
  ASSERT_FALSE(diagnosis.undetectable.empty());
  const Printed report(onePlan);
  EXPECT_TRUE(report.contains("Undetectable here"));
  const UndetectableEffect& worst = diagnosis.undetectable.front();
  const QString figure = numberText(worst.influence, decimalsFor(worst.influence));
  const QString text = report.text().simplified();
  EXPECT_TRUE(text.contains(causeTitle(worst.effect) + QStringLiteral(" ± ") + figure)) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("would show "))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("Arc ellipticity ±")));
  const QString full = Printed(*simulate(*protocolByName("full"), drawTruth(1), 1)).text().simplified();
  EXPECT_TRUE(full.contains(QStringLiteral("The pointing zero sighted again"))) << full.toStdString();
  EXPECT_FALSE(full.contains(QStringLiteral("Arc ellipticity ±")));
}

// Both results and the undetectable effects are on the first page, next to the verdict.
TEST(AcceptanceReport, PutsBothAccountsAndWhatIsUnseenBesideTheVerdict) {
  Session session = *loadSession(samplePath(QStringLiteral("two-causes.alidade")).toStdString());
  session.acceptance.toleranceMm = "0.43";
  const QString contradicted = Printed(session).page(0).simplified();
  EXPECT_TRUE(contradicted.contains(QStringLiteral("Undecided"))) << contradicted.toStdString();
  EXPECT_THAT(contradicted.toStdString(),
              testing::ContainsRegex("Δd = 0\\.4[0-9]+ ± 0\\.[01][0-9]+ mm Undecided · tolerance ± 0\\.43 mm "
                                     ".*Δd, fit only: 0\\.383 ± 0\\.038 mm"));
  EXPECT_FALSE(contradicted.contains(QStringLiteral("Accepted ·")));

  const Session sound = *simulate(*protocolByName("paper"), drawTruth(1), 1);
  const Diagnosis diagnosis = *diagnose(*examine(sound).measurement);
  ASSERT_GT(diagnosis.undetectable.front().influence, diagnosis.measured->estimate.expanded);
  const QString front = Printed(sound).page(0).simplified();
  EXPECT_TRUE(front.contains(QStringLiteral("moves Δd by more than U: ") +
                             causeName(diagnosis.undetectable[0].effect)))
      << front.toStdString();
  EXPECT_FALSE(front.contains(QStringLiteral("nothing in the data speaks against")));
}

/// A line of the first page with its letter size, according to poppler.
struct PrintedLine {
  QString text;
  int size = 0;
};

QList<PrintedLine> firstPageOf(const Printed& report) {
  const QString xml = report.tool(QStringLiteral("pdftohtml"),
                                  {QStringLiteral("-xml"), QStringLiteral("-i"), QStringLiteral("-l"),
                                   QStringLiteral("1"), QStringLiteral("-stdout"), report.path()});
  QMap<QString, int> sizes;
  QList<PrintedLine> lines;
  QXmlStreamReader reader(xml);
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    const QXmlStreamAttributes is = reader.attributes();
    if (reader.name() == QStringLiteral("fontspec"))
      sizes[is.value(QStringLiteral("id")).toString()] = is.value(QStringLiteral("size")).toInt();
    if (reader.name() == QStringLiteral("text"))
      lines.append({reader.readElementText(QXmlStreamReader::IncludeChildElements),
                    sizes.value(is.value(QStringLiteral("font")).toString())});
  }
  return lines;
}

// Only the title, Δd, measured, and the verdict are in large type.
TEST(AcceptanceReport, HasTheMeasuredResultAloneInLargeTypeOnTheFirstPage) {
  const QString measured = QStringLiteral("Δd = 1.24 ± 0.79 mm");
  const QString fitOnly = QStringLiteral("Δd, fit only: 1.31 ± 0.21 mm");
  const QList<PrintedLine> lines = firstPageOf(Printed(paperSession()));
  const auto at = std::ranges::find(lines, measured, &PrintedLine::text);
  const auto below =
      std::ranges::find_if(lines, [&](const PrintedLine& line) { return line.text.contains(fitOnly); });
  ASSERT_TRUE(at != lines.end() && below != lines.end());
  EXPECT_LT(at, below);
  EXPECT_GT(at->size, 1.5 * below->size);
  QStringList large;
  for (const PrintedLine& line : lines)
    if (line.size >= at->size) large.append(line.text);
  EXPECT_EQ(large, QStringList({QStringLiteral("Acceptance report"), measured,
                                QStringLiteral("Accepted · tolerance ± 2.5 mm")}))
      << large.join(u'\n').toStdString();
  EXPECT_TRUE(std::none_of(lines.begin(), at, [](const PrintedLine& line) {
    return line.text.contains(QStringLiteral("Δd"));
  })) << "it comes first";
}

/// The first page of a report with this gap.
QString frontPage(const Gap& gap) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("report.pdf"));
  ReportOptions options;
  options.gap = std::make_shared<const Gap>(gap);
  EXPECT_TRUE(writeAcceptanceReport(*gap.evaluation, Printed::savedSource(), path, options));
  return printedText(path).section(u'\f', 0, 0).simplified();
}

TEST(AcceptanceReport, StatesNoMoreOfTheMeasurementThanIsKnown) {
  Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(paperSession())));
  gap.diagnosis->measured.reset();
  const QString fitOnly = QStringLiteral("Δd, fit only: 1.31 ± 0.21 mm");
  const QString undetermined = frontPage(gap);
  EXPECT_TRUE(
      undetermined.contains(QStringLiteral("Δd: not determined by these readings Undecided · "
                                           "tolerance ± 2.5 mm")))
      << undetermined.toStdString();
  EXPECT_TRUE(undetermined.contains(fitOnly)) << undetermined.toStdString();
  const QString undiagnosed = frontPage(noGap(gap.evaluation, Absence::Stopped));
  EXPECT_TRUE(
      undiagnosed.contains(QStringLiteral("Δd: no diagnosis was made Accepted, fit only · "
                                          "tolerance ± 2.5 mm")))
      << undiagnosed.toStdString();
  EXPECT_TRUE(undiagnosed.contains(fitOnly)) << undiagnosed.toStdString();
}

// An effect within U of Δd, measured, is not listed, even if beyond U of Δd, fit only.
TEST(AcceptanceReport, TellsAsUnseenOnlyWhatIsBeyondUAsMeasured) {
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(paperSession())));
  ASSERT_TRUE(gap.measured());
  const double measured = gap.measured()->estimate.expanded;
  ASSERT_GT(measured, gap.diagnosis->before->expanded);
  const auto isBetween = [&](const UndetectableEffect& effect) {
    return effect.influence > gap.diagnosis->before->expanded && effect.influence <= measured;
  };
  ASSERT_TRUE(std::ranges::any_of(gap.diagnosis->undetectable, isBetween));
  EXPECT_TRUE(gap.undetectableBeyondU().empty());
  EXPECT_FALSE(Printed(paperSession()).page(0).contains(QStringLiteral("more than U")));
}

TEST(AcceptanceReport, PrintsTheBudgetOfTheMeasurementAboveThatOfTheFit) {
  const Session session = paperSession();
  const Diagnosis diagnosis = *diagnose(*examine(session).measurement);
  const Printed report(session);
  const QString text = report.text().simplified();
  for (const Statement::Row& row : measuredBudget(diagnosis, 0.95).rows) {
    if (row.isTotal) continue;  // its remark takes several lines
    QStringList cells;
    for (const std::string& cell : row.cells) cells.append(QString::fromStdString(cell));
    const QString line = cells.join(u' ').simplified();
    EXPECT_TRUE(text.contains(line)) << line.toStdString() << text.toStdString();
  }
  const auto asMeasured = text.indexOf(QStringLiteral("Standard uncertainty of Δd, measured"));
  EXPECT_GE(asMeasured, 0);
  EXPECT_GT(text.indexOf(QStringLiteral("Standard uncertainty of Δd, fit only")), asMeasured);
  EXPECT_FALSE(text.contains(QStringLiteral("arc_ellipticity"))) << "names, not ids";
}

TEST(AcceptanceReport, CountsTheGapAmongTheFindings) {
  const QString folder = QStringLiteral(ALIDADE_REFERENCE_DIR "/trials/sessions/");
  const Session session = *loadSession((folder + QStringLiteral("117223.alidade")).toStdString());
  const std::vector<Finding> findings = findingsOf(evaluate(session));
  const auto serious = std::count_if(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.severity != Severity::Note;
  });
  const QString line = serious == 0 ? QStringLiteral("1 finding: see below.")
                                    : QStringLiteral("%1 findings: see below.").arg(serious + 1);
  EXPECT_TRUE(Printed(session).page(0).contains(line)) << line.toStdString();
  const Session clean = *loadSession((folder + QStringLiteral("827247.alidade")).toStdString());
  EXPECT_FALSE(Printed(clean).contains("see below"));
}

TEST(AcceptanceReport, NamesTheReadingsThatLookMisread) {
  Session session = *loadSession(samplePath(QStringLiteral("clean-session.alidade")).toStdString());
  EXPECT_FALSE(Printed(session).contains("misread"));
  session.positions[0].readings[3].vertical = "80°43'00\"";  // instead of 53 minutes
  const Evaluation evaluation = evaluate(session);
  ASSERT_EQ(evaluation.suspects.size(), 1u);
  const Printed report(session);
  EXPECT_TRUE(report.contains("A reading looks misread: 0°, point 4, vertical"));
  const Suspect& suspect = evaluation.suspects[0];
  const QString row = QString::fromStdString(nameOf(suspect) + " " + faultOf(suspect) + " ");
  EXPECT_TRUE(report.text().contains(row + QString::fromStdString(intentionOf(suspect)).left(20)))
      << report.text().toStdString();
}

TEST(AcceptanceReport, SumsUpBothFacesWhereThereAreTwo) {
  const QString trial = QStringLiteral(ALIDADE_REFERENCE_DIR "/trials/sessions/241926.alidade");
  const Session session = *loadSession(trial.toStdString());
  const TwoFaces faces = *evaluate(session).twoFaces;
  const Printed report(session);
  const InstrumentError& c = faces.collimation;
  const int decimals = decimalsFor(c.sigma.arcseconds());
  const QString row =
      QStringLiteral("collimation c %1 (%2) × ")
          .arg(numberText(c.value.arcseconds(), decimals), numberText(c.sigma.arcseconds(), decimals));
  EXPECT_TRUE(report.text().contains(row)) << row.toStdString() << report.text().toStdString();
  EXPECT_FALSE(Printed(paperSession()).contains("From both faces"));
}

TEST(AcceptanceReport, LeavesOutWhatWasNotStated) {
  Session session = paperSession();
  session.title = " ";
  session.device = {};
  session.acceptance.referenceIntersectionMm.clear();
  const QString whole = Printed(session).page(0);
  EXPECT_TRUE(whole.contains(QStringLiteral("Not stated operator, place, date")));
  const QString front =
      whole.section(QStringLiteral("Not stated"), 0, 0) + whole.section(QStringLiteral("Arc centres"), 1);
  for (const char* label : {"Operator ", "Place", "Device", "serial", "Temperature", "Laboratory", "Customer",
                            "No. ", "Certificate", "traceable", "L measured", "Agreed by", "Reference", "—"})
    EXPECT_FALSE(front.contains(QString::fromUtf8(label))) << label << "\n" << front.toStdString();
  EXPECT_TRUE(front.contains(QStringLiteral("Operator, date")));
  EXPECT_TRUE(front.contains(QStringLiteral("Authorised by, date")));
}

TEST(AcceptanceReport, SaysOfEachSigmaWhereItIsFrom) {
  Session session = paperSession();
  const auto expectOn = [](const Session& of, std::initializer_list<const char*> lines) {
    const QString front = Printed(of).page(0).simplified();
    for (const char* line : lines)
      EXPECT_TRUE(front.contains(QString::fromUtf8(line))) << line << "\n" << front.toStdString();
  };
  expectOn(session, {"σ of the circles horizontal 2″, vertical 2″ (stated)", "σ pointing zero 2″ (stated)",
                     "2405 mm, σ 1 mm (stated)"});
  session.instrument.sigmaHorizontalArcsec.clear();
  session.instrument.sigmaZeroArcsec.clear();
  session.geometry.sigmaDistanceMm.clear();
  session.model.radius = "known";
  session.positions[0].readings[0].slider = "10 0 0";
  expectOn(session, {"horizontal 2″ (default), vertical 2″", "σ pointing zero that of the circles (default)",
                     "σ of the slider 5″ (default)", "2405 mm, taken as exact (default)",
                     "400 mm, taken as exact (default)"});
  session.instrument.sigmaVerticalArcsec.clear();
  expectOn(session, {"horizontal 2″, vertical 2″ (default)"});
}

/// Table I with all fields a laboratory states.
Session laboratorySession() {
  Session session = paperSession();
  session.report = {.number = "2026-117",
                    .laboratory = "Length Laboratory, Example Institute, 1 Quay Street, Harbour",
                    .customer = "Motion Simulators Ltd., 7 Mill Lane, Weir",
                    .authorisedBy = "R. Roe",
                    .ruleAgreedBy = "the customer, order 4711 of 2026-02-02",
                    .origin = {}};
  session.operatorName = "J. Doe";
  session.place = "Hall 3, pillar 2";
  session.measuredOn = "2026-03-13";
  session.environment.temperatureC = "20.4";
  session.device.serial = "A-7";
  session.instrument.name = "Theodolite T2";
  session.instrument.serial = "31415";
  session.instrument.certificate = "K-2026-0815 of 2026-01-20";
  session.instrument.traceability = "national angle standard, by calibration laboratory D-K-1";
  session.geometry.distanceFrom = "steel tape 12, certificate L-88";
  return session;
}

TEST(AcceptanceReport, PrintsWhatALaboratoryStates) {
  const Session session = laboratorySession();
  const Printed report(session);
  EXPECT_EQ(report.pageCount(), 5);
  for (int page = 0; page < report.pageCount(); ++page)
    EXPECT_TRUE(report.page(page).contains(QStringLiteral("Alidade %1 · Acceptance report · No. 2026-117")
                                               .arg(QString::fromStdString(versionAndBuild()))))
        << page;
  const QString front = report.page(0).simplified();
  for (const char* text :
       {"Table I No. 2026-117", "Length Laboratory,", "Motion Simulators Ltd.,",
        "Rotatable arc guideway, serial", "number A-7", "Theodolite T2, serial number 31415",
        "K-2026-0815 of 2026-01-20", "national angle standard,", "steel tape 12, certificate L-88",
        "Hall 3, pillar 2", "2026-03-13", "Agreed by: the customer, order 4711 of 2026-02-02",
        "20.4 °C; L and R0 without thermal correction", "Operator: J. Doe, date",
        "Authorised by: R. Roe, date",
        "The results relate only to the item measured. Not to be reproduced except in full."})
    EXPECT_TRUE(front.contains(QString::fromUtf8(text))) << text << "\n" << front.toStdString();
}

// Half of the probability outside U is beyond either end; the distribution of Table I is slightly skew.
TEST(AcceptanceReport, StatesTheMeasurandAndTheDecisionRuleWithItsRisk) {
  Session session = paperSession();
  const auto front = [&] { return Printed(session).page(0).simplified(); };
  const QString both = front();
  for (const char* text :
       {"half the difference of the heights of the arc centres at 0° (O1) and at 180° (O2), y up; positive "
        "if the centre is higher at 0°",
        "Accepted: |Δd| + U ≤ 2.5 mm; rejected: |Δd| − U > 2.5 mm; each measured and fit only. Otherwise, or "
        "if the gap has no known cause: undecided. Guard band w = U (coverage 95 %): a "
        "verdict is wrong with a probability of at most 2."})
    EXPECT_TRUE(both.contains(QString::fromUtf8(text))) << text << "\n" << both.toStdString();
  session = *loadSession(samplePath(QStringLiteral("clean-session.alidade")).toStdString());
  session.acceptance.toleranceMm = "2";
  for (const auto& [coverage, says] :
       {std::pair("0.95", "(coverage 95 %): a verdict is wrong with a probability of at most 2.5 % (JCGM"),
        std::pair("0.9", "(coverage 90 %): a verdict is wrong with a probability of at most 5.0 % (JCGM")}) {
    session.acceptance.coverage = coverage;
    EXPECT_TRUE(front().contains(QString::fromUtf8(says))) << front().toStdString();
  }
  session.acceptance.coverage = "0.5";
  EXPECT_FALSE(front().contains(QStringLiteral("Decision rule"))) << "there is no verdict";
  session.acceptance.coverage = "0.95";
  session.acceptance.toleranceMm.clear();
  EXPECT_FALSE(front().contains(QStringLiteral("Decision rule")));
  EXPECT_TRUE(front().contains(QStringLiteral("Measurand")));
}

TEST(AcceptanceReport, CountsExclusionsAndCorrectionsWithTheirReasonsInFront) {
  Session session = paperSession();
  const auto front = [&] { return Printed(session).page(0).simplified(); };
  EXPECT_TRUE(front().contains(QStringLiteral("Exclusions none of 34 rows of readings Corrections none")))
      << front().toStdString();
  for (const std::size_t row : {2u, 5u, 7u, 9u}) session.positions[1].readings[row].excluded = true;
  session.positions[1].readings[2].note = session.positions[1].readings[7].note = "tripod was touched";
  session.positions[1].readings[5].note = "glare";
  session.model.effects = {"trunnion_tilt", "plane_tilt"};
  session.instrument.known = {
      {.effect = "collimation", .value = "-3.2", .sigma = "0.5", .unit = "arcsec", .from = "check"}};
  const QString counted = front();
  EXPECT_TRUE(counted.contains(QStringLiteral(
      "Exclusions 4 of 34 rows of readings: 2 × “tripod was touched”, 1 × “glare”, 1 × without a note")))
      << counted.toStdString();
  EXPECT_TRUE(counted.contains(
      QStringLiteral("Corrections trunnion tilt, plane tilt, estimated along with the arcs; known "
                     "sizes in Δd, measured: collimation −3.20″")))
      << counted.toStdString();
  for (std::size_t row = 0; row < 10; ++row) {
    session.positions[0].readings[row].excluded = true;
    session.positions[0].readings[row].note = std::to_string(row);
  }
  EXPECT_TRUE(front().contains(QStringLiteral("1 × “3”, 10 × for other reasons"))) << front().toStdString();
}

TEST(AcceptanceReport, KnowsWhatALaboratoryWouldState) {
  EXPECT_EQ(emptyReportFields(laboratorySession()), QStringList());
  Session session = laboratorySession();
  session.report.customer = " ";
  session.geometry.distanceFrom.clear();
  EXPECT_EQ(emptyReportFields(session),
            (QStringList{QStringLiteral("customer"), QStringLiteral("method of the distance measurement")}));
  session = paperSession();
  EXPECT_EQ(emptyReportFields(session).size(), 15) << "all but the device's name and σ of the distance";
  session.acceptance.toleranceMm.clear();
  EXPECT_FALSE(emptyReportFields(session).contains(QStringLiteral("decision rule agreed by")));
}

TEST(AcceptanceReport, CarriesNameFingerprintAndNumberOnEveryPage) {
  Session session = paperSession();
  session.title = "Guideway 7, spring";
  const Printed report(session);
  ASSERT_EQ(report.pageCount(), 5);
  for (int page = 0; page < report.pageCount(); ++page) {
    const QString& text = report.page(page);
    EXPECT_TRUE(text.contains(QStringLiteral("Alidade"))) << page;
    EXPECT_TRUE(text.contains(QStringLiteral("Guideway 7, spring"))) << page;
    EXPECT_TRUE(text.contains(QStringLiteral("paper-table-1.alidade"))) << page;
    EXPECT_TRUE(text.contains(
        QStringLiteral("SHA-256 00112233445566778899aabbccddeeff0123456789abcdeffedcba9876543210")))
        << page;
    EXPECT_TRUE(text.contains(QStringLiteral("page %1 of 5").arg(page + 1))) << page;
    EXPECT_EQ(text.contains(QStringLiteral("End of the report")), page == 4) << page;
    EXPECT_TRUE(text.contains(QStringLiteral("2026-03-14 15:09"))) << page;
  }
}

TEST(AcceptanceReport, ListsEveryReadingWithItsResiduals) {
  const Session session = paperSession();
  const QString text = Printed(session).text();
  const Evaluation evaluation = evaluate(session);
  for (std::size_t position = 0; position < 2; ++position) {
    for (const SightingResidual& residual : evaluation.fit.arcOfPosition(position)->residuals) {
      const Reading& reading = session.positions[position].readings[residual.row];
      const QString row =
          QStringLiteral("%1 1 1 %2 %3 %4 %5 %6 %7 %8")
              .arg(QString::fromStdString(reading.point), shownAngle(reading.horizontal, CircleUnit::Dms),
                   shownAngle(reading.vertical, CircleUnit::Dms),
                   numberText(Angle::fromRadians(residual.arcAngle).degrees(), 3),
                   signedNumberText(residual.horizontal.arcseconds(), 1),
                   signedNumberText(residual.horizontalStandardised, 1),
                   signedNumberText(residual.vertical.arcseconds(), 1),
                   signedNumberText(residual.verticalStandardised, 1));
      EXPECT_TRUE(text.contains(row)) << row.toStdString();
    }
  }
}

TEST(AcceptanceReport, ListsPositionsMeasuredAgain) {
  const Session session = sessionTakenAt({0, 180, 0, 180});
  const Printed report(session);
  const SessionFit fit = evaluate(session).fit;
  const QString front = report.page(0);
  for (const char* name : {"O1 at 0° ", "O2 at 180° ", " 0° again 17 ", " 180° again 17 "})
    EXPECT_TRUE(front.contains(QString::fromUtf8(name))) << front.toStdString();
  for (const ArcFit& arc : fit.arcs)
    EXPECT_TRUE(front.contains(QStringLiteral(" 17 ") + numberText(arc.residualRms, 2)))
        << front.toStdString();
  for (const char* text : {"Positions at the same axis angle share one centre and one radius.",
                           "all pointing zeros are estimated too", "an arc measured again has not moved"})
    EXPECT_TRUE(report.text().simplified().contains(QString::fromUtf8(text))) << text;
  for (const char* text : {"Readings with the axis at 0°\n", "Readings with the axis at 180°\n",
                           "Readings with the axis at 0° again\n", "Readings with the axis at 180° again\n",
                           "arc at 0° again", "180° again vertical", "Ringed: a position measured again."})
    EXPECT_TRUE(report.text().contains(QString::fromUtf8(text))) << text;
  const QString usual = Printed(paperSession()).text().simplified();
  for (const char* text : {"0° again", "Ringed", "share one centre", "estimated along", "where it was"})
    EXPECT_FALSE(usual.contains(QString::fromUtf8(text))) << text;
}

TEST(AcceptanceReport, IsVectorsWithEmbeddedFontsOnA4) {
  const Printed report(paperSession());
  EXPECT_TRUE(report.tool(QStringLiteral("pdfinfo")).contains(QStringLiteral("(A4)")));
  EXPECT_TRUE(report.tool(QStringLiteral("pdfinfo")).contains(QStringLiteral("Acceptance report")));
  const QStringList images =
      report.tool(QStringLiteral("pdfimages"), {QStringLiteral("-list"), report.path()})
          .split(u'\n', Qt::SkipEmptyParts);
  EXPECT_EQ(images.size(), 2) << "only the two lines of the head";
  const QStringList fonts = report.tool(QStringLiteral("pdffonts")).split(u'\n', Qt::SkipEmptyParts);
  ASSERT_GT(fonts.size(), 2);
  for (const QString& font : fonts.mid(2)) {
    static const QRegularExpression embedded(
        QStringLiteral(R"(\s(yes|no)\s+(yes|no)\s+(yes|no)\s+\d+\s+\d+\s*$)"));
    EXPECT_EQ(embedded.match(font).captured(1), QStringLiteral("yes")) << font.toStdString();
  }
}

TEST(AcceptanceReport, ExplainsTheMethodWhereverThereIsRoom) {
  Session session = *loadSession(samplePath(QStringLiteral("clean-session.alidade")).toStdString());
  session.notes.clear();
  EXPECT_TRUE(Printed(session).page(0).contains(QStringLiteral("tan e = y/√(x² + L²) (exact)")));
  session = paperSession();
  EXPECT_TRUE(Printed(session).contains("orthogonal least squares"));
  session.notes = std::string(4000, 'n');
  session.model.verticalAngle = "planar";
  const Printed report(session);
  EXPECT_TRUE(report.contains("tan e = y/L (planar, as published)"));
}

TEST(AcceptanceReport, PlotsStateExaggerationAndNoise) {
  const QString plots = Printed(paperSession()).page(1);
  for (const char* text : {"residuals × 200", "enlarged × 200", "x (mm)", "y (mm)", "O1", "O2", "−400",
                           "residual (″)", "±1σ, stated σ = 2″", "σ = 2″ horizontal, 2″ vertical"}) {
    EXPECT_TRUE(plots.contains(QString::fromUtf8(text))) << text << "\n" << plots.toStdString();
  }
}

TEST(AcceptanceReport, MarksLargeResidualsAndSaysWhatTheMarkMeans) {
  Session session = paperSession();
  session.positions[0].readings[8].vertical = "80°39'30\"";  // an error of 10′
  const Printed report(session);
  static const QRegularExpression marked(QStringLiteral("\\n *9 1 1 332°27′38″ 80°39′30″ .*\\*"));
  EXPECT_TRUE(report.text().contains(marked)) << report.text().toStdString();
  EXPECT_TRUE(report.contains("* marks residuals"));
  static const QRegularExpression other(QStringLiteral("\\n *2 1 1 341°26′01″ 86°41′24″ .*\\*"));
  EXPECT_FALSE(report.text().contains(other));
}

TEST(AcceptanceReport, ShowsOtherSpellingsOfAnAngleInDegreesToo) {
  Session session = paperSession();
  session.positions[0].readings[0].horizontal = "379.859gon";
  session.positions[0].readings[1].vertical = "864124";
  const Printed report(session);
  EXPECT_TRUE(report.contains("379.859gon"));
  EXPECT_TRUE(report.contains("= 341°52′23.16″"));
  EXPECT_TRUE(report.contains("= 86°41′24″"));
}

TEST(AcceptanceReport, MarksExcludedRowsAndPrintsTheirNotes) {
  Session session = paperSession();
  session.positions[1].readings[4].excluded = true;
  session.positions[1].readings[4].note = "tripod was touched";
  const Printed report(session);
  EXPECT_TRUE(report.contains("5 1 1 338°44′15″ 97°16′03″ — — — — — excluded"));
  EXPECT_TRUE(report.contains("tripod was touched"));
}

TEST(AcceptanceReport, SaysWhenTheFileLacksChanges) {
  ReportSource source = Printed::savedSource();
  source.saved = false;
  const Session session = paperSession();
  const Printed report(session, source);
  const QByteArray digest =
      QCryptographicHash::hash(QByteArray::fromStdString(writeSession(session)), QCryptographicHash::Sha256);
  for (int page = 0; page < report.pageCount(); ++page) {
    EXPECT_TRUE(
        report.page(page).contains(QStringLiteral("unsaved changes: SHA-256 of the session's content ") +
                                   QString::fromLatin1(digest.toHex())));
    EXPECT_FALSE(report.page(page).contains(QStringLiteral("00112233")));
  }
}

TEST(AcceptanceReport, DecidesNothingWithoutATolerance) {
  Session session = paperSession();
  session.acceptance.toleranceMm.clear();
  const Printed report(session);
  EXPECT_TRUE(report.contains("No tolerance is stated"));
  for (const char* word : {"Accepted\n", "Rejected\n", "Undecided\n"})
    EXPECT_FALSE(report.contains(word)) << word;
}

TEST(AcceptanceReport, NeverLooksAcceptedWithUnusableEntries) {
  Session session = paperSession();
  session.positions[0].readings[2].vertical = "88°71'49\"";
  session.positions[1].readings[5].horizontal = "abc";
  const Printed report(session);
  EXPECT_TRUE(report.page(0).contains(QStringLiteral("No verdict: 2 entries could not be used")));
  EXPECT_FALSE(report.contains("Accepted\n"));
  EXPECT_TRUE(report.contains("0°, row 3 (point 3), vertical reading: "));
  EXPECT_TRUE(report.contains("71 minutes"));
  EXPECT_TRUE(report.contains("180°, row 6 (point 6), horizontal reading: "));
  EXPECT_TRUE(report.contains("abc 98°14′26″ — — — — — unusable"));
  session.positions[1].readings[5].excluded = true;
  EXPECT_TRUE(Printed(session).contains("No verdict: 1 entry could not be used"));
}

TEST(AcceptanceReport, SaysWhyThereIsNoResult) {
  Session session = paperSession();
  session.positions[1].readings.resize(2);
  const Printed report(session);
  EXPECT_TRUE(report.contains("No result"));
  EXPECT_TRUE(report.contains("180°"));
  EXPECT_TRUE(report.contains("a circle needs three"));
  EXPECT_FALSE(report.contains("Δd = 1"));
  EXPECT_TRUE(report.contains("401.954"));  // the existing arc
}

TEST(AcceptanceReport, PrintsAnEmptySession) {
  const Printed report(blankSession(), {.fileName = {}, .sha256 = {}, .saved = false});
  EXPECT_TRUE(report.contains("No result"));
  EXPECT_TRUE(report.contains("session not saved to a file"));
  EXPECT_TRUE(report.contains("No readings."));
}

TEST(AcceptanceReport, WrapsLongTextsInsteadOfOverprinting) {
  const QString word = QStringLiteral("Oberfinanzdirektionsvermessungsgeraeteverwaltung");
  Session session = paperSession();
  session.title = (word + u' ').repeated(6).toStdString();
  session.operatorName = word.repeated(4).toStdString();
  session.device.name = (word + u' ').repeated(3).toStdString();
  session.notes = (word + u' ').repeated(40).toStdString();
  session.positions[0].readings[3].note = (word + u' ').repeated(8).toStdString();
  const Printed report(session);
  // Every copy is readable: none is overprinted or lost, on any line.
  QString text = report.text();
  text.remove(QRegularExpression(QStringLiteral("\\s")));
  EXPECT_GE(text.count(word), 6 + 3 + 40 + 8);
  EXPECT_TRUE(report.contains("Distance L"));
}

TEST(AcceptanceReport, RepeatsTheTablesHeadOnEveryPage) {
  Session session = paperSession();
  for (Position& position : session.positions) {
    const std::vector<Reading> base = position.readings;
    for (int round = 2; round <= 12; ++round) {
      for (Reading reading : base) {
        reading.round = std::to_string(round);
        position.readings.push_back(reading);
      }
    }
  }
  const Printed report(session);
  ASSERT_GT(report.pageCount(), 8);
  static const QRegularExpression row(QStringLiteral("\\d+ 1 \\d+°"));
  for (int page = 2; page < report.pageCount(); ++page) {
    EXPECT_EQ(report.page(page).contains(QStringLiteral("Point Round Face")),
              report.page(page).contains(row));
    EXPECT_TRUE(
        report.page(page).contains(QStringLiteral("page %1 of %2").arg(page + 1).arg(report.pageCount())));
  }
  EXPECT_TRUE(report.contains("17 12 1 323°07′41″"));
}

TEST(AcceptanceReport, SaysWhereItCouldNotBeWritten) {
  const QString path = QStringLiteral("/no/such/folder/report.pdf");
  const Result<QString> written =
      writeAcceptanceReport(evaluate(paperSession()), Printed::savedSource(), path);
  ASSERT_FALSE(written);
  EXPECT_NE(written.problem().text().find(path.toStdString()), std::string::npos);
}

TEST(AcceptanceReport, LeavesAnOldReportAloneUntilTheNewOneIsWhole) {
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("report.pdf"));
  for (int i = 0; i < 2; ++i) {
    const auto written = writeAcceptanceReport(evaluate(paperSession()), Printed::savedSource(), path);
    ASSERT_TRUE(written);
    EXPECT_EQ(*written, path);
  }
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

TEST(AcceptanceReport, ListsWhatCameFromTheInstrumentWhereAnyRowHasIt) {
  EXPECT_FALSE(Printed(paperSession()).contains("return code"));
  Session session = paperSession();
  session.positions[0].readings[2].takenAt = "2026-03-14T15:09:26+01:00";
  session.positions[0].readings[2].returnCode = "1284";
  session.positions[0].zero.takenAt = "2026-03-14T15:00:00Z";
  const Printed report(session);
  for (const char* text :
       {"taken at 2026-03-14T15:09:26+01:00", "return code 1284", "taken at 2026-03-14T15:00:00Z"})
    EXPECT_TRUE(report.contains(text)) << text;
}

}  // namespace
}  // namespace alidade::ui
