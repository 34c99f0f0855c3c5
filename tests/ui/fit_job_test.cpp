#include "ui/jobs/fit_job.h"

#include <gtest/gtest.h>

#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

TEST(FitJob, DeliversTheNewestRequestAndNoneThatItOvertook) {
  FitJob job;
  std::vector<std::string> titles;
  QObject::connect(&job, &FitJob::evaluated, [&](const SharedEvaluation& evaluation) {
    titles.push_back(evaluation->session.title);
    EXPECT_TRUE(evaluation->fit.intersection);
  });
  Session session = paperSession();
  for (int i = 0; i < 50; ++i) {
    session.title = std::to_string(i);
    job.request(session);
  }
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  EXPECT_EQ(titles, std::vector<std::string>{"49"});
}

TEST(FitJob, MayGoWhileItIsAtWork) {
  auto job = std::make_unique<FitJob>();
  job->request(paperSession());
  job->request(blankSession());
  EXPECT_FALSE(job->isIdle());
  job.reset();
}

TEST(Evaluation, OfABlankSessionSaysWhatIsMissing) {
  const Evaluation evaluation = evaluate(blankSession());
  EXPECT_FALSE(evaluation.examined.measurement);
  EXPECT_FALSE(evaluation.examined.problems.empty());
  EXPECT_FALSE(evaluation.fit.intersection);
}

}  // namespace
}  // namespace alidade::ui
