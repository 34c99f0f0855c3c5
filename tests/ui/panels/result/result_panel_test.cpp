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

/// A panel in the size of a small window, with a diagnosed evaluation.
class Bench {
 public:
  explicit Bench(const Gap& gap) {
    panel.setEvaluation(*gap.evaluation);
    assess(gap);
    panel.resize(panel.minimumWidth(), 330);
    panel.show();
    QCoreApplication::processEvents();
  }

  void assess(const Gap& gap) {
    panel.setHeadline(headlineOf(gap));
    panel.setGap(gap);
  }

  QLabel* label(const QString& beginning) const {
    for (QLabel* label : panel.findChildren<QLabel*>())
      if (label->text().startsWith(beginning)) return label;
    return nullptr;
  }

  /// The visible texts, from the top, with letters of at least this size relative to the panel's.
  QStringList textsFrom(double factor) const {
    std::map<int, QString> texts;
    for (QLabel* label : panel.findChildren<QLabel*>())
      if (label->isVisible() && !label->text().isEmpty() &&
          label->font().pointSizeF() >= factor * panel.font().pointSizeF() - 0.01)
        texts[label->mapTo(panel.widget(), QPoint()).y()] = label->text().simplified();
    QStringList list;
    for (const auto& [y, text] : texts) list.append(text);
    return list;
  }

  ResultPanel panel;
};

QString measuredText(const Gap& gap) {
  const IntersectionEstimate& found = gap.measured()->estimate;
  return valueWithUncertainty(found.value, found.expanded, QStringLiteral("mm"));
}

TEST(ResultPanel, HasTheMeasuredResultAloneInLargeType) {
  for (const char* sample : {"clean-session.alidade", "paper-table-1.alidade"}) {
    const Gap gap = gapOf(sample);
    const Bench bench(gap);
    const Headline headline = headlineOf(gap);
    EXPECT_EQ(bench.textsFrom(1.5), QStringList{measuredText(gap)}) << sample;
    EXPECT_EQ(bench.textsFrom(1.25),
              QStringList({measuredText(gap), headline.tolerance, headline.verdict.word}));
    const QLabel* name = bench.label(QStringLiteral("Δd, measured"));
    const QLabel* fitOnly = bench.label(headline.reference.isEmpty() ? QStringLiteral("Δd, fit only: ")
                                                                     : QStringLiteral("Reference "));
    ASSERT_TRUE(name && fitOnly);
    EXPECT_EQ(name->y(), 0) << "it comes first";
    EXPECT_TRUE(fitOnly->text().contains(QStringLiteral("Δd, fit only: "))) << fitOnly->text().toStdString();
    EXPECT_GT(fitOnly->y(), bench.label(headline.verdict.word)->y());
  }
}

TEST(ResultPanel, SaysInLargeTypeWhereThereIsNoMeasuredResult) {
  Gap gap = gapOf("clean-session.alidade");
  gap.diagnosis->measured.reset();
  EXPECT_EQ(Bench(gap).textsFrom(1.5), QStringList{QStringLiteral("not determined by these readings")});
  EXPECT_EQ(Bench(noGap(gap.evaluation, "Stopped.")).textsFrom(1.5),
            QStringList{QStringLiteral("no diagnosis was made")});
}

TEST(ResultPanel, ShowsAProvisionalFigureGreyAndWithoutAVerdict) {
  const Gap gap = gapOf("paper-table-1.alidade");
  Bench bench(gap);
  const auto colourOf = [&](const QString& beginning) {
    return bench.label(beginning)->palette().color(QPalette::WindowText);
  };
  const QColor good = stateColor(bench.panel.palette(), State::Good);
  const QColor quiet = stateColor(bench.panel.palette(), State::Quiet);
  EXPECT_EQ(colourOf(QStringLiteral("Accepted")), good);
  EXPECT_NE(colourOf(QStringLiteral("1.07")), quiet);
  bench.panel.setHeadline(headlineOf(*gap.evaluation));
  EXPECT_EQ(colourOf(QStringLiteral("1.31")), quiet);
  EXPECT_EQ(colourOf(QStringLiteral("Provisional: the diagnosis is running.")), quiet);
  EXPECT_FALSE(bench.label(QStringLiteral("Accepted")));
}

TEST(ResultPanel, StaysWhereItIsWhileTheDiagnosisIsRunning) {
  const Gap gap = gapOf("paper-table-1.alidade");
  Bench bench(gap);
  QLabel* arcs = bench.label(QStringLiteral("Arcs"));
  const int y = arcs->y();
  bench.panel.setGapStale();
  bench.panel.setHeadline(headlineOf(*gap.evaluation));
  QCoreApplication::processEvents();
  EXPECT_EQ(arcs->y(), y);
  bench.assess(gap);
  QCoreApplication::processEvents();
  EXPECT_EQ(arcs->y(), y);
}

TEST(ResultPanel, IsNoWiderThanItsPage) {
  const Bench bench(gapOf("paper-table-1.alidade"));
  EXPECT_LE(bench.panel.widget()->minimumSizeHint().width(), bench.panel.viewport()->width());
}

}  // namespace
}  // namespace alidade::ui
