#include "ui/jobs/background.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QThread>
#include <atomic>
#include <thread>
#include <vector>

#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

void waitUntilStopped(const std::stop_token& stop) {
  while (!stop.stop_requested()) std::this_thread::yield();
}

TEST(Background, HandsItsValueInWhereItWasMade) {
  const Qt::HANDLE here = QThread::currentThreadId();
  std::vector<bool> wasElsewhere;
  Background<bool> work([&](const std::shared_ptr<const bool>& isElsewhere) {
    EXPECT_EQ(QThread::currentThreadId(), here);
    EXPECT_FALSE(work.isAtWork()) << "the next can be started at once";
    wasElsewhere.push_back(*isElsewhere);
    if (wasElsewhere.size() < 3)
      work.start([here](const std::stop_token&) { return QThread::currentThreadId() != here; });
  });
  work.start([here](const std::stop_token&) { return QThread::currentThreadId() != here; });
  EXPECT_TRUE(work.isAtWork());
  ASSERT_TRUE(waitFor([&] { return wasElsewhere.size() == 3; }));
  EXPECT_EQ(wasElsewhere, std::vector<bool>(3, true));
}

TEST(Background, TellsOfStoppedWorkUntilTheNext) {
  int done = 0;
  Background<int> work([&](const std::shared_ptr<const int>& value) {
    EXPECT_EQ(work.isStopped(), *value == 1);
    ++done;
  });
  work.start([](const std::stop_token& stop) {
    waitUntilStopped(stop);
    return 1;
  });
  work.stop();
  ASSERT_TRUE(waitFor([&] { return done == 1; }));
  work.start([](const std::stop_token&) { return 2; });
  ASSERT_TRUE(waitFor([&] { return done == 2; }));
}

TEST(Background, StopsItsWorkAndWaitsForItWhereItEnds) {
  std::atomic<bool> isOver = false;
  bool isTaken = false;
  {
    Background<int> work([&](const std::shared_ptr<const int>&) { isTaken = true; });
    work.start([&](const std::stop_token& stop) {
      waitUntilStopped(stop);
      isOver = true;
      return 1;
    });
  }
  EXPECT_TRUE(isOver);
  QCoreApplication::processEvents();
  EXPECT_FALSE(isTaken);
}

}  // namespace
}  // namespace alidade::ui
