#include "ui/window/session_jobs.h"

#include <gtest/gtest.h>

#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/document/session_document.h"

namespace alidade::ui {
namespace {

class SessionJobsTest : public ::testing::Test {
 protected:
  SessionJobsTest() {
    document.startWithRecorded(paperSession());
    QObject::connect(&jobs, &SessionJobs::headlineChanged,
                     [this](const Headline& headline) { shown.push_back(headline); });
    QObject::connect(&jobs.gap(), &GapJob::completed, [this] { ++diagnoses; });
    QObject::connect(&jobs, &SessionJobs::evaluated, [this] { ++evaluations; });
    QObject::connect(&jobs, &SessionJobs::gapAged, [this] { ++aged; });
    jobs.start();
    EXPECT_TRUE(waitFor([this] { return diagnoses == 1; }));
    shown.clear();
  }

  void change(const char* field, const char* text) {
    const int before = evaluations;
    changeField(document, {.field = field}, text);
    EXPECT_TRUE(waitFor([&] { return evaluations > before; }));
  }
  bool wasProvisional() const {
    return std::ranges::any_of(shown, [](const Headline& headline) { return headline.isProvisional; });
  }

  SessionDocument document;
  SessionJobs jobs{document};
  std::vector<Headline> shown;
  int diagnoses = 0, evaluations = 0, aged = 0;
};

TEST_F(SessionJobsTest, KeepsTheDiagnosisThroughEntriesThatEnterNoResult) {
  change("report.laboratory", "Metrology Lab");
  change("title", "Acceptance");
  EXPECT_FALSE(wasProvisional());
  ASSERT_FALSE(shown.empty());
  EXPECT_TRUE(shown.back().isMeasured);
  EXPECT_EQ(diagnoses, 1);
}

TEST_F(SessionJobsTest, DiagnosesAnewAfterAnEntryOfTheMeasurement) {
  change("geometry.distance_mm", "2406");
  EXPECT_TRUE(wasProvisional());
  EXPECT_TRUE(waitFor([this] { return diagnoses == 2; }));
  shown.clear();
  document.undoStack().undo();
  EXPECT_TRUE(waitFor([this] { return diagnoses == 3; })) << "only the last diagnosis is kept";
}

TEST_F(SessionJobsTest, OutdatesTheGapOnlyByOtherEvidence) {
  jobs.setWithReference(false);
  EXPECT_EQ(aged, 0) << "the causes are weighed so already";
  EXPECT_TRUE(jobs.gap().isIdle());
  jobs.setWithReference(true);
  EXPECT_EQ(aged, 1);
  EXPECT_TRUE(waitFor([this] { return diagnoses == 2; }));
  jobs.setWithReference(true);
  EXPECT_EQ(aged, 1);
  EXPECT_TRUE(jobs.gap().isIdle());
}

}  // namespace
}  // namespace alidade::ui
