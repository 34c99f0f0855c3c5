#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/session/measurement.h"

namespace alidade {

// What a series of sessions answers.

/// To whom an effect belongs: to an instrument, known by its serial, in all sessions with it; to a guideway
/// likewise; or to the session, which shares it with no other.
enum class CauseOwner { Instrument, Guideway, Time };

/// "instrument", "guideway", "time".
std::string_view nameOf(CauseOwner owner);

/// How large an effect is in one session.
struct SizeInSession {
  std::size_t session = 0;
  std::vector<CauseParameter> parameters = {};
};

/// What the series cannot tell from a cause.
struct SharedRival {
  std::string effect;
  CauseOwner owner = CauseOwner::Time;
  std::string serial = {};  ///< empty: of each owner by itself, or of none
  double odds = 0;          ///< against the cause
};

struct SharedCause {
  Cause cause;  ///< its sizes are those of all sessions; of a drifting one those of the last
  CauseOwner owner = CauseOwner::Time;
  std::string serial = {};                 ///< of the owner; empty where it has none, or is the time
  std::vector<std::size_t> sessions = {};  ///< that it acts in, of the series
  bool isDrifting = false;                 ///< its size changes from session to session
  std::vector<SizeInSession> sizes = {};   ///< where it drifts, and of the time
  std::vector<std::size_t> apart = {};     ///< of its owner's sessions those that do not share it
  std::vector<SharedRival> rivals = {};    ///< the likeliest first
  double visibleInOne = 0;                 ///< what it leaves in a session, σ: root mean square
  double visibleTogether = 0;              ///< in all of them
};

/// Which session to measure next.
struct SeriesAdvice {
  enum class What {
    OtherInstrument,  ///< the same guideway with another instrument
    OtherGuideway,    ///< another guideway with the same instrument
    Again,            ///< the same two again: it shows too faintly so far
  };
  What what = What::Again;
  std::string instrument = {}, guideway = {};  ///< serials; empty: any, or any other than those so far
  std::vector<std::string> separates = {};     ///< ids
  double bySigma = 0;                          ///< difference once `sessions` are measured, σ
  int sessions = 1;
};

/// A session of the series.
struct SeriesMember {
  std::string name, measuredOn;
  std::string instrumentName, instrument;  ///< name and serial
  std::string guidewayName, guideway;
  std::size_t file = 0;  ///< of what was handed in, index
  DiagnosisVerdict alone = DiagnosisVerdict::WithinNoise;
  std::vector<Cause> causesAlone = {};
  std::vector<Cause> own = {};  ///< what it holds by itself in the light of the series
  /// In the light of the series: what other sessions say of shared effects is known beforehand.
  Diagnosis diagnosis = {};
  std::vector<KnownNumber> shared = {};  ///< that
};

/// A file that holds what another one holds: the other one counts.
struct SeriesCopy {
  std::string file, first;
};

/// What sessions share, where no effect of the catalogue explains it.
struct SharedPattern {
  std::string follows;  ///< "radius along the guideway", …
  int order = 0;        ///< periods in a turn; 0: it is no harmonic
  /// Of the gap of all sessions that it takes up, 0…1; not a number where each session holds one by itself.
  double share = std::numeric_limits<double>::quiet_NaN();
  CauseOwner owner = CauseOwner::Time;
  std::string serial = {};                 ///< of the owner
  std::vector<std::size_t> sessions = {};  ///< that it acts in
  double probability = 0;                  ///< that what they share is of no catalogue, 0…1
  bool isOfEach = false;                   ///< each of these sessions holds one by itself, not all the same
  double visibleInOne = 0;                 ///< what it leaves in a session, σ: root mean square
  double visibleTogether = 0;              ///< in all of them
};

struct SeriesDiagnosis {
  DiagnosisVerdict verdict = DiagnosisVerdict::WithinNoise;
  GapSize gap, after;  ///< of all sessions, with what the positions of each must agree on
  Shrinkage shrink;    ///< held out: each session predicted by the sizes the others give
  std::vector<SharedCause> causes;
  std::optional<SharedPattern> pattern;  ///< with NotInCatalogue; beside it `causes` that are certain
  double unknownChance = 0;              ///< that the sessions share a pattern of no catalogue, 0…1
  std::vector<Candidate> candidates;     ///< as shared by all sessions of an owner, the best owner of each
  std::vector<GapShare> where;           ///< by frame, session, instrument and guideway
  std::vector<UnseenEffect> unseen;
  std::vector<SeriesAdvice> advice;
  std::vector<SeriesMember> sessions;                      ///< in the order in which they were measured
  std::size_t withoutInstrument = 0, withoutGuideway = 0;  ///< sessions without a serial
  std::vector<SeriesCopy> copies;                          ///< left out, in the order handed in
};

}  // namespace alidade
