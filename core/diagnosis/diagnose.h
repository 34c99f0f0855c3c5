#pragma once

#include <stop_token>

#include "core/adjustment/result/session_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/session/measurement.h"

namespace alidade {

// Sim is what the model says an instrument would read, real is what was read; the gap is what the fitted
// model leaves over beyond the stated noise. The diagnosis says where it lies, which effect of the catalogue
// causes it, how far it shrinks once the effect is added to the model, what these readings could not show,
// and which further readings would tell apart what they cannot.

/// Fails where no arc could be fitted, an id is unknown, or it was asked to stop. Effects of the
/// measurement's own model are part of the model, not of the gap. `fit` is that of the measurement. Called as
/// in samples/programs/diagnose.cpp.
Result<Diagnosis, DiagnosisFault> diagnose(const Measurement& measurement, const SessionFit& fit,
                                           const DiagnosisOptions& options = {},
                                           const std::stop_token& stop = {});
/// The same where the measurement is not fitted yet.
Result<Diagnosis, DiagnosisFault> diagnose(const Measurement& measurement,
                                           const DiagnosisOptions& options = {},
                                           const std::stop_token& stop = {});

}  // namespace alidade
