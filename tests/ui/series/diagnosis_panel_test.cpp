#include "ui/series/diagnosis_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include "tests/support/trunnion_series.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/series/diagnosis_job.h"

namespace alidade::ui {
namespace {

SharedSeriesDiagnosis trunnionOfTwo() {
  return std::make_shared<const SeriesDiagnosis>(test::trunnionOfTwo());
}

bool says(const QWidget& panel, const QString& text) {
  for (const QLabel* label : panel.findChildren<QLabel*>())
    if (label->text().contains(text)) return true;
  return false;
}

std::string cell(const StatementTable* table, int row, int column) {
  return table->model()->index(row, column).data().toString().toStdString();
}

TEST(DiagnosisPanel, ShowsWhatIsSharedAndWhose) {
  DiagnosisPanel panel;
  panel.setDiagnosis(trunnionOfTwo());
  ASSERT_EQ(panel.causes()->model()->rowCount(), 1);
  EXPECT_EQ(cell(panel.causes(), 0, 0), "Trunnion tilt");
  EXPECT_EQ(cell(panel.causes(), 0, 1), "instrument T-1");
  EXPECT_EQ(cell(panel.causes(), 0, 2), "12.0″ (u 1.5)");
  EXPECT_EQ(cell(panel.causes(), 0, 3), "2");
  EXPECT_EQ(cell(panel.causes(), 0, 7), "plane warp");
  ASSERT_EQ(panel.sessions()->model()->rowCount(), 2);
  EXPECT_EQ(cell(panel.sessions(), 1, 0), "second");
  EXPECT_TRUE(says(panel, QStringLiteral("trunnion tilt of instrument T-1")));
  EXPECT_TRUE(says(panel, QStringLiteral("Measure guideway G-1 with another instrument")));
}

TEST(DiagnosisPanel, HandsOutTheSessionThatIsActivated) {
  DiagnosisPanel panel;
  panel.setDiagnosis(trunnionOfTwo());
  std::size_t wanted = 0;
  QObject::connect(&panel, &DiagnosisPanel::sessionWanted, [&](std::size_t file) { wanted = file; });
  emit panel.sessions()->rowActivated(1);
  EXPECT_EQ(wanted, 6u);
}

TEST(DiagnosisPanel, OffersWhatSessionsShowAsAnEffect) {
  SeriesDiagnosis series = test::trunnionOfTwo();
  OfferedEffect offer;
  offer.form = {.form = {.of = FormArgument::S, .order = 7},
                .formula = "radial = A*cos(7*s) + B*sin(7*s)",
                .coefficients = {{"A", 0.15, 0.004}, {"B", 0.1, 0.004}},
                .parameters = {{"order", 7, 0}, {"amplitude_mm", 0.18, 0.003}}};
  offer.effect = {.id = "wave", .name = "radial harmonic 7 of s", .device = "G-1"};
  offer.sessions = {0, 1};
  series.offered = {offer};
  DiagnosisPanel panel;
  panel.setDiagnosis(std::make_shared<const SeriesDiagnosis>(series));
  EXPECT_TRUE(says(panel, QStringLiteral("Sessions of guideway G-1 show the same form")));
  const auto buttons = panel.findChildren<QPushButton*>();
  ASSERT_EQ(buttons.size(), 1);
  EXPECT_TRUE(buttons.front()->text().contains(QStringLiteral("radial harmonic 7 of s")));
  OwnEffect wanted;
  QObject::connect(&panel, &DiagnosisPanel::keepWanted, [&](const OwnEffect& effect) { wanted = effect; });
  buttons.front()->click();
  EXPECT_EQ(wanted, offer.effect);
  panel.setDiagnosis(trunnionOfTwo());
  EXPECT_TRUE(panel.findChildren<QPushButton*>().isEmpty());
}

TEST(DiagnosisPanel, SaysWhyThereIsNone) {
  DiagnosisPanel panel;
  panel.setDiagnosis(trunnionOfTwo());
  panel.setDiagnosis(nullptr, QStringLiteral("because"));
  EXPECT_EQ(panel.causes()->model()->rowCount(), 0);
  EXPECT_EQ(panel.sessions()->model()->rowCount(), 0);
  EXPECT_TRUE(says(panel, QStringLiteral("because")));
}

TEST(SeriesDiagnosisJob, LeavesOutWhatCannotBeUsed) {
  const std::string series = ALIDADE_REFERENCE_DIR "/series/series-06/";
  const SeriesAnswer answer =
      diagnoseTogether({series + "01.alidade", series + "gone.alidade", series + "02.alidade"}, {});
  ASSERT_TRUE(answer.diagnosis);
  EXPECT_EQ(answer.diagnosis->sessions.size(), 2u);
  ASSERT_EQ(answer.files.size(), 2u);
  EXPECT_EQ(answer.files.back(), series + "02.alidade");
}

}  // namespace
}  // namespace alidade::ui
