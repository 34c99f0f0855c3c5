#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <numbers>
#include <thread>
#include <vector>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/protocol.h"
#include "core/simulation/trial_series.h"

// The share of right answers as a function of the effect's visibility, compared with an ideal observer. The
// observer knows the exact probabilities and sizes of the simulator, which no user can, and weights the kinds
// by their exact evidence. Half of the sessions have no effect, the others one catalogued effect. An answer
// is right if it names that effect or an indistinguishable one, or "none" without an effect.
//
//   alidade_detection_curve [SESSIONS [SEED [THREADS [FROM TO]]]]
//
// With FROM and TO every session has an effect with a visibility in this range, in σ; the observer's prior
// stays the same. After the curve the truths are listed that only one of the two recognised.

namespace {

using namespace alidade;
using Eigen::VectorXd;

constexpr double least = 2, most = 25, mostPlausible = 6;

/// The distribution of truths that the observer assumes.
struct Drawn {
  double from = least, to = most;
  bool alsoNothing = true;
};

bool isHeld(std::string_view kind) {
  return effectById(kind) && kind != relationId;
}

std::vector<std::string> heldKinds() {
  std::vector<std::string> kinds;
  for (const TrialKind& kind : trialKinds())
    if (isHeld(kind.name)) kinds.push_back(kind.name);
  return kinds;
}

BlindTrial trialOf(std::uint64_t seed, const Drawn& drawn) {
  BlindTrialOptions options{.protocol = namedProtocols()[seed / 2 % namedProtocols().size()].name,
                            .leastVisible = drawn.from,
                            .mostVisible = drawn.to,
                            .mostPlausible = mostPlausible};
  const bool nothing = drawn.alsoNothing && seed % 2 == 0;
  options.kinds = nothing ? std::vector<std::string>{"none"} : heldKinds();
  return *drawBlindTrial(options, seed);
}

/// Appends ln of the evidence of the effect in a direction of its parameters (in plausible sizes), for each
/// of the visibilities that the simulator draws.
void addEvidence(std::vector<double>& logs, const Component& component, const VectorXd& direction,
                 const Leftover& leftover) {
  constexpr int steps = 60;
  // The visibility of each size; for a plane tilt it is not proportional to the size.
  constexpr int sizes = 60;
  std::vector<double> shown(sizes + 1, 0);
  for (int i = 1; i <= sizes; ++i)
    shown[static_cast<std::size_t>(i)] =
        component.signature(leftover, direction * (mostPlausible * i / sizes)).norm();
  for (int i = 0; i < steps; ++i) {
    const double target = least + (most - least) * (i + 0.5) / steps;
    const auto above = std::ranges::lower_bound(shown, target) - shown.begin();
    double size = mostPlausible;
    if (above <= sizes) {
      const double low = shown[static_cast<std::size_t>(above - 1)],
                   high = shown[static_cast<std::size_t>(above)];
      size *= (static_cast<double>(above) - 1 + (target - low) / (high - low)) / sizes;
    }
    const VectorXd trace = component.signature(leftover, direction * size);
    logs.push_back(trace.dot(leftover.residual()) - trace.squaredNorm() / 2);
  }
}

double meanOf(const std::vector<double>& logs) {
  const double largest = std::ranges::max(logs);
  double sum = 0;
  for (const double log : logs) sum += std::exp(log - largest);
  return largest + std::log(sum / static_cast<double>(logs.size()));
}

double evidenceOf(const Component& component, const Leftover& leftover) {
  constexpr int directions = 72;
  const bool two = component.weights() == 2;
  std::vector<double> logs;
  for (int i = 0; i < (two ? directions : 2); ++i) {
    const double angle = 2 * std::numbers::pi * i / directions;
    const VectorXd direction = two ? VectorXd(Eigen::Vector2d(std::cos(angle), std::sin(angle)))
                                   : VectorXd(VectorXd::Constant(1, i == 0 ? 1 : -1));
    addEvidence(logs, component, direction, leftover);
  }
  return meanOf(logs);
}

std::string idealAnswer(const Measurement& measurement, bool hasSlider) {
  const GapModel model = *modelOf(measurement);
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options), {});
  std::vector<EffectComponent> components = effectsBeyond(model, leftover, {});
  std::erase_if(components, [&](const EffectComponent& component) {
    return !isHeld(component.id()) || (!hasSlider && component.id().starts_with("slider"));
  });
  const double chance = 1 / static_cast<double>(components.size());
  std::string best = "none";
  double highest = 0;
  for (const EffectComponent& component : components) {
    const double log = evidenceOf(component, leftover) + std::log(chance);
    if (log <= highest) continue;
    highest = log;
    best = component.id();
  }
  return best;
}

struct Row {
  double from, to;
  std::atomic<int> count = 0, product = 0, ideal = 0, worse = 0, better = 0;
};

/// Counts the cases in which only one of program and ideal observer was right.
class Apart {
 public:
  void note(const std::string& what) {
    const std::scoped_lock lock(m_mutex);
    ++m_counts[what];
  }

  void print() const {
    for (const auto& [what, count] : m_counts) std::printf("%4d  %s\n", count, what.c_str());
  }

 private:
  std::mutex m_mutex;
  std::map<std::string, int> m_counts;
};

void take(std::uint64_t seed, const Drawn& drawn, std::vector<Row>& rows, Row& silent, Apart& apart) {
  const BlindTrial trial = trialOf(seed, drawn);
  const Measurement measurement = *examine(trial.session).measurement;
  const bool hasSlider = protocolByName(trial.seal.protocol)->slider;
  const TrialScore score = scoreTrial(trial.seal, *diagnose(measurement));
  const std::string ideal = idealAnswer(measurement, hasSlider);
  const auto isRight = [&](const std::string& answer) {
    return answer == trial.seal.kind ||
           std::ranges::find(trial.seal.lookAlikes, answer) != trial.seal.lookAlikes.end();
  };
  const bool none = trial.seal.kind == "none";
  const bool right = none ? score.right : isRight(score.answer), idealRight = isRight(ideal);
  if (right != idealRight)
    apart.note(right ? "only the diagnosis: " + trial.seal.kind
                     : "only the observer: " + trial.seal.kind + ", the diagnosis answered " + score.answer);
  for (Row& row : rows)
    if (none ? &row == &silent
             : &row != &silent && *trial.seal.visible >= row.from && *trial.seal.visible < row.to) {
      ++row.count;
      row.product += right;
      row.ideal += idealRight;
      row.worse += idealRight && !right;
      row.better += right && !idealRight;
    }
}

void print(const char* name, const Row& row) {
  const double count = std::max(1, row.count.load());
  const double difference = 100 * (row.product - row.ideal) / count;
  const double sigma = 100 * std::sqrt(static_cast<double>(row.worse + row.better)) / count;
  std::printf("%-14s %6d   %6.1f %%   %6.1f %%   %+5.1f +- %.1f\n", name, row.count.load(),
              100 * row.product / count, 100 * row.ideal / count, difference, sigma);
}

}  // namespace

int main(int argc, char** argv) {
  const int sessions = argc > 1 ? std::atoi(argv[1]) : 2000;
  const auto first = argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 1;
  const unsigned threads = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3]))
                                    : std::max(1u, std::thread::hardware_concurrency());
  Drawn drawn;
  if (argc > 5) drawn = {std::atof(argv[4]), std::atof(argv[5]), false};
  constexpr double edges[] = {0, 2, 3, 4, 5, 6, 8, 10, 15, 26};
  std::vector<Row> rows(std::size(edges));
  for (std::size_t i = 0; i + 1 < std::size(edges); ++i) {
    rows[i].from = edges[i];
    rows[i].to = edges[i + 1];
  }
  Row& silent = rows.back();
  std::atomic<int> next = 0;
  Apart apart;
  {
    std::vector<std::jthread> workers;
    for (unsigned t = 0; t < std::max(1u, threads); ++t)
      workers.emplace_back([&] {
        for (int i; (i = next++) < sessions;)
          take(first + static_cast<std::uint64_t>(i), drawn, rows, silent, apart);
      });
  }
  std::printf("%-14s %6s   %8s   %8s   %s\n", "shows by", "trials", "diagnosis", "ideal", "points apart");
  print("nothing there", silent);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "%g to %g σ", rows[i].from, rows[i].to);
    print(name, rows[i]);
  }
  apart.print();
  return 0;
}
