#include <gtest/gtest.h>

#include <QComboBox>
#include <QTest>
#include <algorithm>
#include <utility>

#include "core/adjustment/result/closures.h"
#include "core/adjustment/result/session_fit.h"
#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/forms/field_edit.h"
#include "ui/main_window.h"

namespace alidade::ui {
namespace {

/// The window with the paper's table and the entries for the use of the radius.
struct RadiusBench {
  RadiusBench() {
    if (!open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))))
      throw std::runtime_error("sample");
    open.waitUntilIdle();
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
  bench.model->setFocus();
  QTest::keyClick(bench.model, Qt::Key_Down);
  EXPECT_EQ(bench.session().model.radius, "common");
  QTest::keyClick(bench.model, Qt::Key_Down);
  EXPECT_EQ(bench.session().model.radius, "known");
  typeInto(*bench.sigma, QStringLiteral("0.05"));
  EXPECT_EQ(bench.session().geometry.sigmaRadiusMm, "0.05");
  const Examined examined = examine(bench.session());
  ASSERT_TRUE(examined.measurement);
  EXPECT_EQ(examined.measurement->radiusModel, RadiusModel::Known);
  EXPECT_EQ(examined.measurement->sigmaRadius, 0.05);
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

TEST(RadiusFields, TakeTheSigmaOfR0HoweverTheRadiusIsTaken) {
  for (const char* radius : {"free", "common", "known"}) {
    RadiusBench bench;
    bench.choose(radius);
    ASSERT_TRUE(bench.sigma->isEnabled()) << radius;
    typeInto(*bench.sigma, QStringLiteral("0.05"));
    EXPECT_EQ(readSession(writeSession(bench.session()))->geometry.sigmaRadiusMm, "0.05") << radius;
    const auto measurement = examine(bench.session()).measurement;
    const auto closures = closuresOf(*measurement, fitSession(*measurement).joint);
    const bool isHeldAgainst =
        std::ranges::any_of(closures, [](const Closure& c) { return c.of == Closure::Of::NominalRadius; });
    EXPECT_EQ(isHeldAgainst, std::string(radius) != "known") << radius;
  }
}

TEST(RadiusFields, SayWhatNoSigmaMeans) {
  RadiusBench bench;
  EXPECT_EQ(bench.sigma->placeholderText(), QStringLiteral("none"));
  bench.choose("known");
  EXPECT_EQ(bench.sigma->placeholderText(), QStringLiteral("0 (exact)"));
  bench.choose("common");
  EXPECT_EQ(bench.sigma->placeholderText(), QStringLiteral("none"));
}

TEST(RadiusFields, LeaveASigmaThatCannotBeUsedWithinReach) {
  RadiusBench bench;
  changeField(bench.open->document(), {.field = "geometry.sigma_radius_mm"}, "thin");
  EXPECT_TRUE(bench.sigma->isEnabled()) << "without it there is no fit, so it can be mended";
  EXPECT_TRUE(bench.sigma->hasProblem());
  changeField(bench.open->document(), {.field = "geometry.sigma_radius_mm"}, "0.1");
  EXPECT_FALSE(bench.sigma->hasProblem());
}

TEST(RadiusFields, StandBesideWhatTheirSigmaIsOf) {
  RadiusBench bench;
  const std::pair<const char*, const char*> pairs[] = {
      {"geometry.distance_mm", "geometry.sigma_distance_mm"},
      {"geometry.radius_mm", "geometry.sigma_radius_mm"},
      {"acceptance.reference_intersection_mm", "acceptance.sigma_reference_mm"}};
  for (const auto& [value, sigma] : pairs) {
    auto* left = bench.open->findChild<FieldEdit*>(QString::fromLatin1(value));
    auto* right = bench.open->findChild<FieldEdit*>(QString::fromLatin1(sigma));
    ASSERT_TRUE(left && right) << value;
    EXPECT_EQ(left->y(), right->y()) << value;
    EXPECT_LT(left->x(), right->x()) << value;
    left->setFocus();
    QTest::keyClick(left, Qt::Key_Tab);
    EXPECT_TRUE(right->hasFocus()) << value;
  }
}

}  // namespace
}  // namespace alidade::ui
