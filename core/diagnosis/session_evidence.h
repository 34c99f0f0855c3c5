#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/diagnosis/shared_columns.h"
#include "core/session/measurement.h"

namespace alidade {

// The evidence of one session about every catalogue effect, for a joint evaluation of several sessions. An
// effect of the same size x in all of them has the normal equations Σ N x = Σ b.
//
// The columns are the same for every session (`SharedColumns`). N = CᵀC and b = Cᵀr, with the visible columns
// C and the leftover r, both in σ of the readings (`Leftover`). The columns of undetectable effects, of
// effects in the model and of own effects that the session does not have are 0.

/// One explanation by the session's own causes: none, gross errors, a jump, larger noise, or another cause.
/// Its columns A, at their prior widths, are eliminated and do not distort the evidence for a shared effect.
/// The result is N − TᵀT and b − Tᵀt; t are the components of r along the directions of T.
struct SessionExplanation {
  std::vector<std::string> causes = {};  ///< identifiers, without larger noise; empty: no cause
  bool holdsPattern = false;  ///< contains a cause that affects many readings: an effect, a jump, a shape
  bool noisy = false;         ///< with noise larger than stated
  double noise = 1;           ///< scale of the noise
  double logOdds = 0;         ///< natural logarithm of prior odds × evidence, against the empty explanation
  double chiSquare = 0;       ///< χ² after the explanation, with the stated σ
  std::vector<double> right = {};  ///< b after elimination
  std::size_t directions = 0;
  std::vector<double> taken = {};  ///< T, directions × columns, row by row
};

struct SessionEvidence {
  std::shared_ptr<const SharedColumns> columns;
  std::vector<double> normal;                    ///< N, indexed by `productAt`
  std::vector<SessionExplanation> explanations;  ///< the first has no cause
  double chiSquare = 0;                          ///< χ² of the leftover
  int degreesOfFreedom = 0;
  // Sums over the circle readings: Σ ε², Eᵀε and EᵀE, with their leftover ε and the columns E in arcseconds.
  std::size_t circleReadings = 0;
  double circleSquares = 0;
  std::vector<double> circleRight, circleNormal;
  std::vector<double> influence;  ///< change of Δd by each column, mm

  // The diagnosis of this session alone.
  DiagnosisVerdict verdict = DiagnosisVerdict::WithinNoise;
  std::vector<Cause> causes;
};

/// Fails if no arc can be fitted, an identifier is unknown, or a stop was requested.
Result<SessionEvidence, DiagnosisFault> evidenceOf(const Measurement& measurement,
                                                   std::shared_ptr<const SharedColumns> columns,
                                                   const DiagnosisOptions& options = {},
                                                   const std::stop_token& stop = {});

/// The evidence gained from columns, averaged over equally probable prior widths `sigmas` (plausible sizes)
/// of their weights. `gram`: inner products, row by row; `right`: products with the leftover.
struct ColumnGain {
  double log = 0;               ///< natural logarithm
  double width = 1;             ///< the most likely width, in plausible sizes
  std::vector<double> weights;  ///< at `width`; two for a bent effect; none for an all-or-nothing effect
};
ColumnGain columnGain(Response response, std::span<const double> gram, std::span<const double> right,
                      std::span<const double> sigmas);

/// The distance, σ, between a trace and an effect at its best weights. `gram`, `right`: products of the
/// effect's columns with each other and the trace; `square`: |trace|².
double leastDifference(Response response, std::span<const double> gram, std::span<const double> right,
                       double square);

/// Distances in σ at which two effects are hardly and clearly separated (`Trace`).
double hardlySeparated();
double clearlySeparated();

/// Prior odds of an effect, or of a jump at any moment, against "no gap at all" (`PriorOdds`).
double priorOddsOfEffect();

}  // namespace alidade
