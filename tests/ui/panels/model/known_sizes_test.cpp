#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <nlohmann/json.hpp>

#include "core/base/square.h"
#include "core/effects/known_sizes.h"
#include "core/session/session_file.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/document/known_entry.h"
#include "ui/main_window.h"
#include "ui/panels/model/effects_panel.h"
#include "ui/panels/model/known_sizes_panel.h"
#include "ui/panels/model/known_sizes_table.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/panels/uncertainty/budget_panel.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Json = nlohmann::ordered_json;
using Column = KnownSizesModel::Column;

/// A window with a session and the page of known sizes in front.
struct KnownBench {
  explicit KnownBench(const Json& session) {
    QFile file(folder.filePath(QStringLiteral("known.alidade")));
    if (!file.open(QIODevice::WriteOnly)) throw std::runtime_error("file");
    file.write(QByteArray::fromStdString(session.dump(2)));
    file.close();
    if (!open->files().open(file.fileName())) throw std::runtime_error("session");
    open.waitUntilIdle();
    table = open->findChild<KnownSizesTable*>();
    show();
  }
  KnownBench() : KnownBench(clean()) {}

  static Json clean() {
    return Json::parse(
        writeSession(*loadSession(samplePath(QStringLiteral("clean-session.alidade")).toStdString())));
  }

  void show() {
    auto* panel = open->findChild<KnownSizesPanel*>();
    for (PageTabs* tabs : open->pageTabs())
      if (tabs->indexOf(panel) >= 0) tabs->showPage(tabs->indexOf(panel));
  }
  int row(const char* name) const {
    for (int row = 0; row < table->sizes().rowCount(); ++row)
      if (text(row, Column::Number) == name) return row;
    ADD_FAILURE() << name;
    return 0;
  }
  QModelIndex cell(int row, Column column) const {
    return table->sizes().index(row, static_cast<int>(column));
  }
  std::string text(int row, Column column, int role = Qt::DisplayRole) const {
    return cell(row, column).data(role).toString().toStdString();
  }
  void go(const char* name, Column column) { table->reveal(cell(row(name), column)); }
  /// Types into the current cell.
  void type(const char* text, Qt::Key key = Qt::Key_Return) {
    typeInto(*table, QString::fromUtf8(text), key);
    open.waitUntilIdle();
  }
  const Session& session() { return open->document().session(); }
  std::string about() {
    return open->findChild<KnownSizesPanel*>()->findChildren<QLabel*>().last()->text().toStdString();
  }
  std::string findings() {
    std::string all;
    const auto* list = open->findChild<FindingsPanel*>();
    for (int i = 0; i < list->count(); ++i) all += list->item(i)->text().toStdString() + '\n';
    return all;
  }

  const QTemporaryDir folder;
  OpenWindow open;
  KnownSizesTable* table = nullptr;
};

MeasuredIntersection measuredOf(const Session& session) {
  return *assessGap(std::make_shared<const Evaluation>(evaluateFit(session))).measured();
}

const UncertaintyShare& shareOf(const MeasuredIntersection& measured, const std::string& effect) {
  return *std::ranges::find(measured.budget, effect, &UncertaintyShare::effect);
}

TEST(KnownSizes, ListEveryNumberOfTheCatalogueWithItsDefault) {
  const KnownBench bench;
  int row = 0;
  for (const Effect& effect : effectCatalogue()) {
    if (!hasSizes(effect)) continue;
    for (std::size_t i = 0; i < effect.parameters.size(); ++i, ++row)
      EXPECT_EQ(bench.text(row, Column::Owner),
                effect.source == ErrorSource::Guideway ? "device" : "instrument")
          << effect.id;
  }
  EXPECT_EQ(bench.table->sizes().rowCount(), row);
  const int collimation = bench.row("Collimation");
  EXPECT_EQ(bench.text(collimation, Column::Default), "30″");
  EXPECT_EQ(bench.text(collimation, Column::Value) + bench.text(collimation, Column::Sigma), "");
  EXPECT_EQ(bench.text(collimation, Column::From), "default");
  EXPECT_EQ(bench.text(bench.row("Plane tilt, tilt about y"), Column::Default), "0.3°");
  EXPECT_EQ(bench.text(bench.row("Arc ellipticity, cosine"), Column::Default), "0.05 mm");
  EXPECT_EQ(bench.text(bench.row("Slider scale"), Column::Default), "0.0005");
}

// Types a size from a certificate: value, Enter, u, Enter, number of the certificate, Enter.
TEST(KnownSizes, AreTypedWithTheKeyboardAndUndone) {
  KnownBench bench;
  const Session before = bench.session();
  bench.go("Collimation", Column::Value);
  bench.type("3,2");
  EXPECT_EQ(bench.table->currentIndex(), bench.cell(bench.row("Collimation"), Column::Sigma));
  bench.type("0.5", Qt::Key_Tab);
  bench.type("certificate 12");
  EXPECT_EQ(bench.table->currentIndex(), bench.cell(bench.row("Trunnion tilt"), Column::Value));
  const Json written = Json::parse(writeSession(bench.session()));
  EXPECT_EQ(written["instrument"]["known"].dump(),
            R"([{"effect":"collimation","value":3.2,"sigma":0.5,"unit":"arcsec","from":"certificate 12"}])");
  EXPECT_FALSE(written.contains("device") && written["device"].contains("known"));
  const int row = bench.row("Collimation");
  EXPECT_EQ(bench.text(row, Column::Value), "3,2″") << "as typed";
  EXPECT_EQ(bench.text(row, Column::Sigma), "0.5″");
  const MeasuredIntersection measured = measuredOf(bench.session());
  EXPECT_EQ(shareOf(measured, "collimation").from, UncertaintyShare::From::Known);
  EXPECT_LT(shareOf(measured, "collimation").sigma, shareOf(measuredOf(before), "collimation").sigma);

  EXPECT_EQ(bench.open->document().undoStack().undoText(),
            QStringLiteral("Change known size of collimation"));
  bench.open->pageTabs()[1]->showPage(0);
  for (int i = 0; i < 3; ++i) bench.open->undo();
  bench.open.waitUntilIdle();
  EXPECT_EQ(bench.session(), before);
  EXPECT_EQ(writeSession(bench.session()), writeSession(before));
  EXPECT_TRUE(bench.table->isVisible()) << "undo leads to what it changed";
  EXPECT_EQ(bench.table->currentIndex().row(), row);
  for (int i = 0; i < 3; ++i) bench.open->redo();
  EXPECT_EQ(Json::parse(writeSession(bench.session())), written);
}

// With unchanged weights, the variance of Δd would lose the part of the old prior; optimal weights lose at
// least as much. The new prior has (0.001/0.05)² of that part.
TEST(KnownSizes, NarrowTheMeasurement) {
  KnownBench bench;
  const MeasuredIntersection before = measuredOf(bench.session());
  for (const char* number : {"Arc ellipticity, cosine", "Arc ellipticity, sine"}) {
    bench.go(number, Column::Sigma);
    bench.type("0.001");
    bench.type("CMM report 7");
  }
  const Json written = Json::parse(writeSession(bench.session()));
  EXPECT_EQ(
      written["device"]["known"][1].dump(),
      R"({"effect":"arc_ellipticity","parameter":"sine","sigma":0.001,"unit":"mm","from":"CMM report 7"})");
  const MeasuredIntersection after = measuredOf(bench.session());
  const double brought = shareOf(before, "arc_ellipticity").sigma;
  ASSERT_GT(square(brought), 0.3 * square(before.estimate.sigma)) << "or it would prove little";
  EXPECT_LT(square(after.estimate.sigma), square(before.estimate.sigma) - square(brought) / 2);
  EXPECT_LT(after.estimate.expanded, before.estimate.expanded);
  // Edits the file as a person would by hand.
  Json byHand = KnownBench::clean();
  byHand["device"]["known"] = written["device"]["known"];
  EXPECT_EQ(after.estimate.expanded, measuredOf(*readSession(byHand.dump())).estimate.expanded);
  // The window diagnosed the session again.
  ASSERT_TRUE(waitFor([&] { return bench.open->gapJob().isIdle(); }));
  bench.open->pageTabs()[0]->showPage(1);
  std::string budget;
  for (const QLabel* label : bench.open->findChild<BudgetPanel*>()->findChildren<QLabel*>())
    budget += label->text().toStdString() + '\n';
  const auto shown = [](double sigma) { return numberText(sigma, decimalsFor(sigma) + 1).toStdString(); };
  EXPECT_THAT(budget, HasSubstr(shown(after.estimate.sigma)));
  EXPECT_THAT(budget, Not(HasSubstr(shown(before.estimate.sigma))));
}

TEST(KnownSizes, KeepABadEntryWithItsReasonInPlace) {
  KnownBench bench;
  bench.go("Vertical index", Column::Value);
  bench.type("x", Qt::Key_Tab);
  const int row = bench.row("Vertical index");
  EXPECT_EQ(bench.session().instrument.known.at(0).value, "x");
  EXPECT_EQ(bench.text(row, Column::Value), "x");
  const std::string reason = *entryProblem(bench.session(), "instrument.known.value", "x");
  EXPECT_EQ(bench.text(row, Column::Value, KnownSizesModel::ProblemRole), reason);
  EXPECT_THAT(bench.findings(), HasSubstr("Known size of vertical index, value: " + reason));
  EXPECT_THAT(bench.findings(), HasSubstr("Known size of vertical index, u is empty: type the standard"));
  EXPECT_TRUE(bench.cell(row, Column::Sigma).data(KnownSizesModel::IncompleteRole).toBool());
  EXPECT_THAT(bench.about(), HasSubstr("Type the standard uncertainty")) << "of the cell where the table is";
  const auto* tabs = bench.open->pageTabs()[1];
  EXPECT_FALSE(tabs->tabIcon(tabs->currentIndex()).isNull());
  bench.type("-1");
  EXPECT_THAT(bench.text(row, Column::Sigma, KnownSizesModel::ProblemRole),
              HasSubstr("“-1” is out of range"));
  bench.go("Vertical index", Column::Value);
  EXPECT_EQ(bench.about(), reason);
  bench.go("Vertical index", Column::From);
  EXPECT_EQ(bench.about(), "Value: " + reason);
  bench.go("Vertical index", Column::Value);
  bench.type("1");
  bench.type("1");
  EXPECT_THAT(bench.findings(), Not(HasSubstr("Known size")));
  EXPECT_TRUE(tabs->tabIcon(tabs->currentIndex()).isNull());
}

TEST(KnownSizes, AreFoundFromTheFindings) {
  KnownBench bench;
  bench.go("Slider scale", Column::Sigma);
  bench.type("0");
  bench.open->pageTabs()[1]->showPage(0);
  bench.open->reveal({.field = "device.known[0].sigma"});
  EXPECT_TRUE(bench.table->isVisible());
  EXPECT_TRUE(bench.table->hasFocus());
  EXPECT_EQ(bench.table->currentIndex(), bench.cell(bench.row("Slider scale"), Column::Sigma));
}

TEST(KnownSizes, AreReachedFromTheEffectTheyAreOf) {
  KnownBench bench;
  bench.open->pageTabs()[0]->showPage(2);
  const auto* page = bench.open->findChild<EffectsPanel*>();
  auto* list = page->findChild<QTreeWidget*>();
  list->setCurrentItem(list->findItems(QStringLiteral("Plane warp"), Qt::MatchExactly).first());
  page->findChild<QPushButton*>()->click();
  EXPECT_TRUE(bench.table->hasFocus());
  EXPECT_EQ(bench.table->currentIndex(), bench.cell(bench.row("Plane warp, cosine"), Column::Value));
}

/// Two certificates for one parameter, the second in the other owner's list; an unknown effect, an unknown
/// unit, and an unknown key.
Json crowded() {
  Json json = KnownBench::clean();
  json["instrument"]["known"] = Json::array(
      {Json({{"effect", "collimation"}, {"value", 3}, {"sigma", 1}, {"unit", "arcsec"}, {"colour", "red"}}),
       Json({{"effect", "moonlight"}, {"sigma", 2}, {"unit", "lux"}, {"from", "a<b>\u202E"}}),
       Json({{"effect", "trunnion_tilt"}, {"sigma", "3"}, {"unit", "deg"}})});
  json["device"]["known"] = Json::array(
      {Json({{"effect", "collimation"}, {"value", "5.0"}, {"sigma", 2}, {"unit", "arcsec"}, {"from", "b"}})});
  return json;
}

TEST(KnownSizes, LeaveAloneWhatTheyCannotUseAndShowIt) {
  KnownBench bench(crowded());
  const int first = bench.row("Collimation");
  EXPECT_EQ(bench.text(first, Column::Sigma), "1″");
  EXPECT_EQ(bench.text(first + 1, Column::Number), "Collimation (again)");
  EXPECT_EQ(bench.text(first + 1, Column::Owner), "device") << "where it is, not where it belongs";
  EXPECT_EQ(bench.text(first + 1, Column::From), "b");
  const int last = bench.table->sizes().rowCount() - 1;
  EXPECT_EQ(bench.text(last - 1, Column::Number), "moonlight, lux");
  EXPECT_EQ(bench.text(last - 1, Column::From), "a<b>\\u202e") << "as text";
  EXPECT_EQ(bench.text(last, Column::Number), "trunnion_tilt, deg");
  EXPECT_THAT(bench.text(last, Column::Number, KnownSizesModel::ProblemRole),
              HasSubstr("The known size of “trunnion_tilt” in “deg” matches no entry of the catalogue."));
  EXPECT_THAT(bench.text(bench.row("Trunnion tilt"), Column::Sigma), IsEmpty());
  expectAllVisible(*bench.open.window, QStringLiteral("known sizes"));

  bench.go("Vertical index", Column::Sigma);
  bench.type("2");
  Json expected = crowded();
  expected["instrument"]["known"].push_back(
      Json({{"effect", "vertical_index"}, {"sigma", 2}, {"unit", "arcsec"}}));
  EXPECT_EQ(Json::parse(writeSession(bench.session())).dump(), expected.dump());
  bench.go("Collimation", Column::Value);
  bench.type("4");
  expected["instrument"]["known"][0]["value"] = 4;
  Session session = bench.session();
  EXPECT_EQ(session.journal.size(), 1U) << "it was in the file";
  session.journal.clear();
  EXPECT_EQ(Json::parse(writeSession(session)).dump(), expected.dump());
}

TEST(KnownSizes, AreTakenAwayWithTheirLastText) {
  KnownBench bench(crowded());
  const Session before = bench.session();
  const int first = bench.row("Collimation");
  bench.table->clearSelection();
  bench.table->setCurrentIndex(bench.cell(first, Column::Value));
  bench.table->selectionModel()->select(
      QItemSelection(bench.cell(first, Column::Value), bench.cell(first + 1, Column::From)),
      QItemSelectionModel::ClearAndSelect);
  QTest::keyClick(bench.table, Qt::Key_Delete);
  EXPECT_TRUE(bench.session().device.known.empty());
  ASSERT_EQ(bench.session().instrument.known.size(), 2u) << "the others stay";
  EXPECT_EQ(bench.session().instrument.known[0].effect, "moonlight");
  EXPECT_EQ(bench.text(first + 1, Column::Number), "Trunnion tilt");
  EXPECT_EQ(bench.open->document().undoStack().count(), 1) << "one step";
  bench.open->undo();
  EXPECT_EQ(bench.session(), before);
  EXPECT_EQ(writeSession(bench.session()), writeSession(before)) << "its unknown keys are back";
  EXPECT_EQ(bench.text(first + 1, Column::Number), "Collimation (again)");
}

TEST(KnownSizes, AnEntryThatSaysNothingCanBeTakenAway) {
  Json json = KnownBench::clean();
  json["instrument"]["known"] = Json::array({Json({{"effect", "collimation"}, {"unit", "arcsec"}})});
  KnownBench bench(json);
  EXPECT_THAT(bench.findings(), HasSubstr("Known size of collimation, u is empty"));
  bench.go("Collimation", Column::From);
  QTest::keyClick(bench.table, Qt::Key_Delete);
  EXPECT_EQ(bench.open->document().undoStack().count(), 0);
  bench.go("Collimation", Column::Sigma);
  QTest::keyClick(bench.table, Qt::Key_Delete);
  EXPECT_TRUE(bench.session().instrument.known.empty());
}

TEST(KnownSizes, TravelOverTheClipboard) {
  KnownBench bench;
  bench.go("Collimation", Column::Value);
  QApplication::clipboard()->setText(QStringLiteral("1\t0.1\tc1\n2\t0.2\tc2"));
  QTest::keyClick(bench.open.window.get(), Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(bench.session().instrument.known.size(), 2u);
  EXPECT_EQ(bench.open->document().undoStack().count(), 1);
  EXPECT_TRUE(bench.open->currentTable()) << "whose readings are as they were";
  EXPECT_EQ(bench.text(bench.row("Trunnion tilt"), Column::From), "c2");
  const int row = bench.row("Collimation");
  bench.table->selectionModel()->select(
      QItemSelection(bench.cell(row, Column::Value), bench.cell(row, Column::From)),
      QItemSelectionModel::ClearAndSelect);
  QTest::keyClick(bench.open.window.get(), Qt::Key_X, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("1\t0.1\tc1"));
  EXPECT_EQ(bench.session().instrument.known.size(), 1u);
}

TEST(KnownSizes, AreLeftByTabAtTheEnds) {
  KnownBench bench;
  const int last = bench.table->sizes().rowCount() - 1;
  bench.table->reveal(bench.cell(last, Column::From));
  QTest::keyClick(bench.table, Qt::Key_Return);
  EXPECT_EQ(bench.table->currentIndex(), bench.cell(last, Column::From));
  QTest::keyClick(bench.table, Qt::Key_Tab);
  EXPECT_FALSE(bench.table->hasFocus());
  bench.table->setFocus();
  bench.table->reveal(bench.cell(0, Column::Value));
  QTest::keyClick(bench.table, Qt::Key_Backtab);
  EXPECT_FALSE(bench.table->hasFocus());
}

TEST(KnownSizes, HalfTypedAreHandedInBeforeTheSessionIsUsed) {
  KnownBench bench;
  bench.go("Gravity sag", Column::Sigma);
  bench.table->setFocus();
  QTest::keyClick(bench.table, Qt::Key_7);
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("e-3"));
  EXPECT_TRUE(bench.session().device.known.empty());
  bench.open->commitPending();
  EXPECT_EQ(bench.session().device.known.at(0).sigma, "7e-3");
}

}  // namespace
}  // namespace alidade::ui
