#include "core/adjustment/result/acceptance.h"

#include <cmath>

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

}  // namespace alidade
