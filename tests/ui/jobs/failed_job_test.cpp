#include "ui/jobs/failed_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <optional>
#include <stdexcept>

#include "core/session/session_file.h"
#include "core/statement/gap.h"
#include "tests/ui/failing_memory.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/jobs/simulation_job.h"
#include "ui/jobs/trial_job.h"
#include "ui/main_window.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/panels/result/result_panel.h"
#include "ui/panels/uncertainty/simulation_box.h"

// Failed work affects only its own result: a message replaces that result.

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

QStringList records() {
  return QDir(problemsFolder()).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name);
}

QJsonObject newestRecord() {
  QFile file(QDir(problemsFolder()).filePath(records().value(records().size() - 1)));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  return QJsonDocument::fromJson(file.readAll()).object();
}

class FailedJobTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!FailingMemory::isPossible()) GTEST_SKIP() << "memory is under the sanitizer's guard";
  }
};

std::string textsOf(const QWidget& widget) {
  QStringList texts;
  for (const QLabel* label : widget.findChildren<QLabel*>())
    if (label->isVisibleTo(&widget)) texts.append(label->text());
  return texts.join(u'\n').toStdString();
}

std::string findingsOf(const OpenWindow& open) {
  const auto* list = open.window->findChild<FindingsPanel*>();
  QStringList texts;
  for (int row = 0; row < list->count(); ++row) texts.append(list->item(row)->text());
  return texts.join(u'\n').toStdString();
}

TEST(FailedJob, IsToldWithItsReasonAndItsRecord) {
  Session session = paperSession();
  session.title = "Tisch “7” 1.250";
  const QString reported = QString::fromStdString(reportFailure({"fit", "a reason of its own", session, 7}));
  EXPECT_THAT(reported.toStdString(), HasSubstr("The fit failed: a reason of its own."));
  const QString path = QDir(problemsFolder()).filePath(records().last());
  EXPECT_TRUE(reported.contains(path)) << reported.toStdString();
  const QJsonObject record = newestRecord();
  EXPECT_EQ(record[QStringLiteral("job")].toString(), QStringLiteral("fit"));
  EXPECT_EQ(record[QStringLiteral("reason")].toString(), QStringLiteral("a reason of its own"));
  EXPECT_EQ(record[QStringLiteral("seed")].toString(), QStringLiteral("7"));
  EXPECT_TRUE(record[QStringLiteral("program")].toString().startsWith(QStringLiteral("Alidade ")));
  EXPECT_TRUE(QDateTime::fromString(record[QStringLiteral("time")].toString(), Qt::ISODateWithMs).isValid());
  const QByteArray inside = QJsonDocument(record[QStringLiteral("session")].toObject()).toJson();
  const Result<Session> back = readSession(inside.toStdString());
  ASSERT_TRUE(back) << back.problem().text();
  EXPECT_EQ(back->positions, session.positions);
  EXPECT_EQ(back->title, session.title);
}

TEST(FailedJob, IsRecordedOnceAndNotWithEveryEdit) {
  reportFailure({"fit", "once", paperSession()});
  const QStringList before = records();
  for (int i = 0; i < 20; ++i) reportFailure({"fit", "once", paperSession()});
  EXPECT_EQ(records(), before);
  for (int i = 0; i < 60; ++i) reportFailure({"fit", std::to_string(i), paperSession()});
  EXPECT_EQ(records().size(), 50);
}

TEST(FailedJob, IsToldWhereNoRecordCanBeWritten) {
  QDir(problemsFolder()).removeRecursively();
  ASSERT_TRUE(QDir().mkpath(QFileInfo(problemsFolder()).path()));
  QFile inTheWay(problemsFolder());
  ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
  const std::string reported = reportFailure({"fit", "unrecorded", paperSession()});
  inTheWay.remove();
  EXPECT_THAT(reported, HasSubstr("The fit failed: unrecorded."));
  EXPECT_THAT(reported, HasSubstr("could not be written to " + problemsFolder().toStdString()));
}

TEST_F(FailedJobTest, OfTheFitStandsInTheResultAndTheNextEditIsFitted) {
  OpenWindow open;
  open->files().open(samplePath(QStringLiteral("paper-table-1.alidade")));
  open.waitUntilIdle();
  const auto* result = open->findChild<ResultPanel*>();
  const Place distance{.field = "geometry.distance_mm"};
  {
    const FailingMemory scarce;
    changeField(open->document(), distance, "2406");
    open.waitUntilIdle();
  }
  EXPECT_THAT(textsOf(*result), HasSubstr("The fit failed: out of memory."));
  EXPECT_THAT(textsOf(*result), HasSubstr("Δd: —"));
  EXPECT_THAT(findingsOf(open), HasSubstr("The fit failed: out of memory."));
  EXPECT_EQ(open->document().session().geometry.distanceMm, "2406");
  EXPECT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }))
      << "there is nothing to diagnose, which is said";
  changeField(open->document(), distance, "2405");
  open.waitUntilIdle();
  EXPECT_THAT(textsOf(*result), HasSubstr("Δd, fit only = 1.31 ± 0.21 mm"));
  EXPECT_THAT(findingsOf(open), Not(HasSubstr("failed")));
}

TEST_F(FailedJobTest, OfTheSearchLeavesTheFitAndSaysSo) {
  FitJob job;
  std::optional<FailingMemory> scarce;
  SharedEvaluation searched;
  QObject::connect(&job, &FitJob::evaluated, [&] { scarce.emplace(); });
  QObject::connect(&job, &FitJob::searched,
                   [&](const SharedEvaluation& evaluation) { searched = evaluation; });
  job.request(paperSession());
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  ASSERT_TRUE(searched);
  EXPECT_TRUE(searched->isSearched);
  EXPECT_TRUE(searched->fit.intersection);
  ASSERT_TRUE(searched->searchFailure);
  EXPECT_THAT(sentencesOf(*searched->searchFailure),
              HasSubstr("The search for misread readings failed: out of memory."));
}

// Each job runs once first, so that its thread already exists.

TEST_F(FailedJobTest, OfTheDiagnosisIsTheReasonForNone) {
  GapJob job;
  std::vector<SharedGap> gaps;
  QObject::connect(&job, &GapJob::assessed, [&](const SharedGap& gap) { gaps.push_back(gap); });
  job.setWatched(true);
  const auto evaluation = std::make_shared<const Evaluation>(evaluateFit(paperSession()));
  for (const bool isScarce : {false, true, false}) {
    std::optional<FailingMemory> scarce;
    if (isScarce) scarce.emplace();
    job.request(evaluation);
    ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  }
  ASSERT_EQ(gaps.size(), 3u);
  EXPECT_TRUE(gaps[0]->diagnosis);
  EXPECT_FALSE(gaps[1]->diagnosis);
  EXPECT_THAT(reasonForNone(*gaps[1]), HasSubstr("The diagnosis failed: out of memory."));
  EXPECT_TRUE(gaps[2]->diagnosis);
}

TEST_F(FailedJobTest, OfTheSimulationIsToldInItsBox) {
  SessionDocument document;
  ASSERT_FALSE(document.load(samplePath(QStringLiteral("paper-table-1.alidade"))));
  SimulationBox box(document);
  box.findChild<QSpinBox*>()->setValue(1000);
  box.setEvaluation(std::make_shared<const Evaluation>(evaluateFit(document.session())));
  for (const bool isScarce : {false, true, false}) {
    std::optional<FailingMemory> scarce;
    if (isScarce) scarce.emplace();
    box.findChild<QPushButton*>()->click();
    ASSERT_TRUE(waitFor([&] { return !box.isWanted(); }));
    EXPECT_EQ(textsOf(box).find("The simulation failed: out of memory.") != std::string::npos, isScarce);
  }
}

TEST_F(FailedJobTest, OfATrialIsItsProblem) {
  TrialJob job;
  std::vector<std::string> problems;
  QObject::connect(&job, &TrialJob::diagnosed,
                   [&](const SharedTrial& diagnosed) { problems.push_back(diagnosed->problem); });
  for (const bool isScarce : {false, true, false}) {
    std::optional<FailingMemory> scarce;
    if (isScarce) scarce.emplace();
    job.start({.protocol = "paper"}, 5, 1);
    ASSERT_TRUE(waitFor([&] { return !job.isAtWork(); }));
  }
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0], "");
  EXPECT_THAT(problems[1], HasSubstr("The blind trial failed: out of memory."));
  EXPECT_EQ(problems[2], "");
}

class ThrowingDialogs : public ScriptedDialogs {
 public:
  explicit ThrowingDialogs(QStringList& reported) : m_reported(reported) {}
  QString askReportPath(const QString&) override { throw std::runtime_error("no paper"); }
  void showProblem(const QString&, const QString& text) override { m_reported.append(text); }

 private:
  QStringList& m_reported;
};

TEST(FailedJob, OfTheReportIsToldInADialog) {
  QStringList reported;
  MainWindow window(std::make_unique<ThrowingDialogs>(reported));
  EXPECT_FALSE(window.files().open(QStringLiteral("none.alidade")));
  reported.clear();
  window.files().startWith(paperSession());
  EXPECT_FALSE(window.files().exportReport());
  ASSERT_EQ(reported.size(), 1);
  EXPECT_THAT(reported.front().toStdString(),
              HasSubstr("The acceptance report failed: a fault in the program (no paper)."));
}

}  // namespace
}  // namespace alidade::ui
