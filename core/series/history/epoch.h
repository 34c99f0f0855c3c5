#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/numerics/square_matrix.h"
#include "core/adjustment/result/session_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/effects/catalogue.h"
#include "core/session/session.h"

namespace alidade {

/// A part of the uncertainty of Δd that comes again with the same instrument, or the same device.
struct LastingShare {
  std::string effect;
  ErrorSource source = ErrorSource::Instrument;  ///< or Guideway
  double sigma = 0;                              ///< mm
};

/// One number of a cause that was found.
struct EpochCause {
  std::string effect, parameter, unit;
  double value = 0, u = 0;
};

/// A centre coordinate or radius of the fit.
struct EpochLength {
  std::string id;  ///< "o1_x", "o1_y", "radius_0", "o2_x", "o2_y", "radius_180"
  double value = 0;
};

/// What one session has to say about its device, at its date.
struct Epoch {
  std::string file = {}, title = {};
  std::string readings = {};  ///< `readingsDigest`
  std::string date = {};      ///< as the session has it; empty: none
  double day = 0;             ///< from 2000-01-01; with a date
  std::string device = {}, deviceSerial = {}, instrument = {}, instrumentSerial = {};
  double coverage = 0.95;
  /// As found: with what the diagnosis found, and everything plausible.
  IntersectionEstimate intersection = {};
  std::vector<LastingShare> lasting = {};  ///< of its uncertainty
  Intersection ofFit = {};                 ///< by the readings, zeros and distance alone
  std::vector<EpochLength> lengths = {};   ///< of the fit; one that both positions share stands once
  SquareMatrix covariance = {};            ///< of these, mm², scaled by the residuals
  double degreesOfFreedom = 0;             ///< behind that scale; may be infinite
  std::vector<EpochCause> causes = {};
  std::optional<Verdict> verdict = {};
};

/// Fits and diagnoses the session of `file`. Fails where it has no Δd to tell, with the reason.
Result<Epoch> epochOf(const std::string& file, const Session& session);
/// The same where that was done. `fit` has an intersection, `diagnosis` one as measured.
Epoch epochOf(const std::string& file, const Session& session, const Measurement& measurement,
              const SessionFit& fit, const Diagnosis& diagnosis);
/// The same of a file.
Result<Epoch> loadEpoch(const std::string& file);

}  // namespace alidade
