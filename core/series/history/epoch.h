#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/numerics/square_matrix.h"
#include "core/adjustment/result/session_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/effects/catalogue.h"
#include "core/series/history/history.h"
#include "core/session/session.h"

namespace alidade {

/// A part of the uncertainty of Δd that recurs with the same instrument or the same device.
struct LastingShare {
  std::string effect;
  ErrorSource source = ErrorSource::Instrument;  ///< or Guideway
  double sigma = 0;                              ///< mm
};

/// One parameter of a cause that the diagnosis found.
struct EpochCause {
  std::string effect, parameter, unit;
  double value = 0, u = 0;
};

/// A centre coordinate or radius of the fit, mm.
struct EpochLength {
  std::string id;  ///< "o1_x", "o1_y", "radius_0", "o2_x", "o2_y", "radius_180"
  double value = 0;
};

/// The date and the results of one session.
struct Epoch {
  std::string file = {}, title = {};
  std::string readings = {};  ///< `readingsDigest`
  std::string date = {};      ///< as in the session; empty: none
  double day = 0;             ///< days from 2000-01-01; only with a `date`
  std::string device = {}, deviceSerial = {}, instrument = {}, instrumentSerial = {};
  double coverage = 0.95;
  /// Δd, measured: with the effects that the diagnosis found and all plausible ones.
  IntersectionEstimate intersection = {};
  std::vector<LastingShare> lasting = {};  ///< shares in the uncertainty of `intersection`
  Intersection ofFit = {};                 ///< from readings, zeros and distance only
  std::vector<EpochLength> lengths = {};   ///< of the fit; a length shared by both positions occurs once
  SquareMatrix covariance = {};            ///< of `lengths`, mm², scaled by the residuals
  double degreesOfFreedom = 0;             ///< of the scale of `covariance`; may be infinite
  VerticalCircle circle = VerticalCircle::Zenith;
  std::vector<EpochCause> causes = {};  ///< sizes on the session's own circle
  std::optional<Verdict> verdict = {};
  Judgement judgement = {};
  std::optional<double> tolerance = {};  ///< mm; of Δd
};

/// Fits and diagnoses the session of `file`. Fails with the reason if the session yields no Δd.
Result<Epoch> epochOf(const std::string& file, const Session& session);
/// The epoch of a finished fit and diagnosis. `fit` must have an intersection, `diagnosis` a Δd, measured.
Epoch epochOf(const std::string& file, const Session& session, const Measurement& measurement,
              const SessionFit& fit, const Diagnosis& diagnosis);
/// The epoch of a session file.
Result<Epoch> loadEpoch(const std::string& file);

}  // namespace alidade
