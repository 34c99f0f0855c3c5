#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/session_fit.h"
#include "core/adjustment/result/two_faces.h"
#include "core/observation/reading_ref.h"
#include "core/session/measurement.h"
#include "core/session/protocol_progress.h"

namespace alidade {

/// Sightings that had better be taken again, and why.
struct Repeat {
  enum class Reason {
    Misread,        ///< does not go with the others (`Suspect`)
    FacesDisagree,  ///< the two faces differ otherwise than elsewhere
    WaysDisagree,   ///< the same place lies elsewhere in another round
    ZeroMoved,      ///< the pointing zero was another behind the readings
  };

  Reason reason = Reason::Misread;
  std::vector<std::size_t> sightings = {};  ///< indices into the progress; all of them are in question
  std::optional<ReadingKind> kind = {};     ///< the circle; absent of ways that disagree: across the arc
  double size = 0;    ///< arcseconds, as it deviates; NaN where what was typed is no angle
  double sigmas = 0;  ///< the same in σ
};

/// What is known of a fitted session.
struct FittedSession {
  const Measurement& measurement;
  const SessionFit& fit;
  const TwoFaces* twoFaces = nullptr;  ///< null: no visit was read in both faces
  const std::vector<Suspect>& suspects;
};

/// Only what looks misread is named where that explains the rest. Empty before there is a fit, but for the
/// faces.
std::vector<Repeat> repeatsOf(const FittedSession& fitted, const ProtocolProgress& progress);

}  // namespace alidade
