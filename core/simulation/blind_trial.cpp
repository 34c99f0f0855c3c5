#include "core/simulation/blind_trial.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "core/base/random_source.h"
#include "core/base/visible_text.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/trial_score.h"

namespace alidade {

namespace {

/// The effect of the catalogue or the user's own effect; null if there is none.
const Effect* effectIn(const BlindTrialOptions& options, const std::string& kind) {
  const Effect* effect = effectById(kind);
  return !effect && options.own ? options.own->find(kind) : effect;
}

/// Draws one trial, step by step.
class Draw {
 public:
  Draw(const BlindTrialOptions& options, const Protocol& protocol, std::uint64_t seed, RandomSource random)
      : m_options(options), m_protocol(protocol), m_seed(seed), m_random(random), m_truth(drawTruth(seed)) {
    m_truth.protocol = protocol.name;
    m_truth.own = options.own;
  }

  Result<BlindTrial> trial(const std::string& kind) {
    put(kind);
    mayStateReference();
    Result<Session> session = simulate(m_protocol, m_truth, m_seed);
    if (!session) return session.problem();
    BlindTrial trial{*std::move(session), m_truth, sealed(std::to_string(m_seed), m_truth, visibility(kind))};
    stateOwn(trial.session);
    trial.seal.statesOwn = trial.seal.kind.starts_with(ownPrefix);
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
    if (kind == grossErrorId) return putGrossErrors();
    if (kind == jumpId) return m_random.uniform() < 0.5 ? putJump() : putWrongZero();
    if (kind == noiseId) {
      m_truth.noiseFactor = m_random.uniform(2, 4);
      return;
    }
    if (kind == "unknown") return putUnknown();
    if (kind == "two_causes") return putTwo();
    putEffect(*effectIn(m_options, kind));
  }

  double sign() { return m_random.uniform() < 0.5 ? -1 : 1; }

  const PlannedRow& anyRow(const std::vector<PlannedRow>& rows) {
    return rows[static_cast<std::size_t>(m_random.whole(0, static_cast<int>(rows.size()) - 1))];
  }

  NumberedPosition anyPosition() {
    const std::vector<int>& axes = m_protocol.axes;
    const auto own = axes.begin() + m_random.whole(0, static_cast<int>(axes.size()) - 1);
    return {*own, static_cast<int>(std::count(axes.begin(), own + 1, *own))};
  }

  /// Misreads one or two readings by 30″ to 5′. Errors are drawn until each is detectable: an error along the
  /// arc may be undetectable.
  void putGrossErrors() {
    constexpr int tries = 200;
    const std::vector<PlannedRow> rows = plannedRows(m_protocol);
    const auto count = static_cast<std::size_t>(m_random.whole(1, 2));
    std::vector<TrueGrossError> errors;
    for (int i = 0; i < tries && errors.size() < count; ++i) {
      m_truth.grossErrors = {anyGrossError(rows)};
      const TrueGrossError& one = m_truth.grossErrors.front();
      const bool again = std::ranges::any_of(errors, [&](const TrueGrossError& m) {
        return std::tie(m.axisDeg, m.repeat, m.round, m.point) ==
               std::tie(one.axisDeg, one.repeat, one.round, one.point);
      });
      const std::optional<Visibility> shown = shownAs({});
      if (!again && shown && shown->sigma > clearVisibility) errors.push_back(one);
    }
    m_truth.grossErrors = std::move(errors);
  }

  TrueGrossError anyGrossError(const std::vector<PlannedRow>& rows) {
    constexpr double amounts[] = {30, 60, 120, 300};  // arcseconds
    const PlannedRow& row = anyRow(rows);
    const NumberedPosition position = anyPosition();
    const Angle error = Angle::fromArcseconds(sign() * amounts[m_random.whole(0, 3)]);
    const bool horizontal = m_random.uniform() < 0.5;
    return {.axisDeg = position.axisDeg,
            .round = row.round,
            .point = row.point,
            .face = row.face,
            .horizontal = horizontal ? error : Angle(),
            .vertical = horizontal ? Angle() : error,
            .repeat = position.repeat};
  }

  void putJump() {
    const auto step = [&] { return Angle::fromArcseconds(sign() * m_random.uniform(20, 60)); };
    m_truth.jump = {.moment = m_random.uniform(0.15, 0.85), .horizontal = step(), .vertical = step()};
  }

  /// Misreads a pointing zero in both circles. The closures hardly show the vertical error.
  void putWrongZero() {
    const NumberedPosition position = anyPosition();
    const double horizontal = sign() * m_random.uniform(20, 60), ratio = sign() * m_random.uniform(0.7, 1.4);
    m_truth.wrongZero = {.axisDeg = position.axisDeg,
                         .horizontal = Angle::fromArcseconds(horizontal),
                         .vertical = Angle::fromArcseconds(ratio * horizontal),
                         .repeat = position.repeat};
  }

  /// Lets a quarter of the sessions state their true Δd as a reference, with an error of `sigma`.
  void mayStateReference() {
    constexpr double share = 0.25, sigma = 0.02;  // mm
    if (m_random.uniform() < share) m_truth.sigmaReference = sigma;
  }

  /// Adds an uncatalogued disturbance, well separated from every catalogued effect. A radius harmonic is as
  /// frequent as any other kind.
  void putUnknown() {
    constexpr int tries = 30;
    constexpr double mostSize = 300;  // mm or arcsec: larger than any detectable disturbance needs
    constexpr double farther = 1.6;
    for (int i = 0; i < tries; ++i) {
      putForeign(m_truth, m_random);
      const double target = farther * m_random.uniform(m_options.leastVisible, m_options.mostVisible);
      const double sign = this->sign();
      scale(target, mostSize,
            [&](double size) { setForeignSize(m_truth, m_truth.harmonic ? size : sign * size); });
      const std::optional<Visibility> shown = shownAs({});
      if (shown && shown->sigma > 0.9 * target && shown->nearest > clearVisibility) return;
    }
  }

  /// Adds two effects that can be distinguished from all others, if the protocol allows it.
  void putTwo() {
    constexpr int tries = 30;
    std::vector<TrueSize> sizes;
    const Effect* first = nullptr;
    for (int i = 0; i < tries && sizes.size() < 4; ++i) {
      const Effect& effect = anyEffect();
      if (&effect == first) continue;
      putEffect(effect);
      const std::optional<Visibility> shown = shownAs(std::string(effect.id));
      const bool last = i + 3 >= tries;  // the last three tries accept any effect
      if (!last && (!shown || shown->sigma < clearVisibility || !shown->lookAlikes.empty())) continue;
      sizes.insert(sizes.end(), m_truth.effects.begin(), m_truth.effects.end());
      if (first) break;
      first = &effect;
    }
    m_truth.effects = std::move(sizes);
  }

  /// A catalogued effect that the protocol can show.
  const Effect& anyEffect() {
    const std::vector<const Effect*> effects = soughtEffects();
    while (true) {
      const Effect& effect =
          *effects[static_cast<std::size_t>(m_random.whole(0, static_cast<int>(effects.size()) - 1))];
      if (effect.response != Response::AllOrNothing && (m_protocol.slider || !needsSlider(effect)))
        return effect;
    }
  }

  /// Adds the effect in a random direction, sized for the drawn visibility.
  void putEffect(const Effect& effect) {
    if (effect.response == Response::AllOrNothing) {
      m_truth.effects = {{effect.parameters.front().term, 1}};
      return;
    }
    const std::vector<double> direction = anyDirection(effect.parameters.size());
    const double target = m_random.uniform(m_options.leastVisible, m_options.mostVisible);
    scale(target, m_options.mostPlausible, [&](double size) { setSize(effect, direction, size); });
  }

  /// Calls `set` with sizes up to `most` until the truth is visible by `target` σ.
  template <typename Set>
  void scale(double target, double most, const Set& set) {
    double size = std::min(1.0, most), lastSize = 0, lastShown = 0;
    for (int step = 0; step < 6; ++step) {
      set(size);
      const std::optional<Visibility> visible = shownAs({});
      if (!visible) return;
      const double shown = std::max(visible->sigma, 1e-9);
      if (std::abs(shown / target - 1) < 0.002) return;
      // Visibility is proportional to the size, for a plane tilt up to its square.
      const double power = step > 0 && size != lastSize
                               ? std::clamp(std::log(shown / lastShown) / std::log(size / lastSize), 1.0, 2.0)
                               : 1;
      lastSize = size;
      lastShown = shown;
      size = std::min(most, size * std::pow(target / shown, 1 / power));
    }
    set(size);
  }

  /// A random unit vector.
  std::vector<double> anyDirection(std::size_t count) {
    const double angle = m_random.uniform(0, 2 * std::numbers::pi);
    if (count == 1) return {std::cos(angle) < 0 ? -1.0 : 1.0};
    std::vector<double> direction{std::cos(angle), std::sin(angle)};
    while (direction.size() < count) direction.push_back(m_random.normal());
    double square = 0;
    for (const double part : direction) square += part * part;
    for (double& part : direction) part /= std::sqrt(square);
    return direction;
  }

  void setSize(const Effect& effect, const std::vector<double>& direction, double size) {
    m_truth.effects.clear();
    for (std::size_t i = 0; i < direction.size(); ++i)
      m_truth.effects.push_back(
          {effect.parameters[i].term, size * direction[i] * effect.parameters[i].plausible});
  }

  void stateOwn(Session& session) const {
    if (!m_options.own) return;
    for (const OwnEntry& entry : m_options.own->entries()) session.ownEffects.push_back(entry.source);
  }

  /// The visibility of the present truth, and the look-alikes of the effect `held`.
  std::optional<Visibility> shownAs(const std::string& held) const {
    Result<Session> simulated = simulateWithoutNoise(m_protocol, m_truth, m_seed);
    if (!simulated) return std::nullopt;
    Session perfect = *std::move(simulated);
    stateOwn(perfect);
    const auto found = visibilityOf(*examine(perfect).measurement, held);
    return found ? std::optional(*found) : std::nullopt;
  }

  /// The visibility of an effect, or of a wrong zero; absent for other kinds.
  std::optional<Visibility> visibility(const std::string& kind) const {
    const bool isAlone = effectIn(m_options, kind) || m_truth.wrongZero;
    return isAlone && kind != relationId ? shownAs(kind) : std::nullopt;
  }
};

std::vector<TrialKind> makeKinds() {
  std::vector<TrialKind> kinds{{"none", 0.14},  {grossErrorId, 0.08}, {jumpId, 0.05},   {relationId, 0.03},
                               {noiseId, 0.05}, {"two_causes", 0.05}, {"unknown", 0.08}};
  double rest = 1;
  for (const TrialKind& kind : kinds) rest -= kind.weight;
  const std::vector<const Effect*> effects = soughtEffects();
  const double others = static_cast<double>(effects.size()) - 1;
  for (const Effect* effect : effects)
    if (effect->id != relationId) kinds.push_back({std::string(effect->id), rest / others});
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

/// In one face and without slider hardly any two effects are distinguishable.
bool separatesCauses(const Protocol& protocol) {
  return protocol.slider || protocol.faces != FacePlan::FaceOne;
}

/// All kinds; the user's own effects are last, each with the weight of a catalogued effect.
std::vector<TrialKind> kindsWith(const OwnEffects* own) {
  std::vector<TrialKind> kinds = trialKinds();
  const double weight = kinds.back().weight;
  if (own)
    for (const OwnEntry& entry : own->entries()) kinds.push_back({entry.id, weight});
  return kinds;
}

bool isOfSliderOnly(const Formula& formula) {
  return std::ranges::all_of(formula.lines,
                             [](const FormulaLine& line) { return line.carrier == FormCarrier::Slider; });
}

bool needsSlider(const BlindTrialOptions& options, const std::string& kind) {
  if (const Effect* effect = effectById(kind)) return needsSlider(*effect);
  return options.own && std::ranges::any_of(options.own->entries(), [&](const OwnEntry& entry) {
           return entry.id == kind && isOfSliderOnly(entry.formula);
         });
}

/// The requested kinds that the protocol can show.
std::vector<TrialKind> kindsOf(const BlindTrialOptions& options, const Protocol& protocol) {
  std::vector<TrialKind> kinds;
  for (const TrialKind& kind : kindsWith(options.own.get())) {
    if (needsSlider(options, kind.name) && !protocol.slider) continue;
    if (kind.name == "two_causes" && !separatesCauses(protocol)) continue;
    if (options.kinds.empty())
      kinds.push_back(kind);
    else if (std::ranges::find(options.kinds, kind.name) != options.kinds.end())
      kinds.push_back({kind.name, 1});
  }
  return kinds;
}

}  // namespace

void putForeign(Truth& truth, RandomSource& random) {
  using Kind = ForeignEffect::Kind;
  truth.harmonic.reset();
  truth.foreign.reset();
  const auto kinds = foreignEffectNames();
  const auto kind = static_cast<std::size_t>(random.whole(0, static_cast<int>(kinds.size())));
  const double phase = random.uniform(0, 360);
  if (kind == kinds.size()) {
    const double angle = Angle::fromDegrees(phase).radians();
    truth.harmonic = {.order = random.whole(4, 9), .cosine = std::cos(angle), .sine = std::sin(angle)};
    return;
  }
  ForeignEffect foreign{.kind = kinds[kind].kind, .size = 1, .first = 0, .second = phase};
  if (foreign.kind == Kind::LocalDent) {
    foreign.first = random.uniform(20, 160);
    foreign.second = random.uniform(6, 20);
  }
  if (foreign.kind == Kind::CirclePeriods) foreign.first = 2 * random.whole(4, 12);
  if (foreign.kind == Kind::Settling) foreign.first = random.uniform(0.05, 0.3);
  if (foreign.kind == Kind::HighWarp) foreign.first = random.whole(3, 7);
  truth.foreign = foreign;
}

void setForeignSize(Truth& truth, double size) {
  if (truth.foreign) truth.foreign->size = size;
  if (!truth.harmonic) return;
  const double phase = std::atan2(truth.harmonic->sine, truth.harmonic->cosine);
  truth.harmonic = {truth.harmonic->order, size * std::cos(phase), size * std::sin(phase)};
}

const std::vector<TrialKind>& trialKinds() {
  static const std::vector<TrialKind> kinds = makeKinds();
  return kinds;
}

Result<BlindTrial> drawBlindTrial(const BlindTrialOptions& options, std::uint64_t seed) {
  // A separate stream from those of the guideway and the noise.
  constexpr std::uint64_t stream = 2;
  RandomSource random(seed, stream);
  const auto protocols = namedProtocols();
  const Protocol* protocol =
      options.protocol.empty()
          ? &protocols[static_cast<std::size_t>(random.whole(0, static_cast<int>(protocols.size()) - 1))]
          : protocolByName(options.protocol);
  if (!protocol) return Problem{"there is no protocol " + quotation(options.protocol)};
  const std::vector<TrialKind> all = kindsWith(options.own.get());
  for (const std::string& kind : options.kinds)
    if (std::ranges::find(all, kind, &TrialKind::name) == all.end())
      return Problem{"there is no kind of trial " + quotation(kind)};
  const std::vector<TrialKind> kinds = kindsOf(options, *protocol);
  if (kinds.empty()) return Problem{"protocol " + protocol->name + " shows none of the kinds asked for"};
  const std::string& kind = anyKind(kinds, random.uniform());
  return Draw(options, *protocol, seed, random).trial(kind);
}

}  // namespace alidade
