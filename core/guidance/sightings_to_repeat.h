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

/// Sightings that should be repeated, and why.
struct SightingsToRepeat {
  enum class Reason {
    Misread,        ///< disagrees with the others (`Suspect`)
    FacesDisagree,  ///< the difference of the faces deviates from that of other visits
    WaysDisagree,   ///< the deviation of a place across the arc differs between rounds
    ZeroMoved,      ///< the pointing zero changed during the readings
  };

  Reason reason = Reason::Misread;
  std::vector<std::size_t> sightings = {};  ///< indices into the progress; all of them are in question
  std::optional<ReadingKind> kind = {};     ///< the circle; absent for `WaysDisagree` (across the arc)
  double size = 0;                          ///< deviation, arcseconds; NaN if the typed text is not an angle
  double sigmas = 0;                        ///< deviation in σ
};

/// The results for a fitted session.
struct FittedSession {
  const Measurement& measurement;
  const SessionFit& fit;
  const TwoFaces* twoFaces = nullptr;  ///< null: no visit was read in both faces
  const std::vector<Suspect>& suspects;
};

/// A disagreement of faces or rounds is omitted if one of its sightings is already named, for example as
/// misread. Before a fit, only disagreeing faces are found.
std::vector<SightingsToRepeat> sightingsToRepeat(const FittedSession& fitted,
                                                 const ProtocolProgress& progress);

}  // namespace alidade
