// Many rows and many steps: the cost of an edit must not grow with the rows. Measured by cells touched,
// copied and kept, rather than by time.

#include <gtest/gtest.h>
#include <malloc.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStatusBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/session/session_file.h"
#include "tests/support/large_session.h"
#include "tests/ui/support.h"
#include "ui/charts/residuals/residual_plot.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"
#include "ui/models/readings_model.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/result/findings_panel.h"

namespace alidade::ui {
namespace {

constexpr std::size_t rows = 10000;

/// Fitted once for all tests.
const SharedEvaluation& largeEvaluation() {
  static const SharedEvaluation evaluation =
      std::make_shared<const Evaluation>(evaluateFit(test::largeSession(rows)));
  return evaluation;
}

/// Counts the cells that a view queries.
class CountingModel : public ReadingsModel {
 public:
  using ReadingsModel::ReadingsModel;

  mutable int requests = 0;

  QVariant data(const QModelIndex& index, int role) const override {
    if (role == Qt::DisplayRole) ++requests;
    return ReadingsModel::data(index, role);
  }
};

constexpr int residualColumn = static_cast<int>(ReadingColumn::HorizontalResidual);

TEST(Load, ANewFitAsksForTheCellsInSight) {
  SessionDocument document;
  document.startWith(largeEvaluation()->session);
  CountingModel model(document, 0);
  QTableView view;
  view.setModel(&model);
  view.resize(600, 400);
  view.show();
  QCoreApplication::processEvents();
  model.requests = 0;
  QStringList changes;
  QObject::connect(&model, &QAbstractItemModel::dataChanged,
                   [&](const QModelIndex& from, const QModelIndex& to) {
                     changes.append(QStringLiteral("%1-%2").arg(from.column()).arg(to.column()));
                   });
  model.setEvaluation(largeEvaluation());
  EXPECT_EQ(changes, QStringList{QStringLiteral("%1-%2")
                                     .arg(residualColumn)
                                     .arg(static_cast<int>(ReadingColumn::VerticalResidual))});
  EXPECT_EQ(model.requests, 0) << "until it is painted";
  QCoreApplication::processEvents();
  EXPECT_LT(model.requests, 1000);
  EXPECT_FALSE(model.index(4000, residualColumn).data().toString().isEmpty());
}

TEST(Load, AnEditTellsOfItsOwnRow) {
  SessionDocument document;
  document.startWith(largeEvaluation()->session);
  ReadingsModel model(document, 0);
  model.setEvaluation(largeEvaluation());
  const QString before = model.index(2000, residualColumn).data().toString();
  std::vector<std::pair<int, int>> changes;
  QObject::connect(
      &model, &QAbstractItemModel::dataChanged,
      [&](const QModelIndex& from, const QModelIndex& to) { changes.emplace_back(from.row(), to.row()); });
  ReadingsEditor(document, 0).setCell({2000, ReadingColumn::Vertical}, "85 00 00");
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_GE(changes[0].first, 2000);
  EXPECT_LE(changes[0].second, 2001);
  EXPECT_EQ(model.index(2000, residualColumn).data().toString(), before) << "until the fit is there";
  ReadingsEditor(document, 0).remove({10});
  EXPECT_EQ(model.index(1999, residualColumn).data().toString(), before) << "the row has moved up";
}

/// All unusable rows are marked, and the first ones listed.
TEST(Load, ListsTheFirstOfVeryManyProblems) {
  Session session = largeEvaluation()->session;
  for (Position& position : session.positions)
    for (Reading& reading : position.readings) reading.vertical = "85 99 00";
  const auto evaluation = std::make_shared<const Evaluation>(evaluateFit(session));
  ASSERT_GE(evaluation->examined.problems.size(), rows);
  FindingsPanel findings;
  findings.setEvaluation(*evaluation);
  const auto listed = static_cast<int>(FindingsPanel::mostListed);
  ASSERT_GE(findings.count(), listed + 1);
  EXPECT_LT(findings.count(), listed + 20);
  const std::size_t further = evaluation->examined.problems.size() - FindingsPanel::mostListed;
  EXPECT_TRUE(
      findings.item(listed)->text().startsWith(QString::number(further) + QStringLiteral(" further")));
  Place place;
  QObject::connect(&findings, &FindingsPanel::placeActivated, [&](const Place& where) { place = where; });
  emit findings.itemClicked(findings.item(listed));
  EXPECT_EQ(place.reading, FindingsPanel::mostListed) << "leads to the first that is not listed";
  SessionDocument document;
  document.startWith(session);
  ReadingsModel model(document, 1);
  model.setEvaluation(evaluation);
  EXPECT_FALSE(model.index(4500, static_cast<int>(ReadingColumn::Vertical))
                   .data(ReadingsModel::ProblemRole)
                   .toString()
                   .isEmpty());
}

TEST(Load, PlotsShowTheExtremesOfTenThousandRows) {
  Session session = largeEvaluation()->session;
  session.positions[1].readings[3333].vertical = session.positions[1].readings[3333 + 1].vertical;
  const Evaluation evaluation = evaluateFit(session);
  ResidualPlot plot;
  plot.setStyle(screenStyle(QApplication::palette(), QApplication::font()));
  plot.setEvaluation(evaluation);
  plot.arrange({800, 300});
  QImage image(800, 300, QImage::Format_ARGB32_Premultiplied);
  QPainter painter(&image);
  plot.scene()->render(&painter);
  painter.end();
  const auto& marks = plot.markers().marks();
  EXPECT_GE(marks.size(), 2 * rows);
  EXPECT_LT(plot.markers().paintedCount(), marks.size() / 2);
  const auto furthest = std::max_element(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
    return std::abs(a.at.y()) < std::abs(b.at.y());
  });
  double largest = 0;
  for (const DrawnResidual& residual : plot.picture().residuals)
    if (residual.circle != CircleRead::Slider) largest = std::max(largest, std::abs(residual.arcsec));
  EXPECT_NEAR(std::abs(furthest->at.y()), largest, 1e-9);
  const QPoint at = plot.markers().scenePosition(*furthest).toPoint();
  const int reach = 5;  // pixels: a marker may be hollow
  int painted = 0;
  for (int x = at.x() - reach; x <= at.x() + reach; ++x)
    for (int y = at.y() - reach; y <= at.y() + reach; ++y)
      painted += image.pixelColor(x, y) != plot.style().background ? 1 : 0;
  EXPECT_GT(painted, 0) << "painted where it is";
}

/// Bytes in use according to the allocator; absent under sanitizers.
std::size_t bytesInUse() {
  return mallinfo2().uordblks;
}

TEST(Load, UndoStepsWeighWhatTheyChange) {
  SessionDocument document;
  document.startWith(largeEvaluation()->session);
  ReadingsEditor editor(document, 0);
  editor.setCell({0, ReadingColumn::Note}, "first");
  const std::size_t before = bytesInUse();
  if (before == 0) GTEST_SKIP() << "the allocator does not count";
  constexpr std::size_t steps = 2000;
  for (std::size_t i = 0; i < steps; ++i) {
    const std::size_t row = i * 7919 % 4900;
    if (i % 2 == 0)
      editor.setCell({row, ReadingColumn::Vertical}, "85 10 " + std::to_string(i % 60));
    else
      editor.setExcluded({row, 4950}, i % 4 == 1);
  }
  const int count = document.undoStack().count();
  EXPECT_GT(count, static_cast<int>(steps / 2));
  const std::size_t after = bytesInUse();
  const std::vector<JournalEntry> journal = document.session().journal;
  const std::size_t ofJournal = bytesInUse() - after;
  EXPECT_GT(journal.size(), steps);
  EXPECT_LT((after - before - ofJournal) / static_cast<std::size_t>(count), 3 * sizeof(Reading))
      << "less than the rows around a change; the journal is the session's";
  document.undoStack().setIndex(0);
  EXPECT_EQ(document.session(), largeEvaluation()->session);
}

/// A script that edits, waits for the fit, and undoes: memory stays constant.
TEST(Load, ThousandsOfEditsLeaveMemoryFlat) {
  SessionDocument document;
  document.startWith(paperSession());
  FitJob job;
  int fits = 0;
  QObject::connect(&job, &FitJob::evaluated, [&] { ++fits; });
  QObject::connect(&document, &SessionDocument::changed, [&] { job.request(document.session()); });
  ReadingsEditor editor(document, 0);
  const auto edit = [&](int times) {
    for (int i = 0; i < times; ++i) {
      editor.setCell({static_cast<std::size_t>(i) % 17, ReadingColumn::Vertical},
                     "85 10 " + std::to_string(i % 60));
      document.undoStack().undo();
      if (i % 10 == 0) {
        ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
      }
    }
    ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
    QThreadPool::globalInstance()->waitForDone();
  };
  edit(300);
  const std::size_t before = bytesInUse();
  if (before == 0) GTEST_SKIP() << "the allocator does not count";
  edit(3000);
  EXPECT_GE(fits, 300);
  EXPECT_LT(static_cast<double>(bytesInUse()) - static_cast<double>(before), 200e3);
}

TEST(Load, AFitIsOvertakenBetweenItsStages) {
  std::stop_source stop;
  stop.request_stop();
  const Evaluation stopped = evaluateFit(paperSession(), stop.get_token());
  EXPECT_EQ(stopped.session, paperSession()) << "what further changes build on";
  EXPECT_TRUE(stopped.fit.arcs.empty());
}

TEST(Load, TheLastOfManyChangesIsFitted) {
  SessionDocument document;
  document.startWith(test::largeSession(500));
  FitJob job;
  SharedEvaluation newest;
  QObject::connect(&job, &FitJob::evaluated,
                   [&](const SharedEvaluation& evaluation) { newest = evaluation; });
  QObject::connect(&document, &SessionDocument::changed, [&] { job.request(document.session()); });
  job.request(document.session());
  ReadingsEditor upper(document, 0), lower(document, 1);
  for (std::size_t i = 0; i < 20; ++i) {
    upper.setCell({i * 5, ReadingColumn::Vertical}, "85 10 0" + std::to_string(i % 10));
    lower.remove({i, i + 3});
    if (i % 4 == 0) QCoreApplication::processEvents();
    if (i % 5 == 0) document.undoStack().undo();
  }
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  const Evaluation whole = evaluateFit(document.session());
  EXPECT_EQ(newest->session, document.session());
  ASSERT_TRUE(newest->fit.intersection);
  EXPECT_EQ(newest->fit.intersection->value, whole.fit.intersection->value);
}

TEST(Load, OpensInTheBackgroundWhileTheWindowLives) {
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("rows.alidade"));
  std::ofstream(path.toStdString()) << writeSession(largeEvaluation()->session);
  OpenWindow open;
  int ticks = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] { ++ticks; });
  timer.start(1);
  ASSERT_TRUE(open->files().open(path));
  EXPECT_GE(ticks, 2) << "events were heard while the file was read";
  EXPECT_EQ(open->document().session(), largeEvaluation()->session);
}

TEST(Load, WhatFollowsAFitStopsWhenTold) {
  OpenWindow open;
  auto* stop = open->findChild<QToolButton*>(QStringLiteral("stop jobs"));
  ASSERT_TRUE(stop);
  bool wasSearching = false, isSearched = false, isAssessed = false;
  QObject context;
  QObject::connect(&open->job(), &FitJob::searched, &context, [&] { isSearched = true; });
  QObject::connect(&open->gapJob(), &GapJob::assessed, &context, [&] { isAssessed = true; });
  QObject::connect(&open->job(), &FitJob::evaluated, &context, [&] {
    wasSearching = open->job().isSearching() && !open->gapJob().isIdle();
    emit stop->clicked();
  });
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  EXPECT_TRUE(wasSearching);
  EXPECT_TRUE(open->gapJob().isIdle());
  EXPECT_TRUE(open->statusBar()->currentMessage().endsWith(QStringLiteral("was stopped.")));
  QTest::qWait(GapJob::restMilliseconds + 100);
  EXPECT_FALSE(isSearched || isAssessed);
  QObject::disconnect(&open->job(), nullptr, &context, nullptr);
  ReadingsEditor(open->document(), 0).setCell({0, ReadingColumn::Note}, "again");
  EXPECT_TRUE(waitFor([&] { return open->job().isIdle() && open->gapJob().isIdle(); }));
}

}  // namespace
}  // namespace alidade::ui
