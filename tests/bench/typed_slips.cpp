// Measures how often typing slips are found and corrected: simulated sessions with one slip, visible by more
// than ten sigma, by kind and plan. It also measures how often a sound session names a suspect. Arguments:
// sessions for each plan (2000), step in arcseconds to which readings are typed (0.1).

#include "tests/support/typed_slips.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "core/wording/suspects.h"

namespace {

using namespace alidade;
using namespace alidade::test;

const char* const names[] = {
    "none",       "digits swapped",  "digit wrong",     "degree off", "ten minutes off",
    "minute off", "ten seconds off", "circles swapped", "wrong face", "neighbouring row"};

struct Rates {
  int sessions = 0, cells = 0, corrections = 0, others = 0;

  void count(const Found& found) {
    ++sessions;
    cells += found.rightCell;
    corrections += found.rightCorrection;
    others += found.others > 0;
  }
  void print(const char* name) const {
    const double percent = 100.0 / std::max(sessions, 1);
    std::printf(
        "  %-18s %5d sessions, right cell %6.2f %%, right correction first %6.2f %%, sound cells named %5.2f "
        "%%\n",
        name, sessions, cells * percent, corrections * percent, others * percent);
  }
};

void runPlan(const char* name, int sessions, double step, bool verbose) {
  const Protocol& protocol = *protocolByName(name);
  Rates all, kinds[errorKinds + 1];
  double milliseconds = 0;
  for (int i = 0; i < sessions; ++i) {
    const auto error = static_cast<TypedError>(1 + i % errorKinds);
    const MistypedSession mistyped =
        mistypedSession(protocol, error, static_cast<std::uint64_t>(i) + 1, step);
    if (mistyped.visibleSigma <= 10) continue;
    const auto begin = std::chrono::steady_clock::now();
    const auto suspects = suspectsOf(mistyped.session);
    milliseconds +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    const Found found = judge(mistyped, suspects);
    all.count(found);
    kinds[static_cast<int>(error)].count(found);
    if (verbose && !(found.rightCell && found.rightCorrection)) {
      Session copy = mistyped.session;
      std::printf("    seed %d %s:", i + 1, names[static_cast<int>(error)]);
      for (const CellChange& change : mistyped.cure)
        std::printf(" %s %s for %s", change.where.path().c_str(), cell(copy, change.where).c_str(),
                    change.text.c_str());
      std::printf(" (%.0f sigma)\n", mistyped.visibleSigma);
      for (const Suspect& suspect : suspects) {
        std::printf("      %s t %.1f %s\n", suspect.where.path().c_str(), suspect.studentised,
                    sentenceOf(suspect).c_str());
        for (const Proposal& proposal : suspect.proposals)
          std::printf("        %.3f %s\n", proposal.share, sentenceOf(proposal).c_str());
      }
    }
  }
  int alarms = 0;
  double quiet = 0;
  for (int i = 0; i < sessions; ++i) {
    const Session sound =
        mistypedSession(protocol, TypedError::None, static_cast<std::uint64_t>(i) + 1, step).session;
    const Measurement measurement = *examine(sound).measurement;
    const SessionFit fit = fitSession(measurement);
    const auto begin = std::chrono::steady_clock::now();
    alarms += findSuspects(sound, measurement, fit).empty() ? 0 : 1;
    quiet += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  }
  std::printf("%s, %.2f ms with a slip, %.2f ms without; suspects named in %.2f %% of sound sessions\n", name,
              milliseconds / sessions, quiet / sessions, 100.0 * alarms / sessions);
  for (int kind = 1; kind <= errorKinds; ++kind) kinds[kind].print(names[kind]);
  all.print("all");
}

/// Adjacent slips: how often a correction is proposed, and how often a wrong one.
void runNeighbours(const char* name, int sessions, double step) {
  const Protocol& protocol = *protocolByName(name);
  for (const std::size_t count : {2U, 3U}) {
    std::size_t suspects = 0, offers = 0, wrong = 0, misled = 0;
    for (int i = 0; i < sessions; ++i) {
      const MistypedSession mistyped =
          neighbouringErrors(protocol, count, static_cast<std::uint64_t>(i) + 1, step);
      const auto found = suspectsOf(mistyped.session);
      suspects += found.size();
      for (const Suspect& suspect : found) offers += suspect.proposals.empty() ? 0 : 1;
      const std::size_t falsely = falseOffers(mistyped, found);
      wrong += falsely;
      misled += falsely > 0 ? 1 : 0;
    }
    std::printf(
        "%s, %zu slips next to each other in %d sessions: %zu suspects, %zu with a correction, %zu of "
        "them none, in %zu sessions\n",
        name, count, sessions, suspects, offers, wrong, misled);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int sessions = argc > 1 ? std::atoi(argv[1]) : 2000;
  const double step = argc > 2 ? std::atof(argv[2]) : 0.1;
  for (const char* plan : {"paper", "paper-slider", "two-face", "full"})
    if (argc <= 3 || std::string(argv[3]) == plan) {
      runPlan(plan, sessions, step, argc > 4);
      runNeighbours(plan, sessions, step);
    }
}
