#include "tests/console/console.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

namespace alidade::test {

std::string changedPaperSession(const std::function<void(nlohmann::ordered_json&)>& change) {
  std::ifstream file(paperSession);
  nlohmann::ordered_json session = nlohmann::ordered_json::parse(file);
  change(session);
  return session.dump();
}

void expectRefusal(const ProgramRun& run) {
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_THAT(run.err, ::testing::EndsWith("\n"));
}

}  // namespace alidade::test
