#include "ui/report/report_choice.h"

#include <gtest/gtest.h>

#include <QSettings>

namespace alidade::ui {
namespace {

TEST(ReportSettings, ComeBackAsTheyWereChosen) {
  QSettings().remove(QStringLiteral("report"));
  EXPECT_EQ(rememberedReportChoice(), ReportChoice());
  ReportChoice choice{.contents = {{ReportPart::Journal, ReportPart::Budget}},
                      .paper = {QPageSize::Letter, {15, 22, 30, 40}},
                      .logoPath = QStringLiteral("/somewhere/ü logo.svg"),
                      .language = QStringLiteral("zh_CN"),
                      .hasSession = false};
  rememberReportChoice(choice);
  EXPECT_EQ(rememberedReportChoice(), choice);
  choice.contents = {};
  rememberReportChoice(choice);
  EXPECT_EQ(rememberedReportChoice(), choice);
  QSettings().remove(QStringLiteral("report"));
}

TEST(ReportSettings, TakeNothingForGranted) {
  QSettings settings;
  settings.setValue(QStringLiteral("report/leftOut"), QStringList{QStringLiteral("verdict")});
  settings.setValue(QStringLiteral("report/paper"), QStringLiteral("A0"));
  settings.setValue(QStringLiteral("report/language"), QStringLiteral("la"));
  settings.setValue(QStringLiteral("report/marginLeft"), QStringLiteral("wide"));
  settings.setValue(QStringLiteral("report/marginTop"), -5);
  settings.setValue(QStringLiteral("report/marginRight"), 4000);
  settings.sync();
  const ReportChoice choice = rememberedReportChoice();
  EXPECT_EQ(choice.contents, ReportContents());
  EXPECT_EQ(choice.language, QString());
  EXPECT_EQ(choice.paper.size, QPageSize::A4);
  EXPECT_EQ(choice.paper.margins, QMarginsF(20, ReportPaper::leastMargin, ReportPaper::mostMargin, 25));
  QSettings().remove(QStringLiteral("report"));
}

}  // namespace
}  // namespace alidade::ui
