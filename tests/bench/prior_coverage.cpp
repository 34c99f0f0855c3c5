#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/base/random_source.h"
#include "core/diagnosis/candidates/candidates.h"
#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/gross_error_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/trial_series.h"
#include "core/simulation/trial_summary.h"

// How often Δd ± U covers the true Δd after the causes named by a diagnosis are added. Effects, a jump,
// larger noise and a misreading are drawn independently by the prior odds of the diagnosis; their sizes are
// normal with equally probable widths. Stated coverage 95 %.
//
//   alidade_prior_coverage [SESSIONS [SEED [THREADS]]]

namespace {

using namespace alidade;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : m_seed(seed), m_random(seed, stream), m_truth(drawTruth(seed)) {}

  Result<TrialCase> trial() {
    const auto protocols = namedProtocols();
    const Protocol& protocol = protocols[anyOf(protocols.size())];
    putEffects(protocol);
    if (isThere(m_odds.jump))
      putJump();
    else if (isThere(m_odds.wrongZero))
      putWrongZero();
    m_truth.noiseFactor = isThere(m_odds.noise) ? std::exp(m_random.uniform(std::log(1.25), std::log(20.0)))
                                                : std::exp(0.1 * m_random.normal());
    if (isThere(m_odds.grossError)) putMisreading(protocol);
    const Result<Session> session = simulate(protocol, m_truth, m_seed);
    if (!session) return session.problem();
    return TrialCase{*session,
                     {.id = std::to_string(m_seed), .kind = "none", .intersection = m_truth.intersection}};
  }

 private:
  static constexpr std::uint64_t stream = 77;  // separate from those of guideway and noise
  std::uint64_t m_seed;
  RandomSource m_random;
  Truth m_truth;
  PriorOdds m_odds;

  std::size_t anyOf(std::size_t count) {
    return static_cast<std::size_t>(m_random.whole(0, static_cast<int>(count) - 1));
  }
  bool isThere(double odds) { return m_random.uniform() < odds / (1 + odds); }
  double anyOf(const std::vector<Width>& widths) { return widths[anyOf(widths.size())].sigma; }

  void putEffects(const Protocol& protocol) {
    for (const Effect& effect : effectCatalogue()) {
      if ((!protocol.slider && effect.id.starts_with("slider")) || !isThere(m_odds.effect)) continue;
      const double size = anyOf(effectWidths());
      for (const EffectParameter& parameter : effect.parameters)
        m_truth.effects.push_back({parameter.term, effect.response == Response::AllOrNothing
                                                       ? 1
                                                       : size * m_random.normal() * parameter.plausible});
    }
  }

  void putJump() {
    const double size = anyOf(jumpWidths()) * plausibleJump;
    m_truth.jump = {.moment = m_random.uniform(0, 1),
                    .horizontal = Angle::fromRadians(size * m_random.normal()),
                    .vertical = Angle::fromRadians(size * m_random.normal())};
  }

  void putWrongZero() {
    const double size = anyOf(jumpWidths()) * plausibleJump;
    m_truth.wrongZero = {.axisDeg = m_random.uniform() < 0.5 ? 0 : 180,
                         .horizontal = Angle::fromRadians(size * m_random.normal()),
                         .vertical = Angle::fromRadians(size * m_random.normal())};
  }

  void putMisreading(const Protocol& protocol) {
    const std::vector<PlannedRow> rows = plannedRows(protocol);
    const PlannedRow& row = rows[anyOf(rows.size())];
    const Angle error = m_truth.sigmaHorizontal * (anyOf(grossErrorWidths()) * m_random.normal());
    const bool isHorizontal = m_random.uniform() < 0.5;
    m_truth.grossErrors.push_back({.axisDeg = m_random.uniform() < 0.5 ? 0 : 180,
                                   .round = row.round,
                                   .point = row.point,
                                   .face = row.face,
                                   .horizontal = isHorizontal ? error : Angle(),
                                   .vertical = isHorizontal ? Angle() : error});
  }
};

}  // namespace

int main(int argc, char** argv) {
  TrialSeriesOptions options;
  options.count = argc > 1 ? static_cast<std::size_t>(std::atoll(argv[1])) : 3000;
  const auto seed = argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 1;
  if (argc > 3) options.threads = static_cast<unsigned>(std::atoi(argv[3]));
  const auto trials = scoreTrials(options, [&](std::size_t i) { return Draw(seed + i).trial(); });
  if (!trials) {
    std::fprintf(stderr, "%s\n", trials.problem().text().c_str());
    return 1;
  }
  const Tally covered = summarise(*trials).covered;
  const double count = static_cast<double>(std::max<std::size_t>(covered.count, 1));
  const double share = static_cast<double>(covered.hits) / count;
  std::printf("of %zu sessions that name a cause %.2f %% are covered, +- %.2f\n", covered.count, 100 * share,
              100 * std::sqrt(share * (1 - share) / count));
  return 0;
}
