#include "ui/dialogs/report_dialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>

#include "tests/ui/shown_texts.h"
#include "ui/dialogs/dialogs.h"

namespace alidade::ui {
namespace {

ReportQuestion question() {
  return {.there = {ReportPart::Arcs, ReportPart::Readings, ReportPart::Gap}};
}

QString shownBy(const QDialog& dialog) {
  QStringList texts;
  for (const QLabel* label : dialog.findChildren<QLabel*>()) texts.append(label->text());
  return texts.join(u'\n');
}

/// True if the dialog closed by `key` leads to writing.
bool answerBy(Qt::Key key, const ReportQuestion& request) {
  QTimer::singleShot(0, [&] { QTest::keyClick(QApplication::activeModalWidget(), key); });
  return Dialogs().askReport(request).has_value();
}

TEST(ReportDialog, ListsWhatIsEmptyAndWritesTheReportByDefault) {
  ReportQuestion request = question();
  request.emptyFields = QStringList{QStringLiteral("report number"), QStringLiteral("customer")};
  const ReportDialog dialog(request);
  EXPECT_TRUE(shownBy(dialog).contains(QStringLiteral("report number, customer")));
  EXPECT_TRUE(answerBy(Qt::Key_Return, request));
  EXPECT_FALSE(answerBy(Qt::Key_Escape, request));
}

TEST(ReportDialog, OpensHighEnoughForEverySentence) {
  ReportQuestion request = question();
  for (const ReportPartInfo& info : allReportParts()) request.there.push_back(info.part);
  request.emptyFields = {
      QStringLiteral("operator, place, date, report number, laboratory, customer, authorised by, "
                     "decision rule agreed by, device serial number, temperature")};
  ReportDialog dialog(request);
  dialog.show();
  QCoreApplication::processEvents();
  for (const QLabel* label : dialog.findChildren<QLabel*>()) {
    if (!label->wordWrap()) continue;
    EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
  }
}

TEST(ReportDialog, CancelsByDefaultWhereThereWillBeNoVerdict) {
  ReportQuestion request = question();
  EXPECT_FALSE(shownBy(ReportDialog(request)).contains(QStringLiteral("cannot be used")));
  request.unusable = 2;
  EXPECT_TRUE(shownBy(ReportDialog(request)).contains(QStringLiteral("2 entries cannot be used.")));
  EXPECT_FALSE(answerBy(Qt::Key_Return, request));
}

TEST(ReportDialog, AnswersWithWhatIsChosen) {
  ReportQuestion request = question();
  request.choice.contents.leftOut = {ReportPart::Arcs, ReportPart::Journal};
  ReportDialog dialog(request);
  EXPECT_EQ(dialog.choice(), request.choice);
  const auto box = [&](const char* id) { return dialog.findChild<QCheckBox*>(QString::fromLatin1(id)); };
  EXPECT_FALSE(box("arcs")->isChecked());
  EXPECT_FALSE(box("journal")) << "there is none in this report";
  box("arcs")->click();
  box("readings")->click();
  box("session")->click();
  auto* paper = dialog.findChild<QComboBox*>(QStringLiteral("paper"));
  paper->setCurrentIndex(paper->findData(QPageSize::Letter));
  dialog.findChildren<QDoubleSpinBox*>().front()->setValue(33);
  const ReportChoice choice = dialog.choice();
  EXPECT_EQ(choice.contents.leftOut, (std::set{ReportPart::Journal, ReportPart::Readings}))
      << "what another report may have stays as it was chosen";
  EXPECT_EQ(choice.paper.size, QPageSize::Letter);
  EXPECT_EQ(choice.paper.margins, QMarginsF(33, 20, 20, 25));
  EXPECT_FALSE(choice.hasSession);
  EXPECT_EQ(choice.language, QString());
}

TEST(ReportDialog, OffersTheLanguagesUnderTheirOwnNames) {
  ReportQuestion request = question();
  request.choice.language = QStringLiteral("zh_CN");
  ReportDialog dialog(request);
  auto* language = dialog.findChild<QComboBox*>(QStringLiteral("language"));
  EXPECT_EQ(language->currentText(), QStringLiteral("简体中文"));
  EXPECT_EQ(dialog.choice(), request.choice);
  language->setCurrentText(QStringLiteral("English"));
  EXPECT_EQ(dialog.choice().language, QStringLiteral("en"));
  language->setCurrentText(QStringLiteral("Like the window"));
  EXPECT_EQ(dialog.choice().language, QString());
  const auto labels = dialog.findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [&](const QLabel* label) { return label->buddy() == language; }));
}

TEST(ReportDialog, HoldsOnToWhatMayNotBeLeftOut) {
  ReportQuestion request = question();
  request.choice.contents.leftOut = {ReportPart::Gap};
  request.mandatory = {ReportPart::Gap};
  ReportDialog dialog(request);
  const auto* gap = dialog.findChild<QCheckBox*>(QStringLiteral("gap"));
  EXPECT_TRUE(gap->isChecked());
  EXPECT_FALSE(gap->isEnabled());
  EXPECT_TRUE(gap->text().contains(QStringLiteral("model and readings disagree")));
}

TEST(ReportDialog, ShowsTheLogoOrWhyItCannotBeUsed) {
  const QTemporaryDir folder;
  ReportQuestion request = question();
  request.choice.logoPath = folder.filePath(QStringLiteral("logo\u202e<b>.png"));
  QImage(30, 20, QImage::Format_ARGB32).save(request.choice.logoPath);
  ReportDialog dialog(request);
  dialog.show();
  EXPECT_TRUE(shownBy(dialog).contains(QStringLiteral("logo\\u202e<b>.png")));
  expectAllVisible(dialog, QStringLiteral("report dialog"));
  request.choice.logoPath = folder.filePath(QStringLiteral("none.png"));
  ReportDialog without(request);
  EXPECT_TRUE(shownBy(without).contains(QStringLiteral("there is no such file")));
  without.findChild<QPushButton*>(QStringLiteral("no logo"))->click();
  EXPECT_EQ(without.choice().logoPath, QString());
}

}  // namespace
}  // namespace alidade::ui
