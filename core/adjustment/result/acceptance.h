#pragma once

#include <string>

namespace alidade {

enum class Verdict { Accept, Reject, Undecided };

/// Guard-banded decision: accept only if |Δd| + U ≤ tolerance, reject only if |Δd| − U > tolerance. All in
/// mm, U ≥ 0, tolerance > 0. Undecided where value or U is not finite.
Verdict decide(double value, double expanded, double tolerance);

/// "accept", "reject", "undecided".
std::string verdictName(Verdict verdict);

/// One sentence a customer understands, with the numbers it rests on.
std::string verdictSentence(double value, double expanded, double tolerance, double coverage);

}  // namespace alidade
