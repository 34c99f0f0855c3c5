#include <gtest/gtest.h>

#include <QApplication>

#include "tests/ui/monkey/monkey.h"
#include "ui/settings/recent_files.h"

// A short run of `alidade_monkey EVENTS SEED`, which otherwise runs for hours.

namespace alidade::ui {
namespace {

class MonkeyRun : public testing::TestWithParam<unsigned> {
 protected:
  ~MonkeyRun() override { QApplication::setFont(m_font); }  // the monkey also changes the font

 private:
  QFont m_font = QApplication::font();
};

TEST_P(MonkeyRun, LeavesAllInOrder) {
  RecentFiles::clear();  // it opens and saves recent files, which must not be those of earlier tests
  Monkey monkey(GetParam());
  monkey.play(300);
  EXPECT_TRUE(monkey.complaint().isEmpty())
      << "seed " << GetParam() << ": " << monkey.complaint().toStdString() << "\nafter\n"
      << monkey.log().join(u'\n').toStdString();
}

INSTANTIATE_TEST_SUITE_P(Seeds, MonkeyRun, testing::Values(1u, 2u, 3u));

}  // namespace
}  // namespace alidade::ui
