#include "ui/charts/residuals/residual_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QSettings>
#include <QTest>

#include "tests/ui/support.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {
namespace {

using Over = ResidualChoice::Over;

class ResidualPageTest : public ::testing::Test {
 protected:
  ResidualPageTest() {
    page.chart()->setEvaluation(evaluate(paperSession()));
    page.resize(500, 300);
    page.show();
  }
  ~ResidualPageTest() override { QSettings().remove(QStringLiteral("charts")); }

  const ResidualChoice& choice() const { return page.chart()->plot()->choice(); }
  void choose(Over over) {
    kind->setCurrentIndex(kind->findData(static_cast<int>(over)));
    emit kind->activated(kind->currentIndex());
  }
  void type(const QString& text) {
    reach->setFocus();
    reach->selectAll();
    QTest::keyClick(reach, Qt::Key_Delete);
    QTest::keyClicks(reach, text);
    QTest::keyClick(reach, Qt::Key_Return);
  }
  double shown() const {
    const ResidualPlot& plot = *page.chart()->plot();
    return plot.sceneFromAxes().inverted().mapRect(plot.plotArea()).bottom();
  }

  ResidualPage page;
  QComboBox* kind = page.findChild<QComboBox*>();
  QLineEdit* reach = page.findChild<QLineEdit*>(QStringLiteral("residual reach"));
};

TEST_F(ResidualPageTest, ChoosesTheKindOfTheChart) {
  EXPECT_EQ(kind->count(), 6);
  for (const Over over : {Over::Count, Over::Normal, Over::Order, Over::Slider}) {
    choose(over);
    EXPECT_EQ(choice().over, over);
    EXPECT_EQ(keptResidualChoice().over, over);
  }
  page.chart()->choose({.over = Over::Azimuth});
  EXPECT_EQ(kind->currentData().toInt(), static_cast<int>(Over::Azimuth)) << "follows the chart";
}

TEST_F(ResidualPageTest, TakesARangeTypedForEachAxis) {
  const double automatic = shown();
  type(QStringLiteral("12,5"));
  EXPECT_DOUBLE_EQ(choice().reach(), 12.5);
  EXPECT_NEAR(shown(), 12.5, 1e-9);
  choose(Over::Order);
  EXPECT_NEAR(shown(), 12.5, 1e-9) << "the same axis";
  choose(Over::Normal);
  EXPECT_TRUE(reach->text().isEmpty()) << "another axis";
  type(QStringLiteral("6"));
  choose(Over::Slider);
  EXPECT_EQ(reach->text(), QStringLiteral("12.5"));
  type(QString());
  EXPECT_NEAR(shown(), automatic, 1e-9);
  choose(Over::Normal);
  EXPECT_NEAR(shown(), 6, 1e-9);
  EXPECT_DOUBLE_EQ(ResidualPage().chart()->plot()->choice().reach(), 6) << "kept for the next window";
  type(QStringLiteral("0"));
  EXPECT_EQ(choice().reach(), 0);
  EXPECT_TRUE(reach->text().isEmpty()) << "0 is automatic";
}

TEST_F(ResidualPageTest, IsReachedByTheKeyboard) {
  page.chart()->setFocus();
  QTest::keyClick(page.chart(), Qt::Key_Backtab);
  EXPECT_EQ(page.focusWidget(), reach);
  QTest::keyClick(reach, Qt::Key_Backtab);
  EXPECT_EQ(page.focusWidget(), kind);
}

}  // namespace
}  // namespace alidade::ui
