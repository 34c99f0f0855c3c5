#include "ui/dialogs/own_effect_dialog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QtCharts/QChart>
#include <QtCharts/QXYSeries>

#include "core/session/own_effects.h"
#include "tests/ui/support.h"
#include "ui/charts/gap/own_effect_curve.h"
#include "ui/document/session_document.h"
#include "ui/main_window.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

struct EffectForm {
  explicit EffectForm(OwnEffect effect = {}) : dialog(paperSession(), std::move(effect), dialogs) {}

  void type(const char* formula) {
    dialog.findChild<QPlainTextEdit*>()->setPlainText(QString::fromUtf8(formula));
  }
  std::string says() {
    return dialog.findChild<QLabel*>(QStringLiteral("effect remark"))->text().toStdString();
  }
  bool isReady() { return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled(); }
  QLineEdit* sizeOf(const QString& name) {
    for (const QLabel* label : dialog.findChildren<QLabel*>())
      if (label->text().startsWith(name + QStringLiteral(" (")))
        return qobject_cast<QLineEdit*>(label->buddy());
    return nullptr;
  }

  ScriptedDialogs dialogs;
  OwnEffectDialog dialog;
};

OwnEffect dent() {
  return {.id = "dent",
          .name = "dent",
          .formula = "radial = A*bump(s, 60°, 9°)",
          .parameters = {{.name = "A", .plausible = "0.1"}}};
}

TEST(OwnEffectDialog, MarksAnErrorAtItsPlace) {
  EffectForm form;
  form.type("radial = A*bump(s, 60°, 9°");
  EXPECT_THAT(form.says(), HasSubstr("Line 1, column 16:"));
  EXPECT_FALSE(form.isReady());
  ASSERT_EQ(form.dialog.findChild<QPlainTextEdit*>()->extraSelections().size(), 1);
  form.type("radial = A*bump(s, 60°, 9°) + µ");
  EXPECT_EQ(form.dialog.findChild<QPlainTextEdit*>()->extraSelections()[0].cursor.selectedText(),
            QStringLiteral("µ"))
      << "counted in characters, not in bytes";
}

TEST(OwnEffectDialog, SaysHowFarASoundOneShows) {
  EffectForm form(dent());
  EXPECT_TRUE(form.isReady());
  EXPECT_THAT(form.says(), HasSubstr("Trace of A: "));
  EXPECT_THAT(form.says(), HasSubstr(" σ at the plausible size."));
  EXPECT_TRUE(form.dialog.findChild<QPlainTextEdit*>()->extraSelections().isEmpty());
  form.type("radial = A");
  EXPECT_THAT(form.says(), HasSubstr("This effect is undetectable here"))
      << "a radius is what the fit takes up";
}

TEST(OwnEffectDialog, DrawsASoundOneAndSaysWhyThereIsNoCurve) {
  EffectForm form(dent());
  const QChart* chart = form.dialog.findChild<OwnEffectCurve*>()->chart();
  ASSERT_EQ(chart->series().size(), 1);
  EXPECT_GT(qobject_cast<QXYSeries*>(chart->series()[0])->count(), 100);
  EXPECT_EQ(chart->axes(Qt::Horizontal)[0]->titleText(), QStringLiteral("s (°)"));
  EXPECT_EQ(chart->axes(Qt::Vertical)[0]->titleText(), QStringLiteral("radial (mm)"));
  form.type("radial = A*bump(s, 60°, 9°");
  EXPECT_TRUE(chart->series().isEmpty());
  EXPECT_FALSE(chart->title().isEmpty());
  form.type("horizontal = A*leg\nvertical = A*leg");
  EXPECT_EQ(chart->series().size(), 2);
  EXPECT_TRUE(chart->legend()->isVisible());
}

TEST(OwnEffectDialog, KeepsTheSizesOfAmplitudesThatStay) {
  EffectForm form(dent());
  ASSERT_TRUE(form.sizeOf(QStringLiteral("A")));
  EXPECT_EQ(form.sizeOf(QStringLiteral("A"))->text(), QStringLiteral("0.1"));
  form.type("radial = A*cos(4*s) + B*sin(4*s)");
  EXPECT_FALSE(form.isReady());
  EXPECT_EQ(form.says(), "Type a plausible size of B, 1σ.");
  ASSERT_TRUE(form.sizeOf(QStringLiteral("B")));
  form.sizeOf(QStringLiteral("B"))->setText(QStringLiteral("0.05"));
  EXPECT_TRUE(form.isReady());
  const OwnEffect typed = form.dialog.effect();
  ASSERT_EQ(typed.parameters.size(), 2U);
  EXPECT_EQ(typed.parameters[0].plausible, "0.1");
  EXPECT_EQ(typed.parameters[1].plausible, "0.05");
  EXPECT_EQ(typed.id, "dent");
}

TEST(OwnEffectDialog, PutsAFoundFormIntoTheSession) {
  OpenWindow open;
  ASSERT_FALSE(open->document().load(samplePath(QStringLiteral("dented-guideway.alidade"))));
  QPushButton* keep = nullptr;
  ASSERT_TRUE(waitFor([&] {
    for (QPushButton* button : open->findChildren<QPushButton*>())
      if (button->text() == QStringLiteral("Keep as an Effect…") && !button->isHidden()) keep = button;
    return keep != nullptr;
  }));
  keep->click();
  ASSERT_TRUE(open.dialogs->effectAsked);
  EXPECT_THAT(open.dialogs->effectAsked->formula, HasSubstr("radial = A*bump(s, "));
  EXPECT_TRUE(open->document().session().ownEffects.empty()) << "cancelled";
  open.dialogs->effectAnswer = open.dialogs->effectAsked;
  keep->click();
  ASSERT_EQ(open->document().session().ownEffects.size(), 1U);
  open.waitUntilIdle();
  EXPECT_EQ(open->document().session().ownEffects[0].formula, open.dialogs->effectAsked->formula);
  open->document().undoStack().undo();
  EXPECT_TRUE(open->document().session().ownEffects.empty());
}

}  // namespace
}  // namespace alidade::ui
