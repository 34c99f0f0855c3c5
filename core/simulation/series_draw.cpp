#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/random_source.h"
#include "core/diagnosis/visibility.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/blind_trial.h"
#include "core/simulation/protocol.h"
#include "core/simulation/series_trial.h"
#include "core/simulation/simulate.h"
#include "core/simulation/truth_text.h"

namespace alidade {

namespace {

constexpr std::uint64_t farApart = 1'000'003;  // distance between the seeds of consecutive series

/// Draws one series, step by step.
class SeriesDraw {
 public:
  explicit SeriesDraw(std::uint64_t seed)
      : m_seed(seed), m_random(seed, stream), m_further(seed, furtherStream) {
    constexpr std::array names{"paper", "paper-slider", "there-and-back", "two-face"};
    m_protocol = protocolByName(names[static_cast<std::size_t>(m_random.whole(0, names.size() - 1))]);
    const auto count = static_cast<std::size_t>(m_random.whole(8, 12));
    for (std::size_t s = 0; s < count; ++s) {
      m_truths.push_back(drawTruth(m_seed * farApart + s));
      m_truths.back().protocol = m_protocol->name;
    }
  }

  Result<SeriesTrial> trial() {
    constexpr double nothing = 0.25, spoiled = 1.0 / 3, foreign = 0.25;
    m_seal.id = std::to_string(m_seed);
    m_seal.protocol = m_protocol->name;
    const bool isEmpty = m_random.uniform() < nothing;
    if (m_further.uniform() < foreign) {
      putUnknown();
      if (!m_seal.visible) return Problem{"nothing of no catalogue shows in series " + m_seal.id};
    } else {
      const Effect* effect = isEmpty ? nullptr : anyEffect();
      layOut(effect ? std::optional(effect->source) : std::nullopt);
      if (effect && !put(*effect)) return Problem{"no effect shows in series " + m_seal.id};
    }
    if (m_random.uniform() < spoiled) spoil();
    SeriesTrial trial{m_seal, {}};
    for (std::size_t s = 0; s < m_truths.size(); ++s) {
      Result<Session> simulated = simulate(*m_protocol, m_truths[s], m_seed * farApart + s);
      if (!simulated) return simulated.problem();
      Session session = *std::move(simulated);
      session.title = "Series " + m_seal.id + ", session " + std::to_string(s + 1);
      session.instrument.serial = m_instruments[s];
      session.device.serial = m_guideways[s];
      trial.sessions.push_back(std::move(session));
    }
    return trial;
  }

 private:
  static constexpr std::uint64_t stream = 5, furtherStream = 6;  // separate from those of single trials
  std::uint64_t m_seed;
  RandomSource m_random, m_further;
  const Protocol* m_protocol = nullptr;
  std::vector<Truth> m_truths;
  std::vector<std::string> m_instruments, m_guideways;
  SeriesSeal m_seal;

  const Effect* anyEffect() {
    const std::vector<const Effect*> effects = soughtEffects();
    while (true) {
      const Effect* effect =
          effects[static_cast<std::size_t>(m_random.whole(0, static_cast<int>(effects.size()) - 1))];
      const bool isShared =
          effect->source == ErrorSource::Instrument || effect->source == ErrorSource::Guideway;
      if (isShared && effect->response == Response::Linear && shows(*effect)) return effect;
    }
  }

  /// True if the plausible size of the effect shows in one session of this plan.
  bool shows(const Effect& effect) const {
    constexpr double least = 1;
    const std::optional<double> visible = visibleIn(0, effect, 0.7);
    return visible && *visible > least;
  }

  std::optional<double> visibleIn(std::size_t s, const Effect& effect, double angle) const {
    Truth truth = m_truths[s];
    setSize(truth, effect, angle, 1);
    const Result<Session> perfect = simulateWithoutNoise(*m_protocol, truth, m_seed * farApart + s);
    if (!perfect) return std::nullopt;
    const auto found = visibilityOf(*examine(*perfect).measurement, std::string(effect.id));
    return found ? std::optional(found->sigma) : std::nullopt;
  }

  static void setSize(Truth& truth, const Effect& effect, double angle, double size) {
    const auto& parameters = effect.parameters;
    const double first = parameters.size() == 1 ? (std::cos(angle) < 0 ? -1 : 1) : std::cos(angle);
    truth.effects.push_back({parameters[0].term, size * first * parameters[0].plausible});
    if (parameters.size() > 1)
      truth.effects.push_back({parameters[1].term, size * std::sin(angle) * parameters[1].plausible});
  }

  /// Assigns an instrument and a guideway to each session.
  void layOut(std::optional<ErrorSource> source) {
    const bool crossed = m_random.uniform() < 0.4;
    const bool ofInstrument = source == ErrorSource::Instrument;
    for (std::size_t s = 0; s < m_truths.size(); ++s) {
      const auto number = [&](std::size_t of) { return std::to_string(s % of + 1); };
      if (crossed) {
        m_instruments.push_back("T-" + number(2));
        m_guideways.push_back("G-" + number(3));
        continue;
      }
      m_instruments.push_back(ofInstrument ? "T-1" : "T-" + number(4));
      m_guideways.push_back(source != ErrorSource::Guideway ? "G-" + std::to_string(s + 1) : "G-1");
    }
    if (!source || source == ErrorSource::Time) return;
    m_seal.owner = ofInstrument ? CauseOwner::Instrument : CauseOwner::Guideway;
    m_seal.serial = ofInstrument ? "T-1" : "G-1";
  }

  /// Adds the effect to all sessions of its owner, sized for the drawn visibility. Returns false if this
  /// visibility needs more than six plausible sizes.
  bool put(const Effect& effect) {
    constexpr double least = 6, most = 10, mostPlausible = 6;
    const double angle = m_random.uniform(0, 2 * std::numbers::pi), target = m_random.uniform(least, most);
    m_seal.kind = effect.id;
    const auto& serials = m_seal.owner == CauseOwner::Instrument ? m_instruments : m_guideways;
    double square = 0;
    for (std::size_t s = 0; s < m_truths.size(); ++s)
      if (serials[s] == m_seal.serial) square += std::pow(visibleIn(s, effect, angle).value_or(0), 2);
    if (!(target < mostPlausible * std::sqrt(square))) return false;
    for (std::size_t s = 0; s < m_truths.size(); ++s)
      if (serials[s] == m_seal.serial) setSize(m_truths[s], effect, angle, target / std::sqrt(square));
    m_seal.visible = target;
    return true;
  }

  /// The owner of an uncatalogued disturbance.
  static ErrorSource sourceOf(const Truth& truth) {
    using enum ForeignEffect::Kind;
    if (!truth.foreign) return ErrorSource::Guideway;
    switch (truth.foreign->kind) {
      case LocalDent:
      case HighWarp:
        return ErrorSource::Guideway;
      case CirclePeriods:
      case Refraction:
      case Backlash:
        return ErrorSource::Instrument;
      case Settling:
      case DistanceRamp:
        break;
    }
    return ErrorSource::Time;
  }

  /// Adds an uncatalogued disturbance to all sessions of its owner; a disturbance of time is the same in all
  /// sessions. Without noise, its visibility and its distance from the nearest catalogued effect are
  /// proportional to its size. Without a suitable size, `m_seal.visible` stays absent.
  void putUnknown() {
    constexpr double least = 8, most = 16, beyond = 6, mostSize = 300;
    Truth drawn = m_truths.front();
    putForeign(drawn, m_further);
    const ErrorSource source = sourceOf(drawn);
    layOut(source);
    const auto has = [&](std::size_t s) {
      if (m_seal.owner == CauseOwner::Time) return true;
      return (m_seal.owner == CauseOwner::Instrument ? m_instruments : m_guideways)[s] == m_seal.serial;
    };
    double square = 0, nearest = 0;
    for (std::size_t s = 0; s < m_truths.size(); ++s) {
      if (!has(s)) continue;
      m_truths[s].foreign = drawn.foreign;
      m_truths[s].harmonic = drawn.harmonic;
      const std::optional<Visibility> shown = shownIn(s);
      square += std::pow(shown ? shown->sigma : 0, 2);
      nearest += std::pow(shown ? shown->nearest : 0, 2);
    }
    const double target = m_further.uniform(least, most);
    const double size = (m_further.uniform() < 0.5 ? -1 : 1) * target / std::max(std::sqrt(square), 1e-9);
    if (std::abs(size) > mostSize || std::abs(size) * std::sqrt(nearest) < beyond) return;
    for (std::size_t s = 0; s < m_truths.size(); ++s)
      if (has(s)) setForeignSize(m_truths[s], size);
    m_seal.kind = kindOf(m_truths[firstWith(has)]);
    m_seal.visible = target;
  }

  template <typename Has>
  std::size_t firstWith(const Has& has) const {
    std::size_t s = 0;
    while (!has(s)) ++s;
    return s;
  }

  std::optional<Visibility> shownIn(std::size_t s) const {
    const Result<Session> perfect = simulateWithoutNoise(*m_protocol, m_truths[s], m_seed * farApart + s);
    if (!perfect) return std::nullopt;
    const auto found = visibilityOf(*examine(*perfect).measurement, {});
    return found ? std::optional(*found) : std::nullopt;
  }

  /// Adds an obvious jump, or larger scatter of the whole session.
  void spoilFurther(Truth& truth) {
    const auto step = [&] {
      return Angle::fromArcseconds((m_further.uniform() < 0.5 ? -1 : 1) * m_further.uniform(60, 600));
    };
    if (m_further.uniform() < 0.5) {
      truth.noiseFactor = m_further.uniform(2, 5);
      m_seal.spoiledBy = noiseId;
      return;
    }
    truth.jump = {.moment = m_further.uniform(0.1, 0.9), .horizontal = step(), .vertical = step()};
    m_seal.spoiledBy = jumpId;
  }

  void spoil() {
    const auto s = static_cast<std::size_t>(m_random.whole(0, static_cast<int>(m_truths.size()) - 1));
    m_seal.spoiled = s;
    if (m_further.uniform() < 0.5) return spoilFurther(m_truths[s]);
    const double sign = m_random.uniform() < 0.5 ? -1 : 1;
    const int way = m_random.whole(0, 2);
    if (way == 0) {
      const std::vector<PlannedRow> rows = plannedRows(*m_protocol);
      const PlannedRow& row = rows[rows.size() / 2];
      m_truths[s].grossErrors = {{.axisDeg = 0,
                                  .round = row.round,
                                  .point = row.point,
                                  .face = row.face,
                                  .horizontal = Angle::fromArcseconds(sign * m_random.uniform(60, 300)),
                                  .vertical = {}}};
      m_seal.spoiledBy = grossErrorId;
    } else if (way == 1) {
      m_truths[s].jump = {.moment = m_random.uniform(0.2, 0.8),
                          .horizontal = Angle::fromArcseconds(sign * m_random.uniform(30, 60)),
                          .vertical = Angle::fromArcseconds(m_random.uniform(30, 60))};
      m_seal.spoiledBy = jumpId;
    } else {
      spoilByEffect(s);
    }
  }

  /// Adds an effect other than the shared one, visible by 12 σ in this session.
  void spoilByEffect(std::size_t s) {
    constexpr double visible = 12, mostPlausible = 8;
    for (int tries = 0; tries < 50; ++tries) {
      const Effect* effect = anyEffect();
      const double angle = m_random.uniform(0, 2 * std::numbers::pi);
      const double one = visibleIn(s, *effect, angle).value_or(0);
      if (effect->id == m_seal.kind || !(visible < mostPlausible * one)) continue;
      // The truth still contains the shared effect, with which `visibleIn` found the visibility `one`.
      Truth clean = m_truths[s];
      setSize(clean, *effect, angle, visible / std::max(one, 1e-9));
      m_truths[s] = clean;
      m_seal.spoiledBy = effect->id;
      return;
    }
    m_seal.spoiled.reset();
  }
};

}  // namespace

Result<SeriesTrial> drawSeriesTrial(std::uint64_t seed) {
  constexpr std::uint64_t again = 1'000'000'007;  // added to the seed if a plan cannot show what was drawn
  constexpr int tries = 20;
  for (std::uint64_t i = 0;; ++i) {
    Result<SeriesTrial> drawn = SeriesDraw(seed + i * again).trial();
    if (!drawn && i < tries) continue;
    if (!drawn) return drawn.problem();
    SeriesTrial trial = *std::move(drawn);
    trial.seal.id = std::to_string(seed);
    return trial;
  }
}

}  // namespace alidade
