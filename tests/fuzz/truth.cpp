#include <cmath>

#include "core/simulation/sealed_truth.h"
#include "core/simulation/simulate.h"
#include "core/simulation/trial_score.h"
#include "core/simulation/truth_text.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

namespace {

void readFile(const std::string& text) {
  const Result<std::vector<SealedTruth>> truths = readSealedTruths(text);
  if (!truths) return require(!truths.problem().what.empty(), "a truth file refused without words");
  for (const SealedTruth& truth : *truths) {
    require(std::isfinite(truth.intersection), "a true intersection that is no number");
    require(!nameOf(classOf(truth)).empty(), "a truth of no class");
    scoreTrial(truth, {});
    blamesWrongCause(truth, {});
  }
}

/// Adds effects in the notation of the command line, one per line.
void putIn(std::string_view lines) {
  constexpr std::size_t mostEffects = 6;
  Truth truth = drawTruth(1);
  bool any = false;
  for (std::size_t i = 0; i < mostEffects && !lines.empty(); ++i) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    if (const auto problem = addEffect(truth, std::string(line)))
      require(!problem->what.empty(), "an effect refused without words");
    else
      any = true;
  }
  if (!any) return;
  const Result<std::vector<SealedTruth>> again = readSealedTruths(truthJson("one", truth));
  require(again && again->front().causes == trueCauses(truth), "a truth that changes when written");
  const Result<Session> session = simulate(*protocolByName("two-face"), truth, 1);
  require(session || !session.problem().what.empty(), "a truth refused without words");
}

}  // namespace

void throwTruth(std::string_view bytes) {
  readFile(std::string(bytes));
  putIn(bytes);
}

}  // namespace alidade::fuzz
