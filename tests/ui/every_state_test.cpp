// In every state of a typed session and in every geometry, the window and the report give a result or a
// sentence. Results: tests/core/every_state_test.cpp.

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QTest>

#include "core/session/session_file.h"
#include "core/statement/gap.h"
#include "tests/support/guarded_memory.h"
#include "tests/support/typing.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/panels/window/page_tabs.h"

namespace alidade::ui {
namespace {

using namespace alidade::test;

/// A window that opens one session after another.
class Showing {
 public:
  Showing() {
    QObject::connect(&m_open->job(), &FitJob::evaluated, m_open.window.get(),
                     [this](const SharedEvaluation& evaluation) { m_evaluation = evaluation; });
    QObject::connect(&m_open->gapJob(), &GapJob::assessed, m_open.window.get(),
                     [this](const SharedGap& gap) { m_gap = gap; });
    QTest::keyClick(m_open.window.get(), Qt::Key_5, Qt::ControlModifier);  // starts the diagnosis at once
  }

  void show(const Session& session) {
    m_open->document().startWith(session);
    const auto isDone = [this] { return m_open->job().isIdle() && m_open->gapJob().isIdle(); };
    ASSERT_TRUE(QTest::qWaitFor(isDone, 60000));
    ASSERT_TRUE(m_evaluation && m_gap);
    EXPECT_EQ(m_evaluation->session, session);
    EXPECT_FALSE(m_evaluation->failure);
    EXPECT_TRUE(m_gap->diagnosis || !reasonForNone(*m_gap).empty());
    EXPECT_FALSE(std::holds_alternative<FailedWork>(m_gap->reason)) << reasonForNone(*m_gap);
    for (PageTabs* tabs : m_open->pageTabs())
      for (int page = 0; page < tabs->count(); ++page) {
        tabs->showPage(page);
        for (const ShownText& shown : shownTexts(*m_open.window)) expectNumbers(shown.text);
      }
    const Printed report(session);
    EXPECT_GE(report.pageCount(), 1);
    expectNumbers(report.text());
  }

 private:
  static void expectNumbers(const QString& text) {
    static const QRegularExpression none(QStringLiteral("(?<![\\p{L}])-?(nan|inf)(?![\\p{L}])"));
    EXPECT_FALSE(text.contains(none)) << text.toStdString();
  }

  OpenWindow m_open;
  SharedEvaluation m_evaluation;
  SharedGap m_gap;
};

class EveryStateShown : public testing::TestWithParam<int> {};

TEST_P(EveryStateShown, OfTypingIsAnAnswerOrASentence) {
  constexpr int states = inTheTime(20), apart = 7;
  const std::uint64_t shard = 7200000 + 1000 * static_cast<std::uint64_t>(GetParam());
  Showing showing;
  int shown = 0;
  for (std::uint64_t seed = shard; shown < states && !HasFailure(); ++seed) {
    Typing typing(seed);
    for (int state = static_cast<int>(seed % apart); typing.next() && shown < states && !HasFailure();
         ++state) {
      if (state % apart != 0) continue;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", state " + std::to_string(state));
      showing.show(typing.session());
      ++shown;
      if (HasFailure()) ADD_FAILURE() << writeSession(typing.session());
    }
  }
}

TEST_P(EveryStateShown, OfAnyGeometryIsAnAnswerOrASentence) {
  constexpr int sessions = inTheTime(4);
  const std::uint64_t shard = 8200000 + 1000 * static_cast<std::uint64_t>(GetParam());
  Showing showing;
  for (std::uint64_t seed = shard; seed < shard + sessions && !HasFailure(); ++seed) {
    std::mt19937_64 random(seed);
    const DrawnPlan plan = drawnPlan(random, seed % 8 == 0 ? 500 : 60, seed);
    const Result<Session> session = simulate(plan.protocol, plan.truth, seed);
    if (!session) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    showing.show(*session);
  }
}

INSTANTIATE_TEST_SUITE_P(Sample, EveryStateShown, testing::Values(0));
INSTANTIATE_TEST_SUITE_P(Long, EveryStateShown, testing::Range(1, 3));

}  // namespace
}  // namespace alidade::ui
