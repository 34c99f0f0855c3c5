#include "ui/forms/field_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QImage>
#include <QTest>
#include <QVBoxLayout>

#include "tests/ui/support.h"
#include "ui/document/session_document.h"

namespace alidade::ui {
namespace {

/// Two entries in a window, for the focus to move between.
struct Form {
  Form() {
    auto* layout = new QVBoxLayout(&window);
    distance = new FieldEdit(document, {.field = "geometry.distance_mm"});
    zero = new FieldEdit(document, {.position = 0, .field = "pointing_zero.horizontal"},
                         FieldEdit::Shows::Angle);
    layout->addWidget(distance);
    layout->addWidget(zero);
    window.show();
    QApplication::setActiveWindow(&window);
  }

  SessionDocument document;
  QWidget window;
  FieldEdit* distance;
  FieldEdit* zero;
};

TEST(FieldEdit, HandsInOnEnterAndOnLeaving) {
  Form form;
  typeInto(*form.distance, QStringLiteral("2405"));
  EXPECT_EQ(form.document.session().geometry.distanceMm, "2405");
  typeInto(*form.distance, QStringLiteral(".5"), Qt::Key_Tab);
  EXPECT_EQ(form.document.session().geometry.distanceMm, "2405.5");
  EXPECT_EQ(form.document.undoStack().count(), 2);
}

TEST(FieldEdit, MarksWhatCannotBeUsedAndKeepsIt) {
  Form form;
  form.distance->setHint(QStringLiteral("hint"));
  const QImage sound = form.distance->grab().toImage();
  typeInto(*form.distance, QStringLiteral("24o5"));
  EXPECT_EQ(form.document.session().geometry.distanceMm, "24o5");
  EXPECT_EQ(form.distance->text(), QStringLiteral("24o5"));
  EXPECT_TRUE(form.distance->hasProblem());
  EXPECT_THAT(form.distance->toolTip().toStdString(), testing::HasSubstr("24o5"));
  EXPECT_TRUE(form.distance->actions().first()->isVisible());
  EXPECT_NE(form.distance->grab().toImage(), sound);
  form.document.undoStack().undo();
  EXPECT_FALSE(form.distance->hasProblem());
  EXPECT_EQ(form.distance->toolTip(), QStringLiteral("hint"));
}

TEST(FieldEdit, TakesBackOnEscapeWhatIsHalfTyped) {
  Form form;
  typeInto(*form.distance, QStringLiteral("2405"));
  typeInto(*form.distance, QStringLiteral("99"), Qt::Key_Escape);
  EXPECT_EQ(form.distance->text(), QStringLiteral("2405"));
  EXPECT_EQ(form.document.undoStack().count(), 1);
}

TEST(FieldEdit, ShowsAnAngleNormalisedAndEditsWhatWasTyped) {
  Form form;
  typeInto(*form.zero, QStringLiteral("3323254"), Qt::Key_Backtab);
  EXPECT_EQ(form.document.session().positions[0].zero.horizontal, "3323254");
  ASSERT_FALSE(form.zero->hasFocus());
  EXPECT_EQ(form.zero->text(), QStringLiteral("332°32′54″"));
  form.zero->setFocus();
  EXPECT_EQ(form.zero->text(), QStringLiteral("3323254"));
  form.distance->setFocus();
  EXPECT_EQ(form.document.undoStack().count(), 1);
}

TEST(FieldEdit, LeavesUndoToTheSessionUnlessSomethingIsHalfTyped) {
  Form form;
  typeInto(*form.distance, QStringLiteral("2405"));
  QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
  undo.ignore();
  QApplication::sendEvent(form.distance, &undo);
  EXPECT_FALSE(undo.isAccepted());
  QTest::keyClicks(form.distance, QStringLiteral("9"));
  QApplication::sendEvent(form.distance, &undo);
  EXPECT_TRUE(undo.isAccepted());
}

}  // namespace
}  // namespace alidade::ui
