#include <gtest/gtest.h>

#include <QComboBox>
#include <QTest>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_field.h"
#include "ui/forms/field_edit.h"
#include "ui/main_window.h"

namespace alidade::ui {
namespace {

/// The window on the paper's table, with the entries that say how the radius is taken.
struct RadiusBench {
  RadiusBench() {
    if (!open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))))
      throw std::runtime_error("sample");
    open.settle();
    model = open->findChild<QComboBox*>(QStringLiteral("model.radius"));
    sigma = open->findChild<FieldEdit*>(QStringLiteral("geometry.sigma_radius_mm"));
  }

  const Session& session() { return open->document().session(); }
  void choose(const char* text) {
    model->setCurrentIndex(model->findData(QString::fromLatin1(text)));
    emit model->activated(model->currentIndex());
  }

  OpenWindow open;
  QComboBox* model;
  FieldEdit* sigma;
};

TEST(RadiusFields, ChooseHowTheRadiusIsTakenWithTheKeyboard) {
  RadiusBench bench;
  EXPECT_EQ(bench.model->currentData().toString(), QStringLiteral("free")) << "what an absent model means";
  EXPECT_FALSE(bench.sigma->isEnabled());
  bench.model->setFocus();
  QTest::keyClick(bench.model, Qt::Key_Down);
  EXPECT_EQ(bench.session().model.radius, "common");
  EXPECT_FALSE(bench.sigma->isEnabled());
  QTest::keyClick(bench.model, Qt::Key_Down);
  EXPECT_EQ(bench.session().model.radius, "known");
  ASSERT_TRUE(bench.sigma->isEnabled());
  typeInto(*bench.sigma, QStringLiteral("0.05"));
  EXPECT_EQ(bench.session().geometry.sigmaRadiusMm, "0.05");
  const Examined meant = examine(bench.session());
  ASSERT_TRUE(meant.measurement);
  EXPECT_EQ(meant.measurement->radiusModel, RadiusModel::Known);
  EXPECT_EQ(meant.measurement->sigmaRadius, 0.05);
}

TEST(RadiusFields, AreUndoneAndSaved) {
  RadiusBench bench;
  bench.choose("known");
  changeField(bench.open->document(), {.field = "geometry.sigma_radius_mm"}, "0.1");
  const Session read = *readSession(writeSession(bench.session()));
  EXPECT_EQ(read.model.radius, "known");
  EXPECT_EQ(read.geometry.sigmaRadiusMm, "0.1");
  bench.open->undo();
  EXPECT_EQ(bench.sigma->text(), QString());
  bench.open->undo();
  EXPECT_EQ(bench.model->currentData().toString(), QStringLiteral("free"));
  EXPECT_EQ(bench.session(), paperSession());
  bench.open->redo();
  EXPECT_EQ(bench.model->currentData().toString(), QStringLiteral("known"));
}

TEST(RadiusFields, KeepTheSigmaWhereItIsOfNoUse) {
  RadiusBench bench;
  bench.choose("known");
  changeField(bench.open->document(), {.field = "geometry.sigma_radius_mm"}, "0.1");
  bench.choose("free");
  EXPECT_FALSE(bench.sigma->isEnabled());
  EXPECT_EQ(bench.sigma->text(), QStringLiteral("0.1"));
  EXPECT_EQ(readSession(writeSession(bench.session()))->geometry.sigmaRadiusMm, "0.1");
  bench.choose("known");
  EXPECT_TRUE(bench.sigma->isEnabled());
  EXPECT_EQ(bench.session().geometry.sigmaRadiusMm, "0.1");
}

TEST(RadiusFields, LeaveASigmaThatCannotBeUsedWithinReach) {
  RadiusBench bench;
  changeField(bench.open->document(), {.field = "geometry.sigma_radius_mm"}, "thin");
  EXPECT_TRUE(bench.sigma->isEnabled()) << "without it there is no fit, so it can be mended";
  EXPECT_TRUE(bench.sigma->hasProblem());
  changeField(bench.open->document(), {.field = "geometry.sigma_radius_mm"}, "0.1");
  EXPECT_FALSE(bench.sigma->isEnabled());
}

}  // namespace
}  // namespace alidade::ui
