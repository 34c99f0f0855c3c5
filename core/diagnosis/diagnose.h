#pragma once

#include <stop_token>

#include "core/adjustment/result/session_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/session/measurement.h"

namespace alidade {

// Diagnoses the gap: what the fitted model leaves of the readings beyond the stated noise. The result states
// where the gap lies and which effect of the catalogue causes it. It also states how far the gap shrinks with
// that effect, what is undetectable, and which further readings can separate look-alikes.

/// Fails if no arc can be fitted, an identifier is unknown, or a stop was requested. Effects of the
/// measurement's own model belong to the model, not to the gap. `fit` is the fit of the measurement. See
/// samples/programs/diagnose.cpp for a call.
Result<Diagnosis, DiagnosisFault> diagnose(const Measurement& measurement, const SessionFit& fit,
                                           const DiagnosisOptions& options = {},
                                           const std::stop_token& stop = {});
/// Fits the measurement first.
Result<Diagnosis, DiagnosisFault> diagnose(const Measurement& measurement,
                                           const DiagnosisOptions& options = {},
                                           const std::stop_token& stop = {});

}  // namespace alidade
