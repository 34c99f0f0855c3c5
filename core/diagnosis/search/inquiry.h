#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/search/explanation.h"

namespace alidade {

// The search for an explanation of a gap.

/// A reading excluded before the search: its error is too large for linear equations, or it is of a sighting
/// of a zero, which is the mean of the others then.
struct ExcludedReading {
  ReadingRef reading;  ///< in `Inquiry::ofAll`
  double sigmas = 0;   ///< its error, in stated σ
  ReadingDeviation deviation;
};

/// The start model, its leftover, and the explanations found.
struct Inquiry {
  GapModel own;       ///< the session's own model, whose gap is to be explained
  GapModel expected;  ///< `own` with known sizes; equal to `own` if there are none
  GapModel base;      ///< `expected` with closures, if possible
  Leftover leftover;
  Candidates candidates;
  std::vector<Explanation> explanations;  ///< the most likely first
  std::vector<ExcludedReading> excluded;  ///< not in `base`
  std::shared_ptr<const Inquiry> before;  ///< the inquiry with all readings; null if none is excluded

  /// The inquiry of all readings.
  const Inquiry& ofAll() const { return before ? *before : *this; }

  const Component& of(const Part& part) const { return candidates[part.component]; }
  /// Probability of the explanations for which `isIncluded` returns true.
  double chanceOf(const std::function<bool(const Explanation&)>& isIncluded) const;
  /// Probability that this identifier is among the causes.
  double probabilityOf(std::string_view id) const;
};

/// Searches for explanations of the model's gap. On a stop request, returns early with the results so far.
Inquiry inquire(GapModel model, const DiagnosisOptions& options, const std::stop_token& stop);

/// Returns the reason if the readings do not determine the model with known sizes, for example because a
/// known size is grossly wrong. Absent otherwise.
std::optional<NoModel> undetermined(const Inquiry& inquiry);

/// Returns a reading of the model as a deviation; `size` in arcseconds.
ReadingDeviation deviationAt(const Measurement& measurement, const ReadingRef& ref, double size);
/// `reading` is an index into the leftover's readings, `sigmas` the error of that reading in stated σ.
ReadingDeviation deviationAt(const Inquiry& inquiry, Eigen::Index reading, double sigmas);

}  // namespace alidade
