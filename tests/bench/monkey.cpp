#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QSettings>
#include <QTextStream>

#include "tests/ui/monkey/monkey.h"
#include "ui/settings/theme.h"

// alidade_monkey EVENTS [SEED [LOG]]: random input to the window offscreen, see tests/ui/monkey/monkey.h. The
// log is written continuously, so that its last line shows the input that ended the program; LOG.alidade
// holds the current session. Exit code 0 if nothing failed.

namespace {

using namespace alidade::ui;

void write(const QString& path, const QByteArray& bytes, QIODevice::OpenMode mode) {
  QFile file(path);
  if (file.open(mode)) file.write(bytes);
}

int play(int events, unsigned seed, const QString& log) {
  QTextStream out(stdout);
  const Monkey* playing = nullptr;
  std::string last;
  write(log, {}, QIODevice::WriteOnly);
  Monkey monkey(seed, [&](const QString& line) {
    write(log, line.toUtf8() + '\n', QIODevice::Append);
    std::string session = playing ? playing->sessionText() : std::string();
    if (session != last)
      write(log + QStringLiteral(".alidade"), QByteArray::fromStdString(session), QIODevice::WriteOnly);
    last = std::move(session);
  });
  playing = &monkey;
  QElapsedTimer clock;
  clock.start();
  monkey.play(events);
  if (monkey.complaint().isEmpty()) {
    out << "seed " << seed << ": " << events << " events in " << clock.elapsed() / 1000
        << " s, all in order\n";
    return 0;
  }
  out << monkey.log().join(u'\n') << "\nseed " << seed << ": " << monkey.complaint() << '\n';
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QTemporaryDir settings;
  qputenv("XDG_DATA_HOME", settings.path().toLocal8Bit());
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  QApplication application(argc, argv);
  setUpApplication(application);
  const QStringList arguments = QApplication::arguments();
  const unsigned seed = arguments.value(2, QStringLiteral("1")).toUInt();
  return play(arguments.value(1, QStringLiteral("10000")).toInt(), seed,
              arguments.value(3, QStringLiteral("monkey-%1.log").arg(seed)));
}
