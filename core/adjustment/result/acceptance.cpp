#include "core/adjustment/result/acceptance.h"

#include <cmath>

#include "core/base/quantity_text.h"

namespace alidade {

Verdict decide(double value, double expanded, double tolerance) {
  const double size = std::abs(value);
  if (!std::isfinite(size) || !std::isfinite(expanded)) return Verdict::Undecided;
  if (size + expanded <= tolerance) return Verdict::Accept;
  if (size - expanded > tolerance) return Verdict::Reject;
  return Verdict::Undecided;
}

std::string verdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accept:
      return "accept";
    case Verdict::Reject:
      return "reject";
    case Verdict::Undecided:
      break;
  }
  return "undecided";
}

std::string verdictSentence(double value, double expanded, double tolerance, double coverage) {
  const int decimals = decimalsFor(expanded);
  const std::string measured = "The intersection was measured as " + displayText(value, decimals) + " mm ± " +
                               displayText(expanded, decimals) + " mm (" + displayShortest(coverage * 100) +
                               " % coverage)";
  const std::string limit = "the tolerance of ± " + displayShortest(tolerance) + " mm";
  switch (decide(value, expanded, tolerance)) {
    case Verdict::Accept:
      return measured + "; it lies within " + limit + ", its uncertainty included.";
    case Verdict::Reject:
      return measured + "; it lies outside " + limit + ", its uncertainty included.";
    case Verdict::Undecided:
      break;
  }
  return measured + "; with this uncertainty it cannot be said whether it lies within " + limit + ".";
}

}  // namespace alidade
