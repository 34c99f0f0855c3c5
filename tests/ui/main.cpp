#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/settings/theme.h"

// Without a display, with settings of its own: the user's are neither read nor written.
int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  QTemporaryDir settings;
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  QApplication application(argc, argv);
  alidade::ui::setUpApplication(application);
  alidade::ui::applyTheme(alidade::ui::Theme::Light);
  return RUN_ALL_TESTS();
}
