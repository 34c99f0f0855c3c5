#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QGraphicsTextItem>
#include <memory>

#include "core/session/session_file.h"
#include "tests/support/file_content.h"
#include "tests/ui/support.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/gap/form_plot.h"
#include "ui/charts/history/history_plot.h"
#include "ui/charts/residuals/residual_plot.h"
#include "ui/instrument/check_plot.h"

// Every chart has at least three labels at each axis, from its smallest size in a window of 1024 × 700 to its
// size on a large screen.

namespace alidade::ui {
namespace {

using Over = ResidualChoice::Over;

/// The labels written at an axis; Qt Charts hides those that would overlap.
int labelsAt(Plot& plot, Qt::Orientation orientation) {
  int labels = 0;
  for (QGraphicsItem* item : plot.scene()->items()) {
    const auto* text = dynamic_cast<QGraphicsTextItem*>(item);
    if (!text || !text->isVisible() || text->toPlainText().isEmpty()) continue;
    const QString label = text->toPlainText().replace(QChar(0x2212), u'-');
    const bool isLabel = label[0].isDigit() || label[0] == u'-';
    const QPointF middle = text->sceneBoundingRect().center();
    const bool isBelow = middle.y() > plot.plotArea().bottom() && middle.x() > plot.plotArea().left() - 20;
    if (isLabel && isBelow == (orientation == Qt::Horizontal)) ++labels;
  }
  return labels;
}

/// `least`: the smallest size of the chart.
void expectLabels(Plot& plot, const std::string& what, const QSize& least = {0, 0}) {
  plot.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
  for (const QSize size :
       {QSize(240, 130), QSize(240, 200), QSize(240, 260), QSize(340, 160), QSize(500, 113), QSize(480, 260),
        QSize(640, 300), QSize(240, 900), QSize(1920, 130), QSize(1920, 1080)}) {
    if (size.width() < least.width() || size.height() < least.height()) continue;
    plot.arrange(size);
    QCoreApplication::processEvents();
    for (const Qt::Orientation axis : {Qt::Horizontal, Qt::Vertical})
      EXPECT_GE(labelsAt(plot, axis), 3)
          << what << " in " << size.width() << " × " << size.height()
          << (axis == Qt::Horizontal ? " horizontal" : " vertical") << ", plot area "
          << plot.plotArea().width() << " × " << plot.plotArea().height();
  }
}

TEST(AxisLabels, OfResidualsAreThreeAtEverySize) {
  Session spoiled = paperSession();
  spoiled.positions[0].readings[8].vertical = "81°29'30\"";  // an error of one degree
  const Evaluation evaluations[] = {evaluate(paperSession()), evaluate(spoiled),
                                    evaluateFit(sessionInTwoFaces())};
  for (const Evaluation& evaluation : evaluations)
    for (const Over over :
         {Over::Slider, Over::Order, Over::Elevation, Over::Azimuth, Over::Normal, Over::Count})
      for (const double reach : {0.0, 7.0, 30.0}) {
        ResidualChoice choice{.over = over};
        choice.setReach(reach);
        ResidualPlot plot;
        plot.setEvaluation(evaluation);
        plot.setChoice(choice);
        expectLabels(plot, std::to_string(static_cast<int>(over)) + " ±" + std::to_string(reach));
      }
}

TEST(AxisLabels, OfArcsAreThreeAtEverySize) {
  Session high = paperSession();
  for (Position& position : high.positions)
    position.readings = {position.readings.begin() + 6, position.readings.begin() + 10};
  for (const Evaluation& evaluation : {Evaluation(), evaluate(paperSession()), evaluate(high)}) {
    ArcPlot plot;
    plot.setEvaluation(evaluation);
    expectLabels(plot, "arcs");
  }
}

TEST(AxisLabels, OfFormsAreThreeAtEverySize) {
  for (const char* sample : {"dented-guideway", "settling-tripod", "unknown-form"}) {
    const QString path = samplePath(QStringLiteral("%1.alidade").arg(QString::fromLatin1(sample)));
    const Gap gap =
        assessGap(std::make_shared<const Evaluation>(evaluateFit(*loadSession(path.toStdString()))));
    ASSERT_FALSE(gap.diagnosis->forms.empty()) << sample;
    FormPlot plot;
    plot.setForm(gap, 0);
    expectLabels(plot, sample);
  }
}

TEST(AxisLabels, OfHistoriesAreThreeAtEverySize) {
  for (const double apart : {0.0, 3.0, 10.0, 31.0, 100.0, 365.25, 1000.0, 4000.0})
    for (const int count : {1, 2, 3, 12}) {
      std::vector<DatedValue> values;
      for (int i = 0; i < count; ++i)
        values.push_back(
            {.date = "2025", .day = 9100 + apart * i, .value = 0.1 * (i % 3), .u = 0.05, .apart = 0.05});
      HistoryPlot plot;
      plot.setHistory(historyOf(values), QStringLiteral("constant"), "mm");
      expectLabels(plot, std::to_string(count) + " values, days between them " + std::to_string(apart),
                   QSize(480, 260));
    }
}

TEST(AxisLabels, OfInstrumentChecksAreThreeAtEverySize) {
  const auto bytes = std::make_shared<const std::string>(
      test::contentOf(samplePath(QStringLiteral("instrument-check.gsi")).toStdString()));
  const auto checked = std::make_shared<const CheckedInstrument>(
      checkInstrument({.sources = {{"instrument-check.gsi", bytes}}, .reading = {}, .stated = {}}));
  ASSERT_TRUE(checked->check) << checked->problem;
  for (const CheckPlot::View view :
       {CheckPlot::View::Course, CheckPlot::View::Residuals, CheckPlot::View::Distance}) {
    CheckPlot plot;
    plot.setView(view);
    plot.setCheck(checked);
    expectLabels(plot, "view " + std::to_string(static_cast<int>(view)));
  }
}

}  // namespace
}  // namespace alidade::ui
