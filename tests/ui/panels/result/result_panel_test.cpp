#include "ui/panels/result/result_panel.h"

#include <gmock/gmock.h>

#include <QLabel>
#include <QToolButton>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/text/entry_text.h"

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

  void assess(const Gap& gap) { panel.setHeadline(headlineOf(gap)); }

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

TEST(ResultPanel, HasTheMeasuredResultAloneInLargeType) {
  for (const char* sample : {"clean-session.alidade", "paper-table-1.alidade"}) {
    const Gap gap = gapOf(sample);
    const Bench bench(gap);
    const Headline headline = headlineOf(gap);
    EXPECT_EQ(bench.textsFrom(1.5), QStringList{qText(headline.nameAndFigure())}) << sample;
    EXPECT_EQ(bench.textsFrom(1.25), QStringList({qText(headline.nameAndFigure()), qText(headline.verdict)}));
    const QLabel* tolerance = bench.label(qText(headline.tolerance));
    ASSERT_TRUE(tolerance);
    EXPECT_GT(tolerance->y(), bench.label(qText(headline.verdict))->y());
    EXPECT_EQ(bench.label(QStringLiteral("Δd = "))->y(), 0) << "it comes first";
  }
}

TEST(ResultPanel, KeepsTheReasonOfAReachedVerdictAndTheFitOnlyInAFold) {
  const Bench bench(gapOf("paper-table-1.alidade"));
  const auto isShown = [&](const char* text) {
    for (const QLabel* label : bench.panel.findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QString::fromUtf8(text))) return true;
    return false;
  };
  EXPECT_FALSE(isShown("Δd, fit only: "));
  EXPECT_TRUE(isShown("the radii differ by ")) << "read before the verdict is used";
  bench.panel.findChild<QToolButton*>()->click();
  EXPECT_TRUE(isShown("Δd, fit only: "));
  EXPECT_TRUE(isShown("Probability of conformity"));
}

TEST(ResultPanel, ShowsTheReasonOfAnOpenVerdict) {
  const Bench bench(gapOf("two-causes.alidade"));
  const QLabel* reason = bench.label(QStringLiteral("Δd = 0.4"));
  ASSERT_TRUE(reason);
  EXPECT_TRUE(reason->isVisible());
}

TEST(ResultPanel, SaysInLargeTypeWhereThereIsNoMeasuredResult) {
  Gap gap = gapOf("clean-session.alidade");
  gap.diagnosis->measured.reset();
  EXPECT_EQ(Bench(gap).textsFrom(1.5), QStringList{QStringLiteral("Δd: not determined by these readings")});
  EXPECT_EQ(Bench(noGap(gap.evaluation, Absence::Stopped)).textsFrom(1.5),
            QStringList{QStringLiteral("Δd: no diagnosis was made")});
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
  EXPECT_NE(colourOf(QStringLiteral("Δd = 1.24")), quiet);
  bench.panel.setHeadline(headlineOf(*gap.evaluation));
  EXPECT_EQ(colourOf(QStringLiteral("Δd, fit only = 1.31")), quiet);
  EXPECT_EQ(colourOf(QStringLiteral("Provisional: the diagnosis is running.")), quiet);
  EXPECT_FALSE(bench.label(QStringLiteral("Accepted")));
}

TEST(ResultPanel, StaysWhereItIsWhileTheDiagnosisIsRunning) {
  const Gap gap = gapOf("paper-table-1.alidade");
  Bench bench(gap);
  QLabel* arcs = bench.label(QStringLiteral("Arc centres"));
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
