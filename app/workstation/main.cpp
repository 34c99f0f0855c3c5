#include <QCommandLineParser>
#include <QHashFunctions>
#include <QLoggingCategory>
#include <QStandardPaths>
#include <QTextStream>
#include <algorithm>
#include <csignal>
#include <cstdio>

#include "app/workstation/report_command.h"
#include "app/workstation/self_test_command.h"
#include "core/base/failure.h"
#include "core/base/given_arguments.h"
#include "core/base/utf8.h"
#include "core/base/visible_text.h"
#include "core/series/history/series_file.h"
#include "ui/application.h"
#include "ui/document/encoded_path.h"
#include "ui/language/languages.h"
#include "ui/main_window.h"
#include "ui/recovery/termination.h"
#include "ui/settings/theme.h"
#include "ui/settings/window_font.h"
#include "ui/text/visible_log.h"
#include "ui/text/visible_text.h"
#include "ui/window/side_windows.h"

namespace {

using namespace alidade;

/// True if an option is given with which no window opens. Such a call must work without a display.
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

/// The options that state entries of a certificate, and those that sign a file.
class OptionsOfFiles {
 public:
  explicit OptionsOfFiles(QCommandLineParser& parser) {
    for (const QCommandLineOption* option : {&m_measuredOn, &m_country, &m_performedAt, &m_manufacturer,
                                             &m_draft, &m_key, &m_certificate, &m_passphrase})
      parser.addOption(*option);
  }

  /// Returns the reason why the options contradict the requested output; empty if they do not.
  QString whyNot(const QCommandLineParser& parser, bool writes, bool isCertificate) const {
    const auto isSet = [&](const QCommandLineOption& option) { return parser.isSet(option); };
    if (isSet(m_key) != isSet(m_certificate))
      return QStringLiteral("--sign-key and --sign-certificate: give both, the key and its certificate");
    if (isSet(m_passphrase) && !isSet(m_key))
      return QStringLiteral("--sign-passphrase-file opens a --sign-key: give one");
    if (isSet(m_key) && !writes)
      return QStringLiteral("--sign-key signs what --report or --certificate writes: give one");
    for (const QCommandLineOption* option :
         {&m_measuredOn, &m_country, &m_performedAt, &m_manufacturer, &m_draft})
      if (isSet(*option) && !isCertificate)
        return QStringLiteral("--%1 is stated in a --certificate: give one").arg(option->names().first());
    return {};
  }

  void fill(ReportCommand& command, const QCommandLineParser& parser) const {
    command.entries = {.measuredOn = parser.value(m_measuredOn),
                       .country = parser.value(m_country),
                       .performedAt = parser.value(m_performedAt),
                       .manufacturer = parser.value(m_manufacturer),
                       .isDraft = parser.isSet(m_draft)};
    command.signing = {.key = ui::encodedPath(parser.value(m_key)),
                       .certificate = ui::encodedPath(parser.value(m_certificate)),
                       .passphraseFile = ui::encodedPath(parser.value(m_passphrase))};
  }

 private:
  static QCommandLineOption option(const char* name, const char* text, const char* value) {
    return {QString::fromLatin1(name), QString::fromUtf8(text), QString::fromLatin1(value)};
  }

  QCommandLineOption m_measuredOn =
      option("measured-on", "Day of the measurement, for a certificate whose session states none.", "DATE");
  QCommandLineOption m_country = option(
      "country", "Country of the laboratory, for a certificate: two letters after ISO 3166-1.", "CODE");
  QCommandLineOption m_performedAt = option("performed-at",
                                            "Where it was measured, for a certificate: laboratory, customer, "
                                            "laboratoryBranch, customerBranch or other.",
                                            "PLACE");
  QCommandLineOption m_manufacturer =
      option("manufacturer", "Maker of the device, for a certificate.", "NAME");
  QCommandLineOption m_draft{
      QStringLiteral("draft"),
      QStringLiteral("Make a certificate in spite of missing entries, which are “not stated” in it.")};
  QCommandLineOption m_key = option(
      "sign-key", "Sign the report or certificate with this private key (PEM), in a file *.p7s next to it.",
      "KEY");
  QCommandLineOption m_certificate = option("sign-certificate", "The key's certificate (PEM).", "CERT");
  QCommandLineOption m_passphrase =
      option("sign-passphrase-file",
             "File whose first line opens the key; else the environment's ALIDADE_SIGN_PASSPHRASE.", "FILE");
};

/// "en or zh_CN".
QString languageIds() {
  QStringList ids;
  for (const ui::LanguageInfo& language : ui::allLanguages()) ids.append(language.id);
  return ids.join(QStringLiteral(" or "));
}

/// Opens the file within the event loop, where `ui::Application` catches exceptions. At a termination request
/// or the end of the desktop session, the window keeps unsaved and unfinished entries.
int runWindow(ui::Application& application, const QString& path, const ui::Termination& termination) {
  ui::MainWindow window;
  QObject::connect(&termination, &ui::Termination::requested, &window, [&] {
    window.keepNow();
    QApplication::exit();
  });
  QObject::connect(&application, &QGuiApplication::commitDataRequest, &window,
                   [&window](QSessionManager&) { window.keepNow(); });
  QObject::connect(&application, &ui::Application::failed, &window, &ui::MainWindow::reportFailure);
  window.keepIn(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                QStringLiteral("/unsaved"));
  if (path.isEmpty()) window.showStart();
  window.show();
  QMetaObject::invokeMethod(
      &window,
      [&] {
        if (isSeriesPath(ui::encodedPath(path)))
          window.sideWindows().openSeries(path);
        else if (!path.isEmpty())
          window.files().open(path);
        window.offerRecovery();
      },
      Qt::QueuedConnection);
  return application.exec();
}

int openWindow(ui::Application& application, const QString& path) {
  ui::applyTheme(ui::rememberedTheme());
  ui::applyFont(ui::rememberedFont());
  int exitCode = 0, signal = 0;
  {
    const ui::Termination termination;
    exitCode = runWindow(application, path, termination);
    signal = termination.signal();
  }
  if (signal != 0) ui::endBySignal(signal);
  return exitCode;
}

int run(int argc, char** argv) {
  if (argc > 1 && needsNoDisplay(argc, argv)) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QHashSeed::setDeterministicGlobalSeed();  // makes the order of a PDF's fonts reproducible
    QLoggingCategory::setFilterRules(
        QStringLiteral("*.warning=false"));  // reserves stderr for our single line
  }
  const auto empty = emptyArgument(argc, argv);  // before Qt removes its own arguments
  if (empty) return badCall(QString::fromStdString(*empty));
  for (int i = 1; i < argc; ++i)
    if (firstIllFormedByte(argv[i]))
      return badCall(
          QStringLiteral(
              "%1: a name that is no UTF-8 cannot be opened here: rename the file, or use alidade-cli")
              .arg(QString::fromStdString(visibleText(argv[i]))));
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
  const QCommandLineOption certificate(
      QStringLiteral("certificate"),
      QStringLiteral(
          "Write the digital calibration certificate (DCC 3.2.0) of FILE with the report in it, and open no "
          "window."),
      QStringLiteral("OUT.xml"));
  parser.addOption(certificate);
  const OptionsOfFiles more(parser);
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
                               QStringLiteral("Session or series to open, or file of readings to import."),
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
  if (parser.isSet(report) && parser.isSet(certificate))
    return badCall(QStringLiteral("--report and --certificate: write one, then the other"));
  const bool writes = parser.isSet(report) || parser.isSet(certificate);
  if (const QString why = more.whyNot(parser, writes, parser.isSet(certificate)); !why.isEmpty())
    return badCall(why);
  if (parser.isSet(selfTest)) {
    if (!files.isEmpty() || writes)
      return badCall(QStringLiteral("--self-test takes no session, no report and no certificate"));
    return writeSelfTest(parser.value(selfTest));
  }
  if (!writes) return openWindow(application, files.value(0));
  if (files.isEmpty())
    return badCall(QStringLiteral("--%1 needs the FILE of a session")
                       .arg(parser.isSet(report) ? QStringLiteral("report") : QStringLiteral("certificate")));
  ReportCommand command{
      .path = files.first(), .report = parser.value(report), .certificate = parser.value(certificate)};
  more.fill(command, parser);
  return writeReport(command);
}

}  // namespace

int main(int argc, char** argv) {
  ui::keepLogVisible();
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit becomes an error message
  int exitCode = 1;
  const auto failure = failureOf([&] { exitCode = run(argc, argv); });
  if (failure) std::fprintf(stderr, "alidade: Nothing more can be done: %s.\n", failure->c_str());
  return exitCode;
}
