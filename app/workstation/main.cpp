#include <QCommandLineParser>
#include <QLoggingCategory>
#include <QStandardPaths>
#include <QTextStream>
#include <algorithm>
#include <csignal>
#include <cstdio>

#include "app/workstation/report_command.h"
#include "app/workstation/self_test_command.h"
#include "core/base/failure.h"
#include "ui/application.h"
#include "ui/language/languages.h"
#include "ui/main_window.h"
#include "ui/settings/theme.h"
#include "ui/settings/visible_log.h"
#include "ui/settings/window_font.h"
#include "ui/text/visible_text.h"

namespace {

using namespace alidade;

/// Calls with most options of ours never open a window, so they must not need a display either.
bool needsNoDisplay(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc, [](const char* argument) {
    const QByteArray text(argument);
    const bool isForWindow = text == "--platform" || text.startsWith("--language");
    return (text.startsWith("--") && !isForWindow) || text == "-h" || text == "-v";
  });
}

int badCall(const QString& sentence) {
  QTextStream(stderr) << "alidade: " << ui::visibleLine(sentence) << '\n';
  return 2;
}

/// "en or zh_CN".
QString languageIds() {
  QStringList ids;
  for (const ui::LanguageInfo& language : ui::allLanguages()) ids.append(language.id);
  return ids.join(QStringLiteral(" or "));
}

/// The file is opened from within the event loop: what it throws ends nothing.
int openWindow(ui::Application& application, const QString& path) {
  ui::applyTheme(ui::rememberedTheme());
  ui::applyFont(ui::rememberedFont());
  ui::MainWindow window;
  QObject::connect(&application, &ui::Application::failed, &window, &ui::MainWindow::tellFailure);
  window.keepIn(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                QStringLiteral("/unsaved"));
  if (path.isEmpty()) window.showStart();
  window.show();
  QMetaObject::invokeMethod(
      &window,
      [&] {
        if (!path.isEmpty()) window.files().open(path);
        window.offerRecovery();
      },
      Qt::QueuedConnection);
  return application.exec();
}

int run(int argc, char** argv) {
  if (argc > 1 && needsNoDisplay(argc, argv)) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QLoggingCategory::setFilterRules(
        QStringLiteral("*.warning=false"));  // stderr is for the one line of ours
  }
  ui::Application application(argc, argv);
  ui::setUpApplication(application);
  QGuiApplication::setDesktopFileName(QStringLiteral(ALIDADE_APPLICATION_ID));

  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Measurement workstation for rotatable arc guideways."));
  const QCommandLineOption help = parser.addHelpOption();
  const QCommandLineOption version = parser.addVersionOption();
  const QCommandLineOption report(QStringLiteral("report"),
                                  QStringLiteral("Write the acceptance report of FILE and open no window."),
                                  QStringLiteral("OUT.pdf"));
  parser.addOption(report);
  const QCommandLineOption selfTest(
      QStringLiteral("self-test"),
      QStringLiteral("Check this installation, write what was found and open no window."),
      QStringLiteral("OUT.pdf"));
  parser.addOption(selfTest);
  const QCommandLineOption language(
      QStringLiteral("language"),
      QStringLiteral("Language of window and report: %1. Else as chosen in the window, or as the desktop.")
          .arg(languageIds()),
      QStringLiteral("ID"));
  parser.addOption(language);
  parser.addPositionalArgument(QStringLiteral("FILE"),
                               QStringLiteral("Session to open, or GSI or CSV file to import."),
                               QStringLiteral("[FILE]"));
  if (!parser.parse(QApplication::arguments())) return badCall(parser.errorText());
  if (parser.isSet(help)) parser.showHelp();
  if (parser.isSet(version)) parser.showVersion();

  const QString wanted = parser.value(language);
  if (parser.isSet(language) && ui::languageOr(wanted) != wanted)
    return badCall(QStringLiteral("--language: “%1” is not %2").arg(wanted, languageIds()));
  ui::speak(wanted.isEmpty() ? ui::rememberedLanguage() : wanted);

  const QStringList files = parser.positionalArguments();
  if (files.size() > 1)
    return badCall(QStringLiteral("one FILE at most, but %1 are given").arg(files.size()));
  if (parser.isSet(selfTest)) {
    if (!files.isEmpty() || parser.isSet(report))
      return badCall(QStringLiteral("--self-test takes no session and no report"));
    return writeSelfTest(parser.value(selfTest));
  }
  if (!parser.isSet(report)) return openWindow(application, files.value(0));
  if (files.isEmpty()) return badCall(QStringLiteral("--report needs the FILE of a session"));
  return writeReport(files.first(), parser.value(report));
}

}  // namespace

int main(int argc, char** argv) {
  ui::keepLogVisible();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is told in a sentence
  int exitCode = 1;
  const auto failure = failureOf([&] { exitCode = run(argc, argv); });
  if (failure) std::fprintf(stderr, "alidade: Nothing more can be done: %s.\n", failure->c_str());
  return exitCode;
}
