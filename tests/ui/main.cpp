#include <gtest/gtest.h>

#include <QSettings>
#include <QTemporaryDir>
#include <string_view>

#include "tests/ui/recovery/typist.h"
#include "ui/application.h"
#include "ui/settings/theme.h"

// Runs without a display, with separate settings and data: those of the user are never touched.
int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  QTemporaryDir settings;
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  qputenv("XDG_DATA_HOME", settings.path().toLocal8Bit());
  alidade::ui::Application application(argc, argv);
  alidade::ui::setUpApplication(application);
  alidade::ui::applyTheme(alidade::ui::Theme::Light);
  if (argc == 5 && std::string_view(argv[1]) == alidade::ui::typistOption)
    return alidade::ui::typeUntilKilled(argv[2], argv[3], argv[4]);
  return RUN_ALL_TESTS();
}
