#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "ui/jobs/fit_job.h"

namespace alidade::ui {

/// What a fit leaves over with one more effect in the model than in the stage before.
struct GapStage {
  enum class Kind {
    Bare,      ///< without the effects of the session's model
    InModel,   ///< an effect of the session's model
    Proposed,  ///< a cause that was found
  };

  Kind kind = Kind::Bare;
  std::string effect = {};      ///< id; empty for Bare
  std::size_t grossErrors = 1;  ///< of a gross_error: how many values are left out
  double rms = 0;               ///< of the circle readings, arcseconds
  double reducedChiSquare = 0;
  std::optional<IntersectionEstimate> intersection;
};

/// The gap between model and readings of one evaluation: a plain value that page and report show alike.
struct Gap {
  SharedEvaluation evaluation;
  std::optional<Diagnosis> diagnosis;
  std::string reason;            ///< why there is no diagnosis: a sentence
  std::vector<GapStage> stages;  ///< with a diagnosis: from the bare model to that with the causes
  double noiseRms = 0;           ///< rms that the stated noise leaves, arcseconds
  bool isWithReference = false;  ///< asked for: the causes are weighed with the reference

  /// The stage of the session as it is: the last that is not proposed.
  const GapStage& asModelled() const;
  /// A gap that the session's model does not account for, in residuals or between the positions.
  bool isOpen() const {
    return diagnosis && (diagnosis->verdict != DiagnosisVerdict::WithinNoise || isMisclosed(*diagnosis));
  }
  const Diagnosis* found() const { return diagnosis ? &*diagnosis : nullptr; }
  /// The result of the measurement; null without a diagnosis, and where these readings do not determine Δd.
  const MeasuredIntersection* measured() const {
    return diagnosis && diagnosis->measured ? &*diagnosis->measured : nullptr;
  }
  /// U of the result: as measured, or else of the fit alone. Absent without a diagnosis, or without Δd.
  std::optional<double> expandedUncertainty() const;
  /// Nothing but noise larger than stated.
  bool isNoiseAlone() const;
  /// Effects that leave no clear trace and of which a plausible size moves Δd by more than U: what the result
  /// rests on unproven. None without a diagnosis.
  std::vector<UnseenEffect> unseenBeyondU() const;
  /// Effects that leave no clear trace and of which a plausible size moves Δd noticeably, by a fiftieth of U
  /// or more: the worst eight of them at most. None without a diagnosis.
  std::vector<UnseenEffect> noticeablyUnseen() const;
};

/// Diagnoses the evaluation, the causes weighed with the reference (`DiagnosisOptions::withReference`) or
/// not. Takes many times as long as a fit; asked to stop, it returns early, without a diagnosis.
Gap assessGap(const SharedEvaluation& evaluation, const std::stop_token& stop = {},
              bool withReference = false);
/// No diagnosis, for this reason.
Gap noGap(SharedEvaluation evaluation, std::string reason);

}  // namespace alidade::ui
