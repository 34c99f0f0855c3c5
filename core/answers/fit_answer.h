#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/session_fit.h"
#include "core/answers/arrivals.h"
#include "core/diagnosis/dependence.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/session/measurement.h"

namespace alidade {

/// What the rigorous fit of a session is answered with. Must not outlive what it refers to.
struct FitAnswer {
  const std::string& session;
  const Measurement& measurement;
  const SessionFit& fit;
  std::vector<Suspect> suspects = {};
  std::optional<MonteCarlo> check = {};     ///< where asked for
  std::optional<Diagnosis> diagnosis = {};  ///< unless left out
  /// On which single rows the verdict depends.
  std::vector<Dependence> dependences = {};
  std::vector<Arrival> arrivals = {};  ///< of the session

  const Diagnosis* found() const { return diagnosis ? &*diagnosis : nullptr; }
  /// Fills `dependences`; the last, since it takes some diagnoses more.
  void findDependences() {
    if (const auto decision = decideAcceptance(measurement, fit, found()))
      dependences = dependencesOf(measurement, fit, found(), *decision);
  }
};

}  // namespace alidade
