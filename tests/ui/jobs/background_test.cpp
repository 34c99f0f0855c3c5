#include "ui/jobs/background.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QThread>
#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

void waitUntilStopped(const std::stop_token& stop) {
  while (!stop.stop_requested()) std::this_thread::yield();
}

bool nothing(const std::string&) {
  ADD_FAILURE() << "the work did not fail";
  return false;
}

TEST(Background, HandsItsValueInWhereItWasMade) {
  const Qt::HANDLE here = QThread::currentThreadId();
  std::vector<bool> wasElsewhere;
  Background<bool> work([&](const std::shared_ptr<const bool>& isElsewhere) {
    EXPECT_EQ(QThread::currentThreadId(), here);
    EXPECT_FALSE(work.isAtWork()) << "the next can be started at once";
    wasElsewhere.push_back(*isElsewhere);
    if (wasElsewhere.size() < 3)
      work.start([here](const std::stop_token&) { return QThread::currentThreadId() != here; }, nothing);
  });
  work.start([here](const std::stop_token&) { return QThread::currentThreadId() != here; }, nothing);
  EXPECT_TRUE(work.isAtWork());
  ASSERT_TRUE(waitFor([&] { return wasElsewhere.size() == 3; }));
  EXPECT_EQ(wasElsewhere, std::vector<bool>(3, true));
}

TEST(Background, TellsOfStoppedWorkUntilTheNext) {
  int done = 0;
  const auto none = [](const std::string&) { return 0; };
  Background<int> work([&](const std::shared_ptr<const int>& value) {
    EXPECT_EQ(work.isStopped(), *value == 1);
    ++done;
  });
  work.start(
      [](const std::stop_token& stop) {
        waitUntilStopped(stop);
        return 1;
      },
      none);
  work.stop();
  ASSERT_TRUE(waitFor([&] { return done == 1; }));
  work.start([](const std::stop_token&) { return 2; }, none);
  ASSERT_TRUE(waitFor([&] { return done == 2; }));
}

TEST(Background, StopsItsWorkAndWaitsForItWhereItEnds) {
  std::atomic<bool> isOver = false;
  bool isTaken = false;
  {
    Background<int> work([&](const std::shared_ptr<const int>&) { isTaken = true; });
    work.start(
        [&](const std::stop_token& stop) {
          waitUntilStopped(stop);
          isOver = true;
          return 1;
        },
        [](const std::string&) { return 0; });
  }
  EXPECT_TRUE(isOver);
  QCoreApplication::processEvents();
  EXPECT_FALSE(isTaken);
}

template <typename Thrown>
std::string valueInstead(const Thrown& thrown) {
  const Qt::HANDLE here = QThread::currentThreadId();
  std::string taken;
  Background<std::string> work([&](const std::shared_ptr<const std::string>& value) { taken = *value; });
  work.start([&](const std::stop_token&) -> std::string { throw thrown; },
             [&](const std::string& reason) {
               EXPECT_EQ(QThread::currentThreadId(), here);
               return "instead: " + reason;
             });
  EXPECT_TRUE(waitFor([&] { return !work.isAtWork(); }));
  return taken;
}

TEST(Background, HandsInAValueInsteadOfWorkThatThrows) {
  EXPECT_EQ(valueInstead(std::bad_alloc()), "instead: out of memory");
  EXPECT_EQ(valueInstead(std::logic_error("no arc")), "instead: a fault in the program (no arc)");
  EXPECT_EQ(valueInstead(7), "instead: a fault in the program (cause not reported)");
}

TEST(Background, GoesOnAfterWorkThatThrew) {
  std::vector<int> taken;
  Background<int> work([&](const std::shared_ptr<const int>& value) { taken.push_back(*value); });
  const auto minusOne = [](const std::string&) { return -1; };
  for (const bool isSound : {false, true, false, true}) {
    work.start(
        [isSound](const std::stop_token&) { return isSound ? 1 : throw std::runtime_error("unsound"); },
        minusOne);
    ASSERT_TRUE(waitFor([&] { return !work.isAtWork(); }));
  }
  EXPECT_EQ(taken, (std::vector<int>{-1, 1, -1, 1}));
}

TEST(Background, WaitsAtItsEndForWorkThatThrows) {
  bool isTaken = false;
  {
    Background<int> work([&](const std::shared_ptr<const int>&) { isTaken = true; });
    work.start(
        [](const std::stop_token& stop) -> int {
          waitUntilStopped(stop);
          throw std::runtime_error("stopped");
        },
        [](const std::string&) { return 0; });
  }
  QCoreApplication::processEvents();
  EXPECT_FALSE(isTaken);
}

}  // namespace
}  // namespace alidade::ui
