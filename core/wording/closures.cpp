#include "core/wording/closures.h"

#include <vector>

#include "core/base/list_text.h"
#include "core/base/quantity_text.h"

namespace alidade {

std::string nameInWords(Closure::Of of) {
  return of == Closure::Of::Radius ? "R(180°) − R(0°)" : "Δx(180°) − Δx(0°)";
}

std::string textOf(const Closure& closure) {
  const int decimals = decimalsFor(closure.sigma);
  return nameInWords(closure.of) + " = " + displayText(closure.value, decimals) + " mm (u " +
         displayText(closure.sigma, decimals) + "), " + displayText(closure.sigmas(), 1) + " σ";
}

std::string misclosureSentence(const Diagnosis& diagnosis) {
  std::vector<std::string> open;
  for (const ClosureStep& step : diagnosis.closures)
    if (step.isOpen()) open.push_back(textOf(step.latest()));
  if (open.empty()) return {};
  return "The two positions do not close: " + listed(open, " and ") +
         ". What moved between them may have moved Δd: find it, or measure anew and sight the zeros again.";
}

}  // namespace alidade
