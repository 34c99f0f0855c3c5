#pragma once

#include <optional>
#include <string>

namespace alidade {

enum class Verdict { Accept, Reject, Undecided };

/// Guard-banded decision: accept only if |Δd| + U ≤ tolerance, reject only if |Δd| − U > tolerance. All in
/// mm, U ≥ 0, tolerance > 0. Undecided if value or U is not finite.
Verdict decide(double value, double expanded, double tolerance);

/// "accept", "reject", "undecided".
std::string verdictName(Verdict verdict);

/// The reason why the lengths allow no verdict; `core/wording/verdict.h` has the sentences.
struct LengthsInDoubt {
  struct Radius {
    int axisDeg = 0;
    double percentOff = 0;  ///< of the nominal radius, > 20
    int repeat = 1;
  };

  double distance = 0, nominalRadius = 0;  ///< as typed, mm
  std::optional<Radius> radius = {};       ///< the deviating radius; absent if the distance is too short
};

}  // namespace alidade
