#include "ui/panels/result/result_panel.h"

#include <gmock/gmock.h>

#include <QLabel>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

Gap gapOf(const char* sample) {
  const auto session = loadSession(samplePath(QString::fromLatin1(sample)).toStdString());
  return assessGap(std::make_shared<const Evaluation>(evaluateFit(*session)));
}

/// A panel of the size it has in a small window, with what is known of the gap's evaluation.
class Bench {
 public:
  explicit Bench(const Gap& gap) {
    panel.setEvaluation(*gap.evaluation);
    panel.setGap(gap);
    panel.resize(panel.minimumWidth(), 330);
    panel.show();
    QCoreApplication::processEvents();
  }

  QLabel* label(const QString& beginning) const {
    for (QLabel* label : panel.findChildren<QLabel*>())
      if (label->text().startsWith(beginning)) return label;
    return nullptr;
  }

  ResultPanel panel;
};

QString measuredText(const Gap& gap) {
  const IntersectionEstimate& found = gap.measured()->estimate;
  return QStringLiteral("Measured: Δd = ") +
         valueWithUncertainty(found.value, found.expanded, QStringLiteral("mm"));
}

TEST(ResultPanel, StatesTheMeasurementAlsoWhereThereIsNoGap) {
  for (const char* sample : {"clean-session.alidade", "paper-table-1.alidade"}) {
    const Gap gap = gapOf(sample);
    const Bench bench(gap);
    const QLabel* measured = bench.label(QStringLiteral("Measured"));
    ASSERT_TRUE(measured && measured->isVisible()) << sample;
    EXPECT_EQ(measured->text().simplified().toStdString(), measuredText(gap).toStdString());
    EXPECT_TRUE(measured->toolTip().contains(QStringLiteral("Every effect of the catalogue"))) << sample;
    EXPECT_EQ(measured->font(), bench.label(QStringLiteral("Δd"))->font()) << "no less than the fit alone";
    EXPECT_TRUE(bench.label(QStringLiteral("Of the fit alone")));
  }
}

TEST(ResultPanel, SaysSoWhereTheReadingsDoNotDetermineTheIntersection) {
  Gap gap = gapOf("clean-session.alidade");
  gap.diagnosis->measured.reset();
  const Bench bench(gap);
  const QLabel* measured = bench.label(QStringLiteral("Measured"));
  EXPECT_EQ(measured->text(), QStringLiteral("Measured:\nthese readings do not determine Δd"));
  EXPECT_TRUE(measured->toolTip().isEmpty());
}

TEST(ResultPanel, SaysNothingOfTheMeasurementWithoutADiagnosis) {
  const Gap gap = gapOf("clean-session.alidade");
  const Bench bench(noGap(gap.evaluation, "Stopped."));
  EXPECT_FALSE(bench.label(QStringLiteral("Measured")));
  EXPECT_TRUE(bench.label(QStringLiteral("Δd"))->isVisible());
}

TEST(ResultPanel, StaysWhereItIsWhileTheDiagnosisIsOld) {
  const Gap gap = gapOf("paper-table-1.alidade");
  Bench bench(gap);
  const QLabel* measured = bench.label(QStringLiteral("Measured"));
  QLabel* arcs = bench.label(QStringLiteral("Arcs"));
  const int y = arcs->y();
  bench.panel.setGapStale();
  QCoreApplication::processEvents();
  EXPECT_FALSE(measured->isVisible()) << "it is of before";
  EXPECT_EQ(arcs->y(), y);
  bench.panel.setGap(gap);
  QCoreApplication::processEvents();
  EXPECT_TRUE(measured->isVisible());
  EXPECT_EQ(arcs->y(), y);
}

TEST(ResultPanel, IsNoWiderThanItsPage) {
  const Bench bench(gapOf("paper-table-1.alidade"));
  EXPECT_LE(bench.panel.widget()->minimumSizeHint().width(), bench.panel.viewport()->width());
  const QLabel* measured = bench.label(QStringLiteral("Measured"));
  EXPECT_LT(measured->height(), 3 * measured->fontMetrics().height()) << "on two lines";
}

}  // namespace
}  // namespace alidade::ui
