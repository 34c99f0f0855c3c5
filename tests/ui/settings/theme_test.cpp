#include "ui/settings/theme.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QLineEdit>
#include <QPixmapCache>
#include <QToolBar>

#include "tests/ui/support.h"
#include "ui/main_window.h"

namespace alidade::ui {
namespace {

TEST(Theme, DrawsNoLightLineAboveTheToolBar) {
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    applyTheme(theme);
    OpenWindow open;
    const QImage bar = open->findChild<QToolBar*>()->grab().toImage();
    const QColor window = open->palette().color(QPalette::Window);
    for (int x = 0; x < bar.width(); ++x) ASSERT_EQ(bar.pixelColor(x, 0), window) << x;
  }
  applyTheme(Theme::Light);
}

TEST(Theme, ChangedAtRunTimeDimsIconsAsAfterARestart) {
  const auto dimmed = [] {
    return themeIcon(QStringLiteral("undo")).pixmap(QSize(20, 20), 1, QIcon::Disabled).toImage();
  };
  applyTheme(Theme::Light);
  const QImage light = dimmed();
  applyTheme(Theme::Dark);
  const QImage changed = dimmed();
  QPixmapCache::clear();
  EXPECT_EQ(changed, dimmed());
  EXPECT_NE(changed, light);
  applyTheme(Theme::Light);
}

TEST(Forms, GiveNamesAFullRowAndStillFitASmallScreen) {
  OpenWindow open;
  open->resize(1024, 700);
  open.waitUntilIdle();
  EXPECT_EQ(open->size(), QSize(1024, 700)) << "no part needs more";
  const auto* name = open->findChild<QLineEdit*>(QStringLiteral("device.name"));
  const auto* serial = open->findChild<QLineEdit*>(QStringLiteral("device.serial"));
  open->reveal({.field = "device.name"});
  EXPECT_GT(name->width(), 2 * serial->width());
  EXPECT_GE(serial->height(), serial->sizeHint().height());
}

}  // namespace
}  // namespace alidade::ui
