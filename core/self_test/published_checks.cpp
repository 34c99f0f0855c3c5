#include <string>

#include "core/adjustment/result/session_fit.h"
#include "core/base/phrase.h"
#include "core/self_test/check_families.h"
#include "core/self_test/references.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"

namespace alidade {

namespace {

constexpr const char* lastPrintedDigit =
    PHRASE_LATER("Phrase", "half of the last printed digit (Cui, Ren, Yuan, Liu)");

/// A text as printed, in mm, with a tolerance of half its last digit.
SelfCheck printed(const std::string& name, const std::string& text, double found) {
  double half = 0.5;
  for (std::size_t i = text.find('.') + 1; i < text.size(); ++i) half /= 10;
  return numberCheck(CheckGroup::Published, name, text, found,
                     {.absolute = half * (1 + 1e-9), .reason = lastPrintedDigit});
}

}  // namespace

std::vector<SelfCheck> publishedChecks() {
  const Result<Session> session = readSession(referenceText("paper-table-1.alidade"));
  if (!session) return {brokenCheck(CheckGroup::Published, "Table I", session.problem().text())};
  const Examined examined = examine(*session);
  if (!examined.measurement) return {brokenCheck(CheckGroup::Published, "Table I", "no measurement")};
  const PublishedSessionFit fit = fitSessionAsPublished(*examined.measurement);
  if (fit.arcs.size() != 2 || !fit.intersectionAsPrinted)
    return {brokenCheck(CheckGroup::Published, "Table I", "no fit")};
  const AsPrinted& upper = fit.arcs[0].asPrinted;
  const AsPrinted& lower = fit.arcs[1].asPrinted;
  return {printed("0°: ΔR (mm)", "-0.0091", upper.deltaRadius),
          printed("0°: Δx (mm)", "-0.972", upper.x),
          printed("0°: Δy (mm)", "1.8143", upper.y),
          printed("180°: ΔR (mm)", "-0.0318", lower.deltaRadius),
          printed("180°: Δx (mm)", "-1.492", lower.x),
          printed("180°: Δy (mm)", "-2.0538", lower.y),
          printed("Δd (mm)", "1.934", *fit.intersectionAsPrinted)};
}

}  // namespace alidade
