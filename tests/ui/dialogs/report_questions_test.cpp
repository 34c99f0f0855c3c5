#include <gtest/gtest.h>

#include <QApplication>
#include <QMessageBox>
#include <QTest>
#include <QTimer>

#include "tests/ui/shown_texts.h"
#include "ui/dialogs/dialogs.h"

namespace alidade::ui {
namespace {

/// What is answered where the box is left by `key`.
bool answerBy(Qt::Key key, const QStringList& fields) {
  QString said;
  QTimer::singleShot(0, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_TRUE(box);
    expectAllVisible(*box, QStringLiteral("empty fields"));
    said = box->text();
    QTest::keyClick(box, key);
  });
  const bool answer = Dialogs().askReportWithEmptyFields(fields);
  EXPECT_TRUE(said.contains(fields.join(QStringLiteral(", ")))) << said.toStdString();
  return answer;
}

TEST(ReportQuestions, ListWhatIsEmptyAndWriteTheReportByDefault) {
  const QStringList fields{QStringLiteral("report number"), QStringLiteral("customer")};
  EXPECT_TRUE(answerBy(Qt::Key_Return, fields));
  EXPECT_FALSE(answerBy(Qt::Key_Escape, fields));
}

}  // namespace
}  // namespace alidade::ui
