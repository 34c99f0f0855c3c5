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

// The search for what explains a gap.

/// A reading that was left out before the search, since it is off by far more than the equations bear.
struct LargeGrossError {
  ReadingRef reading;
  double sigmas = 0;  ///< how far it is off, in its σ
};

/// The model it starts from, what it leaves over, and what explains that.
struct Inquiry {
  GapModel own;       ///< the session's, whose result is measured
  GapModel expected;  ///< the same with what is known beforehand; `own` where nothing is
  GapModel base;      ///< that closed, where it can be
  Leftover leftover;
  Candidates candidates;
  std::vector<Explanation> explanations;          ///< the likeliest first
  std::vector<LargeGrossError> largeGrossErrors;  ///< `base` does without them
  std::shared_ptr<const Inquiry> before;  ///< what was found with all readings; null where none is far off

  /// The inquiry into the gap as it is, of all readings.
  const Inquiry& ofAll() const { return before ? *before : *this; }

  const Component& of(const Part& part) const { return candidates[part.component]; }
  /// Probability that one of these explanations is the right one.
  double chanceOf(const std::function<bool(const Explanation&)>& isMeant) const;
  /// Probability that the id is among the causes.
  double probabilityOf(std::string_view id) const;
};

/// Asked to stop, it returns early with what it has found.
Inquiry inquire(GapModel model, const DiagnosisOptions& options, const std::stop_token& stop);

/// Why nothing can be said where the model with what is known beforehand, a size far off say, is not
/// determined by the readings; absent where it is.
std::optional<NoModel> undetermined(const Inquiry& inquiry);

/// A reading of the model, `size` in arcseconds.
ReadingDeviation deviationAt(const Measurement& measurement, const ReadingRef& ref, double size);
/// An index into the leftover's readings, off by so many of its σ.
ReadingDeviation deviationAt(const Inquiry& inquiry, Eigen::Index reading, double sigmas);

}  // namespace alidade
