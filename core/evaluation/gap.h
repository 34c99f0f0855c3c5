#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/diagnosis/decision.h"
#include "core/diagnosis/dependence.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/evaluation/evaluation.h"

namespace alidade {

/// The residuals of a fit with one more effect in the model than in the stage before.
struct GapStage {
  enum class Kind {
    Bare,      ///< without the effects of the session's model
    InModel,   ///< an effect of the session's model
    Proposed,  ///< a cause found by the diagnosis
  };

  Kind kind = Kind::Bare;
  std::string effect = {};      ///< id; empty for Bare
  std::size_t grossErrors = 1;  ///< for a gross_error: number of excluded values
  double rms = 0;               ///< of the circle residuals, arcseconds
  double reducedChiSquare = 0;
  std::optional<IntersectionEstimate> intersection;
};

/// Why there is no diagnosis although no computation failed.
enum class Absence {
  NotMade,           ///< no diagnosis was requested
  Stopped,           ///< the diagnosis was stopped on request
  NothingToCompare,  ///< no arc could be fitted
  NothingLeftOver,   ///< the readings of one axis angle determine its arc without redundancy
};

using NoDiagnosis = std::variant<Absence, FailedWork, DiagnosisFault>;

/// The gap between model and readings of one evaluation. Page and report show the same gap.
struct Gap {
  SharedEvaluation evaluation;
  std::optional<Diagnosis> diagnosis;
  NoDiagnosis reason = Absence::NotMade;  ///< why there is no diagnosis
  std::vector<GapStage> stages;  ///< with a diagnosis: from the bare model to the model with the causes
  double noiseRms = 0;           ///< rms expected from the stated noise, arcseconds
  bool isWithReference = false;  ///< whether the causes are weighed with the reference
  /// The single rows on which the verdict depends; absent: not sought yet.
  std::optional<std::vector<Dependence>> dependences = {};

  /// The stage of the session's own model: the last stage before the proposed causes.
  const GapStage& asModelled() const;
  /// True for a gap that the session's model does not explain, in residuals or between the positions.
  bool isOpen() const { return diagnosis && hasGap(*diagnosis); }
  const Diagnosis* found() const { return diagnosis ? &*diagnosis : nullptr; }
  /// Δd, measured; null without a diagnosis, or if these readings do not determine Δd.
  const MeasuredIntersection* measured() const {
    return diagnosis && diagnosis->measured ? &*diagnosis->measured : nullptr;
  }
  /// U of Δd, measured, or else of Δd, fit only. Absent without a diagnosis, or without Δd.
  std::optional<double> expandedUncertainty() const;
  /// True if the only cause is noise larger than stated.
  bool isNoiseAlone() const;
  /// Undetectable effects of which a plausible size moves Δd by more than U: the untested assumptions of the
  /// result. Empty without a diagnosis.
  std::vector<UndetectableEffect> undetectableBeyondU() const;
  /// Undetectable effects of which a plausible size moves Δd by a fiftieth of U or more: at most eight, the
  /// worst first. Empty without a diagnosis.
  std::vector<UndetectableEffect> noticeablyUndetectable() const;
};

/// The undetectable effects of which a plausible size moves Δd by more than `expanded`, mm.
std::vector<UndetectableEffect> undetectableBeyond(const Diagnosis& diagnosis, double expanded);

/// The gap of an evaluation and its diagnosis, with the stages. If asked to stop, computes fewer stages.
Gap gapOf(SharedEvaluation evaluation, Diagnosis diagnosis, const std::stop_token& stop = {});
/// Diagnoses the evaluation, weighing the causes with the reference (`DiagnosisOptions::withReference`) if
/// requested. Takes many times as long as a fit. If asked to stop, returns early without a diagnosis.
Gap assessGap(const SharedEvaluation& evaluation, const std::stop_token& stop = {},
              bool withReference = false);
/// The gap with its `dependences`. If they are absent, seeks them, which takes as long as several diagnoses.
/// If asked to stop, returns early without them.
Gap withDependences(Gap gap, const std::stop_token& stop = {});
/// A gap without a diagnosis, for this reason.
Gap noGap(SharedEvaluation evaluation, NoDiagnosis reason);

}  // namespace alidade
