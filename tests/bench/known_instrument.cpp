#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/random_source.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/plan_review.h"
#include "core/effects/catalogue.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

// The benefit of an instrument record. First, for every named plan: which effects a session could not
// distinguish without knowledge of the instrument, and with its constants (collimation, trunnion tilt, index,
// both circles' eccentricities) known to 1″. Then, by plan and constant: sessions in which the constant
// agrees with the record (its error drawn from u), and sessions in which it has changed by 30″ since. Counts
// how often the known value is called stale and how often another cause is named. Also counts how often Δd ±
// U (95 %), measured, covers the true Δd, with and without the record.
//
//   alidade_known_instrument [SESSIONS [SEED [PLAN]]]

namespace {

using namespace alidade;

constexpr double known = 1, change = 30;  // arcseconds: u of the record, and the change since

const std::vector<std::string_view> constants = {"collimation", "trunnion_tilt", "vertical_index",
                                                 "horizontal_circle_eccentricity",
                                                 "vertical_circle_eccentricity"};

void addKnown(Measurement& measurement, std::string_view id, double value) {
  for (const EffectParameter& parameter : effectById(id)->parameters)
    measurement.known.push_back({.effect = std::string(id),
                                 .parameter = std::string(parameter.name),
                                 .unit = "arcsec",
                                 .from = "record",
                                 .value = &parameter == &effectById(id)->parameters.front() ? value : 0,
                                 .sigma = known});
}

Measurement measurementOf(const Session& session) {
  return *examine(session).measurement;
}

/// Groups of effects connected as look-alikes.
std::vector<std::set<std::string>> groupsOf(const PlanReview& review) {
  std::vector<std::set<std::string>> groups;
  for (const PlannedEffect& effect : review.effects) {
    std::set<std::string> group{effect.effect};
    for (const LookAlike& other : effect.lookAlikes) group.insert(other.effect);
    if (group.size() == 1) continue;
    for (auto it = groups.begin(); it != groups.end();) {
      const bool meets = std::ranges::any_of(*it, [&](const std::string& id) { return group.contains(id); });
      if (meets) group.insert(it->begin(), it->end());
      it = meets ? groups.erase(it) : it + 1;
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::size_t pairsOf(const PlanReview& review) {
  std::size_t pairs = 0;
  for (const PlannedEffect& effect : review.effects) pairs += effect.lookAlikes.size();
  return pairs;
}

void printReview(const char* what, const PlanReview& review) {
  std::printf("  %s: %zu look-alikes\n", what, pairsOf(review));
  for (const auto& group : groupsOf(review)) {
    std::string line;
    for (const std::string& id : group) line += (line.empty() ? "" : ", ") + id;
    std::printf("    {%s}\n", line.c_str());
  }
}

void printGroups(const Protocol& protocol) {
  const Result<Session> session = simulateWithoutNoise(protocol, Truth{}, 1);
  if (!session) return;
  Measurement measurement = measurementOf(*session);
  const auto before = reviewPlan(measurement);
  for (const std::string_view id : constants) addKnown(measurement, id, 0);
  const auto after = reviewPlan(measurement);
  if (!before || !after) return;
  std::printf("%s\n", protocol.name.c_str());
  printReview("nothing known", *before);
  printReview("instrument known", *after);
  std::fflush(stdout);
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

struct Tally {
  int count = 0, stale = 0, otherCause = 0, covers = 0;
  std::vector<double> expanded = {};

  void add(const Diagnosis& diagnosis, std::string_view id, double trueIntersection) {
    if (!diagnosis.measured) return;
    ++count;
    bool isStale = false, isOther = false;
    for (const Cause& cause : diagnosis.causes) {
      const auto& alike = cause.indistinguishableFrom;
      const bool isIt = cause.effect == id || std::ranges::find(alike, id) != alike.end();
      isStale = isStale || (cause.isStale && isIt);
      isOther = isOther || !isIt;
    }
    stale += isStale;
    otherCause += isOther;
    const IntersectionEstimate& measured = diagnosis.measured->estimate;
    covers += std::abs(measured.value - trueIntersection) <= measured.expanded;
    expanded.push_back(measured.expanded);
  }
  void print() const {
    const double percent = 100.0 / std::max(count, 1);
    std::printf("  %5.1f %5.1f %5.1f %6.3f", stale * percent, otherCause * percent, covers * percent,
                median(expanded));
  }
};

/// `hasChanged`: the constant has changed since the record. The record holds all constants in both cases.
void printTrials(const Protocol& protocol, std::string_view id, bool hasChanged, int sessions,
                 std::uint64_t seed) {
  constexpr std::uint64_t stream = 91;
  Tally with, without;
  for (int i = 0; i < sessions; ++i) {
    const auto own = seed + static_cast<std::uint64_t>(i);
    RandomSource random(own, stream);
    Truth truth = drawTruth(own);
    std::map<std::string_view, double> recorded;
    for (const std::string_view constant : constants) {
      bool isFirst = true;
      for (const EffectParameter& parameter : effectById(constant)->parameters) {
        double size = isFirst ? random.normal() * parameter.plausible / 3 : 0;
        if (isFirst) recorded[constant] = size + known * random.normal();
        if (hasChanged && constant == id) size += random.normal() < 0 ? -change : change;
        truth.effects.push_back({parameter.term, size});
        isFirst = false;
      }
    }
    const Result<Session> session = simulate(protocol, truth, own);
    if (!session) continue;
    Measurement measurement = measurementOf(*session);
    if (const auto diagnosis = diagnose(measurement)) without.add(*diagnosis, id, truth.intersection);
    for (const std::string_view constant : constants) addKnown(measurement, constant, recorded[constant]);
    if (const auto diagnosis = diagnose(measurement)) with.add(*diagnosis, id, truth.intersection);
  }
  std::printf("%-15s %-31s %-7s %5d", protocol.name.c_str(), std::string(id).c_str(),
              hasChanged ? "stale" : "right", with.count);
  with.print();
  without.print();
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int sessions = argc > 1 ? std::atoi(argv[1]) : 100;
  const auto seed = argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 1;
  const std::string_view only = argc > 3 ? argv[3] : "";
  for (const Protocol& protocol : namedProtocols())
    if (only.empty() || protocol.name == only) printGroups(protocol);
  if (sessions <= 0) return 0;
  std::printf("\n%-15s %-31s %-7s %5s  %s  %s\n", "plan", "constant", "record", "count",
              "with: stale, other, covers %, U mm", "without: -, other, covers, U");
  for (const Protocol& protocol : namedProtocols()) {
    if (!only.empty() && protocol.name != only) continue;
    for (const std::string_view id : constants)
      for (const bool hasChanged : {false, true}) printTrials(protocol, id, hasChanged, sessions, seed);
  }
  return 0;
}
