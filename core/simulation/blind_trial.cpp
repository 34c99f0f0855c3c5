#include "core/simulation/blind_trial.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/random_source.h"
#include "core/base/utf8.h"
#include "core/effects/catalogue.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade {

namespace {

constexpr const char* relationId = "vertical_angle_relation";

bool isOfSlider(const Effect& effect) {
  return std::ranges::any_of(effect.parameters, [](const EffectParameter& parameter) {
    return parameter.term == ErrorTerm::SliderScale || parameter.term == ErrorTerm::SliderSine ||
           parameter.term == ErrorTerm::SliderCosine;
  });
}

/// Draws one trial, step by step.
class Draw {
 public:
  Draw(const BlindTrialOptions& options, const Protocol& protocol, std::uint64_t seed, RandomSource random)
      : m_options(options), m_protocol(protocol), m_seed(seed), m_random(random), m_truth(drawTruth(seed)) {
    m_truth.protocol = protocol.name;
  }

  Result<BlindTrial> trial(const std::string& kind) {
    put(kind);
    Result<Session> session = simulate(m_protocol, m_truth, m_seed);
    if (!session) return session.problem();
    BlindTrial trial{*std::move(session), m_truth, sealed(std::to_string(m_seed), m_truth, visibility(kind))};
    trial.session.title = "Blind trial " + std::to_string(m_seed);
    return trial;
  }

 private:
  const BlindTrialOptions& m_options;
  const Protocol& m_protocol;
  std::uint64_t m_seed;
  RandomSource m_random;
  Truth m_truth;

  void put(const std::string& kind) {
    if (kind == "none") return;
    if (kind == "gross_error") return putMisreadings();
    if (kind == "orientation_jump") return putJump();
    if (kind == "underestimated_noise") {
      m_truth.noiseFactor = m_random.uniform(2, 4);
      return;
    }
    if (kind == "unknown") return putUnknown();
    if (kind == "two_causes") return putTwo();
    putEffect(*effectById(kind));
  }

  double sign() { return m_random.uniform() < 0.5 ? -1 : 1; }

  const PlannedRow& anyRow(const std::vector<PlannedRow>& rows) {
    return rows[static_cast<std::size_t>(m_random.whole(0, static_cast<int>(rows.size()) - 1))];
  }

  /// One or two readings, off by a slip of the tens or the minutes.
  void putMisreadings() {
    constexpr double slips[] = {30, 60, 120, 300};  // arcseconds
    const std::vector<PlannedRow> rows = plannedRows(m_protocol);
    const int count = m_random.whole(1, 2);
    while (static_cast<int>(m_truth.misreadings.size()) < count) {
      const PlannedRow row = anyRow(rows);
      const int axis = m_protocol.axes[static_cast<std::size_t>(
          m_random.whole(0, static_cast<int>(m_protocol.axes.size()) - 1))];
      const Angle slip = Angle::fromArcseconds(sign() * slips[m_random.whole(0, 3)]);
      const bool horizontal = m_random.uniform() < 0.5;
      const bool again = std::ranges::any_of(m_truth.misreadings, [&](const Misreading& m) {
        return m.axisDeg == axis && PlannedRow{m.round, m.point, m.face} == row;
      });
      if (again) continue;
      m_truth.misreadings.push_back({.axisDeg = axis,
                                     .round = row.round,
                                     .point = row.point,
                                     .face = row.face,
                                     .horizontal = horizontal ? slip : Angle(),
                                     .vertical = horizontal ? Angle() : slip});
    }
  }

  void putJump() {
    const auto step = [&] { return Angle::fromArcseconds(sign() * m_random.uniform(20, 60)); };
    m_truth.jump = {.moment = m_random.uniform(0.15, 0.85), .horizontal = step(), .vertical = step()};
  }

  void putUnknown() {
    const auto amplitude = [&] { return m_random.uniform(0.1, 0.2); };  // mm
    m_truth.harmonic = {.order = m_random.whole(6, 8), .cosine = amplitude(), .sine = amplitude()};
  }

  void putTwo() {
    const Effect& first = anyEffect();
    putEffect(first);
    std::vector<TrueSize> sizes = std::move(m_truth.effects);
    const Effect* second = &anyEffect();
    while (second == &first) second = &anyEffect();
    m_truth.effects.clear();
    putEffect(*second);
    m_truth.effects.insert(m_truth.effects.begin(), sizes.begin(), sizes.end());
  }

  /// Of the catalogue, that the protocol can show at all.
  const Effect& anyEffect() {
    const auto effects = effectCatalogue();
    while (true) {
      const Effect& effect =
          effects[static_cast<std::size_t>(m_random.whole(0, static_cast<int>(effects.size()) - 1))];
      if (effect.id != relationId && (m_protocol.slider || !isOfSlider(effect))) return effect;
    }
  }

  /// In a random direction, as large as makes it visible by what is drawn.
  void putEffect(const Effect& effect) {
    if (effect.id == relationId) {
      m_truth.effects = {{effect.parameters.front().term, 1}};
      return;
    }
    const double angle = m_random.uniform(0, 2 * std::numbers::pi);
    const double target = m_random.uniform(m_options.leastVisible, m_options.mostVisible);
    double size = std::min(1.0, m_options.mostPlausible);  // plausible sizes
    double lastSize = 0, lastShown = 0;
    for (int step = 0; step < 6; ++step) {
      setSize(effect, angle, size);
      const std::optional<Visibility> visible = visibility(std::string(effect.id));
      if (!visible) return;
      const double shown = std::max(visible->sigma, 1e-9);
      if (std::abs(shown / target - 1) < 0.002) break;
      // What shows grows with the size, that of a plane tilt with up to its square.
      const double power = step > 0 && size != lastSize
                               ? std::clamp(std::log(shown / lastShown) / std::log(size / lastSize), 1.0, 2.0)
                               : 1;
      lastSize = size;
      lastShown = shown;
      size = std::min(m_options.mostPlausible, size * std::pow(target / shown, 1 / power));
    }
    setSize(effect, angle, size);
  }

  void setSize(const Effect& effect, double angle, double size) {
    m_truth.effects.clear();
    const auto& parameters = effect.parameters;
    if (parameters.size() == 1) {
      m_truth.effects = {
          {parameters[0].term, (std::cos(angle) < 0 ? -size : size) * parameters[0].plausible}};
      return;
    }
    m_truth.effects = {{parameters[0].term, size * std::cos(angle) * parameters[0].plausible},
                       {parameters[1].term, size * std::sin(angle) * parameters[1].plausible}};
  }

  /// Of an effect of the catalogue that is alone.
  std::optional<Visibility> visibility(const std::string& kind) const {
    if (!effectById(kind) || kind == relationId) return std::nullopt;
    const Result<Session> perfect = simulateWithoutNoise(m_protocol, m_truth, m_seed);
    if (!perfect) return std::nullopt;
    const Result<Visibility> found = visibilityOf(*examine(*perfect).measurement, kind);
    return found ? std::optional(*found) : std::nullopt;
  }
};

std::vector<TrialKind> makeKinds() {
  std::vector<TrialKind> kinds{{"none", 0.14},     {"gross_error", 0.08},          {"orientation_jump", 0.05},
                               {relationId, 0.03}, {"underestimated_noise", 0.05}, {"two_causes", 0.05},
                               {"unknown", 0.08}};
  double rest = 1;
  for (const TrialKind& kind : kinds) rest -= kind.weight;
  const double others = static_cast<double>(effectCatalogue().size()) - 1;
  for (const Effect& effect : effectCatalogue())
    if (effect.id != relationId) kinds.push_back({std::string(effect.id), rest / others});
  return kinds;
}

const std::string& anyKind(const std::vector<TrialKind>& kinds, double share) {
  double sum = 0;
  for (const TrialKind& kind : kinds) sum += kind.weight;
  double reached = 0;
  for (const TrialKind& kind : kinds)
    if ((reached += kind.weight / sum) >= share) return kind.name;
  return kinds.back().name;
}

/// Those asked for, without what the protocol cannot show.
std::vector<TrialKind> kindsOf(const BlindTrialOptions& options, const Protocol& protocol) {
  std::vector<TrialKind> kinds;
  for (const TrialKind& kind : trialKinds()) {
    const Effect* effect = effectById(kind.name);
    if (effect && isOfSlider(*effect) && !protocol.slider) continue;
    if (options.kinds.empty())
      kinds.push_back(kind);
    else if (std::ranges::find(options.kinds, kind.name) != options.kinds.end())
      kinds.push_back({kind.name, 1});
  }
  return kinds;
}

}  // namespace

const std::vector<TrialKind>& trialKinds() {
  static const std::vector<TrialKind> kinds = makeKinds();
  return kinds;
}

Result<BlindTrial> drawBlindTrial(const BlindTrialOptions& options, std::uint64_t seed) {
  // A stream of its own, apart from those of the guideway and the noise.
  constexpr std::uint64_t stream = 2;
  RandomSource random(seed, stream);
  const auto protocols = namedProtocols();
  const Protocol* protocol =
      options.protocol.empty()
          ? &protocols[static_cast<std::size_t>(random.whole(0, static_cast<int>(protocols.size()) - 1))]
          : protocolByName(options.protocol);
  if (!protocol) return Problem{"there is no protocol " + quotation(options.protocol)};
  for (const std::string& kind : options.kinds)
    if (std::ranges::find(trialKinds(), kind, &TrialKind::name) == trialKinds().end())
      return Problem{"there is no kind of trial " + quotation(kind)};
  const std::vector<TrialKind> kinds = kindsOf(options, *protocol);
  if (kinds.empty()) return Problem{"protocol " + protocol->name + " shows none of the kinds asked for"};
  const std::string& kind = anyKind(kinds, random.uniform());
  return Draw(options, *protocol, seed, random).trial(kind);
}

}  // namespace alidade
