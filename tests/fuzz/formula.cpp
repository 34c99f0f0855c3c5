#include <cmath>
#include <ctime>

#include "core/observation/own_model.h"
#include "core/session/own_effect.h"
#include "core/session/session_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

namespace {

void requireFinite(std::span<const OwnShare> shares) {
  for (const OwnShare& share : shares)
    for (const double value : {share.value, share.byArcAngle, share.byA, share.byE})
      require(std::isfinite(value), "a share that is no number");
}

/// The influence of a formula on the readings is finite everywhere.
void evaluate(const OwnEffect& effect) {
  std::vector<Problem> problems;
  const auto effects = examineOwnEffects({effect}, problems);
  require((effects != nullptr) == problems.empty(), "an effect neither taken nor refused");
  if (!effects) return;
  const OwnModel model(effects);
  for (const double s : {0.0, 0.5, 1.5707963267948966, 3.0})
    for (const double face : {1.0, -1.0}) {
      const OwnPlace place{.model = &model, .row = {.s = s, .t = s / 3, .leg = face, .face = face}};
      requireFinite(model.ofGuideway(place, {0.5, -1}, 400, 2405, s, 0));
      requireFinite(model.ofCircles(place, 0.1 - s / 10, s / 10 - 0.05));
    }
}

/// An own effect of this formula. Each amplitude has the plausible size 1 in its unit.
OwnEffect effectOf(std::string_view formula, const Formula& read) {
  OwnEffect effect{.id = "fuzzed", .formula = std::string(formula)};
  for (const FormulaAmplitude& amplitude : read.amplitudes)
    effect.parameters.push_back({amplitude.name, "1", std::string(unitOf(amplitude.carrier))});
  return effect;
}

void parse(std::string_view text) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__clang__)
  constexpr double longest = 0.2;  // s; longer for sanitizers, which all clang builds have
#else
  constexpr double longest = 0.01;
#endif
  const std::clock_t start = std::clock();
  const auto formula = parseFormula(text);
  require(static_cast<double>(std::clock() - start) < longest * CLOCKS_PER_SEC, "a formula that takes long");
  if (!formula) {
    const FormulaFault& fault = formula.problem();
    require(!fault.text(text).empty() && !fault.what.empty(), "a formula refused without words");
    require(fault.at <= text.size() && fault.length <= text.size() - fault.at, "a fault outside its formula");
    return;
  }
  require(text.size() <= longestFormula && !formula->lines.empty(), "a formula without bounds");
  evaluate(effectOf(text, *formula));
}

void readFile(std::string_view bytes) {
  const Result<OwnEffect> effect = readOwnEffect(bytes);
  if (!effect) return require(!effect.problem().what.empty(), "an effect refused without words");
  const std::string written = writeOwnEffect(*effect);
  const auto again = readOwnEffect(written);
  require(again && *again == *effect && writeOwnEffect(*again) == written, "an effect that changes");
  evaluate(*effect);
  Session session = blankSession();
  session.device.serial = effect->device;
  session.instrument.serial = effect->instrument;
  require(takeOwnEffect(session, *effect), "an effect whose owner does not take it");
  const Result<Session> taken = readSession(writeSession(session));
  require(taken && *taken == session, "a session that forgets an effect");
}

}  // namespace

void throwFormula(std::string_view bytes) {
  if (bytes.starts_with('{'))
    readFile(bytes);
  else
    parse(bytes);
}

}  // namespace alidade::fuzz
