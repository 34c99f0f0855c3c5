#include "ui/dialogs/busy.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "tests/ui/support.h"
#include "ui/dialogs/in_background.h"

namespace alidade::ui {
namespace {

using namespace std::chrono_literals;

/// Presses the button of the waiting dialog once it appears.
class Stopper {
 public:
  Stopper() {
    QObject::connect(&m_timer, &QTimer::timeout, [this] {
      for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<QProgressDialog*>(widget); dialog && dialog->isVisible()) {
          ++pressed;
          said = dialog->labelText();
          m_timer.stop();
          dialog->findChild<QPushButton*>()->click();
        }
    });
    m_timer.start(20);
  }

  int pressed = 0;
  QString said;

 private:
  QTimer m_timer;
};

TEST(Busy, LetsTheWindowLiveWhileItWaits) {
  int ticks = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] { ++ticks; });
  timer.start(5);
  Busy busy(nullptr, QStringLiteral("Reading…"));
  const auto made = inBackground<int>(busy, [](const std::stop_token&) {
    std::this_thread::sleep_for(100ms);
    return 7;
  });
  EXPECT_EQ(made, 7);
  EXPECT_GE(ticks, 3);
}

TEST(Busy, LeavesTheWorkWhenTold) {
  const auto stopped = std::make_shared<std::atomic<bool>>(false);
  Stopper stopper;
  Busy busy(nullptr, QStringLiteral("Reading…"));
  const auto made = inBackground<int>(busy, [stopped](const std::stop_token& stop) {
    while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
    *stopped = true;
    return 7;
  });
  EXPECT_FALSE(made);
  EXPECT_EQ(stopper.said, QStringLiteral("Reading…"));
  EXPECT_TRUE(waitFor([&] { return stopped->load(); })) << "the work is told, too";
}

TEST(Busy, LeavesNoFileHalfWritten) {
  int closed = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QProgressDialog*>(widget); dialog && dialog->isVisible()) {
        EXPECT_EQ(dialog->findChild<QPushButton*>(), nullptr);
        closed += dialog->close() ? 1 : 0;
      }
  });
  timer.start(20);
  Busy busy(nullptr, QStringLiteral("Saving…"), Busy::Way::ToItsEnd);
  const auto made = inBackground<int>(busy, [](const std::stop_token& stop) {
    for (int i = 0; i < 700 && !stop.stop_requested(); ++i) std::this_thread::sleep_for(1ms);
    return stop.stop_requested() ? 0 : 7;
  });
  EXPECT_EQ(made, 7);
  EXPECT_GT(closed, 0);
}

TEST(Busy, HandsOnWhatIsThrown) {
  Busy busy(nullptr, QStringLiteral("Reading…"));
  const auto fail = [](const std::stop_token&) -> int { throw std::runtime_error("broken"); };
  EXPECT_THROW(inBackground<int>(busy, fail), std::exception);
}

TEST(Busy, BreathesInWorkOfTheWindowsOwnThread) {
  Stopper stopper;
  Busy busy(nullptr, QStringLiteral("Writing…"));
  int steps = 0;
  while (steps < 5000 && busy.goesOn(steps / 5000.0)) {
    std::this_thread::sleep_for(1ms);
    ++steps;
  }
  EXPECT_EQ(stopper.pressed, 1);
  EXPECT_LT(steps, 5000);
}

}  // namespace
}  // namespace alidade::ui
