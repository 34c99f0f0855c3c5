// Measures the time from the start of the program until the window is first painted, and until it responds to
// the keyboard. With a session file it also measures the time until its result is shown. Opened as by
// `app/workstation/main.cpp`, with separate settings. One line per start: call it several times, as the first
// one reads the disk. Times count from the creation of the process, to a hundredth of a second; processor
// time, in brackets, is affected less by other programs. Offscreen unless QT_QPA_PLATFORM says otherwise.

#include <unistd.h>
#include <QEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>

#include "ui/application.h"
#include "ui/language/languages.h"
#include "ui/main_window.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"

namespace {

using namespace alidade::ui;

/// Milliseconds.
struct Moment {
  double at = 0;    ///< since the system made this process (field 22 of /proc/self/stat, in ticks)
  double work = 0;  ///< of the processor, all threads
};

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

Moment sinceStart() {
  std::ifstream file("/proc/self/stat");
  std::string field;
  std::getline(file, field, ')');
  for (int i = 3; i <= 22; ++i) file >> field;
  const double ticks = std::stod(field) / static_cast<double>(sysconf(_SC_CLK_TCK));
  return {milliseconds(CLOCK_BOOTTIME) - ticks * 1e3, milliseconds(CLOCK_PROCESS_CPUTIME_ID)};
}

/// Records the first paint of anything in the window, and the next pass of the event loop.
class FirstPaint : public QObject {
 public:
  Moment painted, answering;

  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Paint || painted.at > 0) return false;
    painted = sinceStart();
    QTimer::singleShot(0, this, [this] { answering = sinceStart(); });
    return false;
  }
};

}  // namespace

int main(int argc, char** argv) {
  const Moment entered = sinceStart();
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QTemporaryDir settings;
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  Application application(argc, argv);
  setUpApplication(application);
  speak(rememberedLanguage());
  applyTheme(rememberedTheme());
  applyFont(rememberedFont());
  FirstPaint first;
  application.installEventFilter(&first);
  MainWindow window;
  const QString file = application.arguments().value(1);
  if (file.isEmpty()) window.showStart();
  window.show();
  Moment shown;
  QObject::connect(&window.job(), &FitJob::evaluated, &window, [&](const SharedEvaluation& evaluation) {
    if (file.isEmpty() || !evaluation->fit.intersection) return;
    shown = sinceStart();
    application.quit();
  });
  QTimer::singleShot(0, &window, [&] {
    if (!file.isEmpty())
      window.files().open(file);
    else
      QTimer::singleShot(500, &application, &QApplication::quit);
  });
  application.exec();
  const auto print = [](const char* what, const Moment& moment) {
    std::printf("%s %5.0f ms (%4.0f)", what, moment.at, moment.work);
  };
  print("main", entered);
  print(", first paint", first.painted);
  print(", answers keys", first.answering);
  if (shown.at > 0) print(", result", shown);
  std::printf("\n");
}
