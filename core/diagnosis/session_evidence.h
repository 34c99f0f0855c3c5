#pragma once

#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/effects/catalogue.h"
#include "core/session/measurement.h"

namespace alidade {

// What one session says of every effect of the catalogue, handed out so that several sessions can be weighed
// together: an effect of one size x in all of them has the normal equations Σ N x = Σ b.
//
// Columns are those of all sought effects, then of patterns of no catalogue (`session_patterns.h`), one after
// the other, the same for every session; a weight of 1 is a plausible size. N = CᵀC and b = Cᵀr of the
// visible columns C and the leftover r, both in σ of the readings (`Leftover`). Of an effect that the
// readings cannot show, or that is in the model, the columns are 0.

/// The columns of one effect: of what bends with its second derivatives, (x, y, ½x², xy, ½y²).
struct EffectColumns {
  const Effect* effect;
  std::size_t first, count;
  bool isPattern = false;
  int order = 0;  ///< of a pattern: periods in a turn; 0: it is no harmonic
};
/// Of the catalogue.
const std::vector<EffectColumns>& effectColumns();
/// The same, and then the patterns.
const std::vector<EffectColumns>& sharedColumns();
/// Of all of these.
std::size_t columnCount();

/// Where the product of two columns stands among those that are kept (`SessionEvidence::normal`): of each
/// column those with the catalogue's up to itself, of a pattern's then those with its own. Of two patterns no
/// product is kept.
std::size_t productAt(std::size_t a, std::size_t b);

/// One account of what a session holds by itself, so that it does not spoil what it says of an effect that it
/// shares: nothing, misread values, a jump, larger noise, a cause of its own. Its columns A, with the weights
/// that are plausible of them, are taken off: N − TᵀT and b − Tᵀt where t is what T's directions find in r.
struct OwnAccount {
  std::vector<std::string> causes = {};  ///< ids, without larger noise; empty: nothing
  bool holdsPattern = false;             ///< something in many readings: an effect, a jump, a shape
  bool noisy = false;                    ///< with noise larger than stated
  double noise = 1;                      ///< scale of it
  double logOdds = 0;                    ///< prior and evidence, against nothing at all, natural
  double chiSquare = 0;                  ///< of what it leaves, stated σ
  std::vector<double> right = {};        ///< b without it
  std::size_t directions = 0;
  std::vector<double> taken = {};  ///< T, directions × columns, a row after the other
};

struct SessionEvidence {
  std::vector<double> normal;        ///< N, by `productAt`
  std::vector<OwnAccount> accounts;  ///< the first: nothing
  double chiSquare = 0;              ///< of the leftover
  int degreesOfFreedom = 0;
  // Of the circle readings' leftover ε in arcseconds: Σ ε², and with E the columns in arcseconds Eᵀε and EᵀE.
  std::size_t circleReadings = 0;
  double circleSquares = 0;
  std::vector<double> circleRight, circleNormal;
  std::vector<double> influence;  ///< on Δd of each column, mm

  // What the session answers alone.
  DiagnosisVerdict verdict = DiagnosisVerdict::WithinNoise;
  std::vector<Cause> causes;
};

/// Fails where no arc could be fitted, an id is unknown, or it was asked to stop.
Result<SessionEvidence, DiagnosisFault> evidenceOf(const Measurement& measurement,
                                                   const DiagnosisOptions& options = {},
                                                   const std::stop_token& stop = {});

/// What columns add to the evidence at weights as wide as any of `sigmas` plausible sizes, each as likely:
/// of an effect that responds so. `gram` is symmetric, a row after the other, `right` beside it.
struct ColumnGain {
  double log = 0;               ///< natural
  double width = 1;             ///< the likeliest, plausible sizes
  std::vector<double> weights;  ///< then, of what bends its two numbers; empty where it is all or nothing
};
ColumnGain columnGain(Response response, std::span<const double> gram, std::span<const double> right,
                      std::span<const double> sigmas);

/// How near an effect comes to a trace of the squared length `square`, in σ: `right` are the products of its
/// columns with the trace.
double leastDifference(Response response, std::span<const double> gram, std::span<const double> right,
                       double square);

/// Two effects this far apart, in σ, are hardly and clearly told apart (`Trace`).
double hardlyToldApart();
double clearlyToldApart();

}  // namespace alidade
