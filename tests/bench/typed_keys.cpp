// Types entries into the window by key events, at a given number of milliseconds per key, while fits and
// diagnoses arrive normally. Counts the entries that are not stored as typed. At 34 rows it types all 68
// angles of the published table into an empty one, else the first 24 of them below the existing rows.
// Arguments: milliseconds per key (else 2, 8, 30, 60, 150). Offscreen unless QT_QPA_PLATFORM says otherwise.

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <string>
#include <vector>

#include "core/session/session_file.h"
#include "tests/support/large_session.h"
#include "ui/main_window.h"
#include "ui/settings/theme.h"

namespace {

using namespace alidade;
using namespace alidade::ui;

/// The numbers of an angle, separated by blanks in place of the unit signs.
std::string digits(const std::string& angle) {
  std::string plain;
  for (const char c : angle)
    if ((c >= '0' && c <= '9') || c == '.')
      plain += c;
    else if (!plain.empty() && plain.back() != ' ')
      plain += ' ';
  while (!plain.empty() && plain.back() == ' ') plain.pop_back();
  return plain;
}

void rest(int milliseconds) {
  QElapsedTimer clock;
  clock.start();
  do QApplication::processEvents(QEventLoop::AllEvents, 1);
  while (clock.elapsed() < milliseconds);
}

void type(const std::string& text, int milliseconds) {
  for (const char key : text) {
    QTest::keyClick(QApplication::focusWidget(), key);
    rest(milliseconds);
  }
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  rest(milliseconds);
}

struct Count {
  int wrong = 0, all = 0;
};

Count typeInto(MainWindow& window, const Session& session, const Session& read, std::size_t most,
               int milliseconds) {
  window.document().startWith(session);
  while (!window.job().isIdle()) QApplication::processEvents();
  Count count;
  for (std::size_t position = 0; position < 2; ++position) {
    const std::size_t first = session.positions[position].readings.size();
    window.reveal({.position = position, .reading = first, .field = "horizontal"});
    std::vector<std::string> typed;
    for (const Reading& row : read.positions[position].readings)
      for (const std::string* text : {&row.horizontal, &row.vertical}) {
        if (typed.size() * 2 >= most) break;
        typed.push_back(digits(*text));
        type(typed.back(), milliseconds);
      }
    const auto& rows = window.document().session().positions[position].readings;
    for (std::size_t i = 0; i < typed.size(); ++i) {
      const std::size_t row = first + i / 2;
      const bool isRight =
          row < rows.size() && (i % 2 == 0 ? rows[row].horizontal : rows[row].vertical) == typed[i];
      count.wrong += isRight ? 0 : 1;
      ++count.all;
    }
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  setUpApplication(application);
  QTemporaryDir settings;  // the user's settings are neither read nor written
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  const Result<Session> paper = loadSession(ALIDADE_SAMPLES_DIR "/paper-table-1.alidade");
  if (!paper) return 2;
  std::vector<int> speeds;
  for (int i = 1; i < argc; ++i) speeds.push_back(std::stoi(argv[i]));
  if (speeds.empty()) speeds = {2, 8, 30, 60, 150};
  MainWindow window;
  window.show();
  QApplication::setActiveWindow(&window);
  for (const std::size_t rows : {34u, 1000u, 2720u, 20400u})
    for (const int milliseconds : speeds) {
      Session session = rows == 34 ? *paper : test::largeSession(rows);
      if (rows == 34)
        for (Position& position : session.positions) position.readings.clear();
      const Count count = typeInto(window, session, *paper, rows == 34 ? 68 : 24, milliseconds);
      std::printf("%6zu rows, %3d ms a key: %2d of %d entries are not as typed\n", rows, milliseconds,
                  count.wrong, count.all);
      std::fflush(stdout);
    }
  return 0;
}
