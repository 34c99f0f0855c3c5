#include "tests/ui/recovery/typist.h"

#include <QApplication>
#include <QFile>
#include <QTimer>
#include <chrono>
#include <string>

#include "ui/commands/change_session.h"
#include "ui/main_window.h"

namespace alidade::ui {

std::int64_t steadyNanoseconds() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

int typeUntilKilled(const char* folder, const char* path, const char* log) {
  MainWindow window;
  window.keepIn(QString::fromLocal8Bit(folder));
  window.show();
  const QString file = QString::fromLocal8Bit(path);
  if (!file.isEmpty() && window.document().load(file)) return 1;
  QFile lines(QString::fromLocal8Bit(log));
  if (!lines.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) return 1;
  int number = QString::fromStdString(window.document().session().title).toInt();
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &window, [&] {
    constexpr int saveEvery = 100;
    changeField(window.document(), {.field = "title"}, std::to_string(++number));
    lines.write(
        QByteArray::fromStdString(std::to_string(number) + ' ' + std::to_string(steadyNanoseconds()) + '\n'));
    if (!file.isEmpty() && number % saveEvery == 0 && window.document().save(file)) QApplication::exit(1);
  });
  timer.start(10);
  return QApplication::exec();
}

std::map<int, std::int64_t> committedEdits(const QString& log) {
  std::map<int, std::int64_t> edits;
  QFile file(log);
  if (!file.open(QIODevice::ReadOnly)) return edits;
  for (const QByteArray& line : file.readAll().split('\n')) {
    const QList<QByteArray> words = line.split(' ');
    if (words.size() == 2) edits[words[0].toInt()] = words[1].toLongLong();
  }
  return edits;
}

}  // namespace alidade::ui
