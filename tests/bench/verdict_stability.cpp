#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/support/verdict_trials.h"

// How often the verdict of a simulated session changes when one row is left out or misread by 60″, and how
// often from undecided to accept. Of the latter, how often all readings gave a probability of conformity
// below 90 %. Sessions are counted by plan, without any effect and with a random one.
//
//   alidade_verdict_stability [SESSIONS [SEED [CHANGES]]]

namespace {

using namespace alidade;

struct Tally {
  int sessions = 0, accepted = 0, rejected = 0;
  test::Changes changes;
};

void add(Tally& tally, const test::JudgedSession& session, int count, std::uint64_t seed) {
  ++tally.sessions;
  tally.accepted += session.decision.verdict == Verdict::Accept ? 1 : 0;
  tally.rejected += session.decision.verdict == Verdict::Reject ? 1 : 0;
  const test::Changes more = test::changesOf(session, count, seed);
  tally.changes.all += more.all;
  tally.changes.other += more.other;
  tally.changes.better += more.better;
  tally.changes.unsupported += more.unsupported;
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t sessions = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 500;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const int changes = argc > 3 ? std::atoi(argv[3]) : 6;
  std::printf("%-14s %-9s %8s %8s %8s %8s %8s %8s %11s\n", "plan", "truth", "sessions", "accept", "reject",
              "changes", "other", "better", "unsupported");
  for (const char* protocol : {"paper", "paper-slider", "two-face", "full"})
    for (const char* truth : {"none", "anything"}) {
      Tally tally;
      const std::vector<std::string> kinds =
          std::string(truth) == "none" ? std::vector<std::string>{"none"} : std::vector<std::string>{};
      for (std::uint64_t seed = first; seed < first + sessions; ++seed)
        if (const auto session = test::judged(test::drawnAcceptance(protocol, kinds, seed)))
          add(tally, *session, changes, seed);
      std::printf("%-14s %-9s %8d %8d %8d %8d %8d %8d %11d\n", protocol, truth, tally.sessions,
                  tally.accepted, tally.rejected, tally.changes.all, tally.changes.other,
                  tally.changes.better, tally.changes.unsupported);
      std::fflush(stdout);
    }
}
