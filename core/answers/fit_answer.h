#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/session_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/dependence.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/evaluation/gap.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// The data that an instrument sent with one row of a session.
struct Arrival {
  std::size_t position = 0, row = 0;
  std::string takenAt = {}, returnCode = {}, instrumentSerial = {};
};

/// Returns the arrivals of all rows that have data from an instrument, in the order of the file.
std::vector<Arrival> arrivalsOf(const Session& session);

/// Null if the instrument sent nothing with the row.
const Arrival* arrivalAt(const std::vector<Arrival>& arrivals, std::size_t position, std::size_t row);

/// The content of the result of a rigorous fit. Must not outlive the objects it refers to.
struct FitAnswer {
  const std::string& session;
  const Measurement& measurement;
  const SessionFit& fit;
  std::vector<Suspect> suspects = {};
  std::optional<MonteCarlo> check = {};     ///< on request
  std::optional<Diagnosis> diagnosis = {};  ///< absent if none was made
  /// The single rows on which the verdict depends.
  std::vector<Dependence> dependences = {};
  std::vector<Arrival> arrivals = {};  ///< of the rows of the session
  std::string digest = {};             ///< SHA-256 of the session's file; empty: unknown

  const Diagnosis* found() const { return diagnosis ? &*diagnosis : nullptr; }
};

/// The result of a diagnosed evaluation, in the language of the thread. `gap` and `name` must outlive it.
/// Fails with the first reason if an entry is unusable, a computation failed, or an arc was not fitted.
/// `file`: the bytes of the session's file.
Result<FitAnswer> fitAnswerOf(const Gap& gap, const std::string& name, std::string_view file);

}  // namespace alidade
