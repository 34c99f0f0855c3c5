#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// "R(180°) − R(0°)".
std::string nameInWords(const Closure& closure);

/// "R(180°) − R(0°) = 1.96 mm (u 0.28), 7.0 σ".
std::string textOf(const Closure& closure);

/// U of a misclosure at `coverage`, mm. Treats its σ as exactly known.
double expandedOf(const Closure& closure, double coverage);

/// Names the closures that fail even with the causes in the model, and the consequence; empty if none fails.
std::string misclosureSentence(const Diagnosis& diagnosis);

/// Whether the centre's offset Δz across the plane of the arc exceeds its U.
bool isAcrossSignificant(const MeasuredIntersection& measured);

/// Returns "The arc's centre is Δz = 3.01 mm ± 0.42 mm off the axis, perpendicular to the plane of the arc.",
/// or a sentence that Δz was not measured.
std::string acrossSentence(const MeasuredIntersection& measured);

}  // namespace alidade
