#include "ui/jobs/fit_job.h"

#include <gtest/gtest.h>

#include <QThreadPool>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/session/session_file.h"
#include "tests/support/large_session.h"
#include "tests/ui/support.h"
#include "ui/commands/edit_readings.h"
#include "ui/document/session_document.h"

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

/// A sound session with an error of twenty degrees in one reading.
Session slippedSession() {
  Session session = *loadSession(samplePath(QStringLiteral("clean-session.alidade")).toStdString());
  session.positions[0].readings[3].vertical = "60 00 00";
  return session;
}

TEST(FitJob, DeliversTheFitAtOnceAndTheSuspectsAfterIt) {
  FitJob job;
  std::vector<std::string> stages;
  SharedEvaluation fitted;
  QObject::connect(&job, &FitJob::evaluated, [&](const SharedEvaluation& evaluation) {
    stages.push_back("fit");
    fitted = evaluation;
  });
  QObject::connect(&job, &FitJob::searched, [&](const SharedEvaluation& evaluation) {
    stages.push_back("suspects");
    EXPECT_TRUE(fitted->fit.intersection);
    EXPECT_FALSE(fitted->isSearched);
    EXPECT_TRUE(fitted->suspects.empty());
    EXPECT_TRUE(evaluation->isSearched);
    ASSERT_EQ(evaluation->suspects.size(), 1u);
    EXPECT_EQ(evaluation->suspects.front().where.reading, 3u);
    EXPECT_EQ(evaluation->session, fitted->session);
  });
  job.request(slippedSession());
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  EXPECT_EQ(stages, (std::vector<std::string>{"fit", "suspects"}));
}

TEST(FitJob, DiscardsTheSuspectsOfASessionThatWasEdited) {
  FitJob job;
  std::vector<std::string> fitted, searched;
  Session edited = slippedSession();
  edited.title = "edited";
  QObject::connect(&job, &FitJob::evaluated, [&](const SharedEvaluation& evaluation) {
    fitted.push_back(evaluation->session.title);
    if (fitted.size() == 1) job.request(edited);  // the edit comes before the suspects are found
  });
  QObject::connect(&job, &FitJob::searched, [&](const SharedEvaluation& evaluation) {
    searched.push_back(evaluation->session.title);
  });
  Session session = slippedSession();
  session.title = "first";
  job.request(session);
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  EXPECT_EQ(fitted, (std::vector<std::string>{"first", "edited"}));
  EXPECT_EQ(searched, std::vector<std::string>{"edited"});
}

/// The edit is posted before the search begins, so it arrives before the search's result, however fast.
TEST(FitJob, DiscardsASearchThatIsAtWork) {
  FitJob job;
  std::vector<std::string> fitted, searched;
  Session session = slippedSession();
  QObject::connect(&job, &FitJob::evaluated, [&](const SharedEvaluation& evaluation) {
    fitted.push_back(evaluation->session.title);
    if (fitted.size() > 1) return;
    session.title = "edited";
    QMetaObject::invokeMethod(
        &job, [&] { job.request(session); }, Qt::QueuedConnection);
  });
  QObject::connect(&job, &FitJob::searched, [&](const SharedEvaluation& evaluation) {
    searched.push_back(evaluation->session.title);
  });
  session.title = "first";
  job.request(session);
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  EXPECT_EQ(fitted, (std::vector<std::string>{"first", "edited"}));
  EXPECT_EQ(searched, std::vector<std::string>{"edited"});
}

TEST(FitJob, HasNothingToSearchWithoutAFit) {
  FitJob job;
  int searches = 0;
  SharedEvaluation last;
  QObject::connect(&job, &FitJob::evaluated, [&](const SharedEvaluation& evaluation) { last = evaluation; });
  QObject::connect(&job, &FitJob::searched, [&] { ++searches; });
  job.request(blankSession());
  ASSERT_TRUE(waitFor([&] { return job.isIdle(); }));
  EXPECT_TRUE(last->isSearched);
  EXPECT_EQ(searches, 0);
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

/// Edits cell after cell, each evaluated before the next, and keeps the shown evaluation.
class Typist {
 public:
  explicit Typist(const Session& session) {
    m_document.startWith(session);
    QObject::connect(&m_job, &FitJob::evaluated, [this](const SharedEvaluation& one) { m_shown = one; });
    QObject::connect(&m_job, &FitJob::searched, [this](const SharedEvaluation& one) { m_shown = one; });
    m_job.request(m_document.session());
    rest();
    QObject::connect(&m_document, &SessionDocument::changed, [this] { m_job.request(m_document.session()); });
  }

  const Evaluation& type(std::size_t row, const std::string& text) {
    ReadingsEditor(m_document, 1).setCell({row, ReadingColumn::Note}, text);
    rest();
    return *m_shown;
  }
  SharedEvaluation shown() const { return m_shown; }
  const Session& session() const { return m_document.session(); }

 private:
  void rest() {
    ASSERT_TRUE(waitFor([this] { return m_job.isIdle(); }));
    QThreadPool::globalInstance()->waitForDone();  // discarded objects are released there
  }

  SessionDocument m_document;
  SharedEvaluation m_shown;
  FitJob m_job;
};

TEST(FitJob, LeavesASessionToThoseWhoHoldOnToIt) {
  Typist typist(paperSession());
  std::vector<SharedEvaluation> held;
  std::vector<Session> asShown;
  for (std::size_t i = 0; i < 6; ++i) {
    typist.type(i, "note " + std::to_string(i));
    held.push_back(typist.shown());
    asShown.push_back(typist.session());
  }
  for (std::size_t i = 0; i < held.size(); ++i) EXPECT_EQ(held[i]->session, asShown[i]) << i;
}

}  // namespace
}  // namespace alidade::ui
