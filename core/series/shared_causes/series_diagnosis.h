#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/session/measurement.h"
#include "core/session/own_effect.h"

namespace alidade {

// The result of a series of sessions.

/// The owner of an effect: an instrument or a guideway, identified by its serial number, in all its sessions.
/// `Time`: each session has its own effect.
enum class CauseOwner { Instrument, Guideway, Time };

/// "instrument", "guideway", "time".
std::string_view nameOf(CauseOwner owner);

/// The size of an effect in one session.
struct SizeInSession {
  std::size_t session = 0;
  std::vector<CauseParameter> parameters = {};
};

/// An alternative that the series cannot distinguish from a cause.
struct SharedRival {
  std::string effect;
  CauseOwner owner = CauseOwner::Time;
  std::string serial = {};  ///< of the owner; empty: each owner separately, or no owner
  double odds = 0;          ///< of this alternative against the cause
};

struct SharedCause {
  /// With its size; a drifting size is that in the last session. Without a size if each session has its own.
  Cause cause;
  CauseOwner owner = CauseOwner::Time;
  std::string serial = {};                 ///< of the owner; empty if it has none, or for effects of time
  std::vector<std::size_t> sessions = {};  ///< indices of the sessions in which the cause acts
  bool isDrifting = false;                 ///< its size changes from session to session
  std::vector<SizeInSession> sizes = {};   ///< if the size differs between sessions
  std::vector<std::size_t> apart = {};     ///< sessions of its owner that do not share the cause
  std::vector<SharedRival> rivals = {};    ///< the likeliest first
  double visibleInOne = 0;                 ///< root mean square of its trace in a session, σ
  double visibleTogether = 0;              ///< its trace in all these sessions together, σ
};

/// Advice on the next session to measure.
struct SeriesAdvice {
  enum class What {
    OtherInstrument,  ///< the same guideway with another instrument
    OtherGuideway,    ///< another guideway with the same instrument
    Again,            ///< the same owner again: the cause is still too faint
  };
  What what = What::Again;
  /// Serial numbers; empty: any, or one not used so far. The guideway to measure again with another
  /// instrument, and the instrument for another guideway, are never empty.
  std::string instrument = {}, guideway = {};
  std::vector<std::string> separates = {};  ///< ids of effects
  double bySigma = 0;                       ///< difference after `sessions` are measured, σ
  int sessions = 1;
};

/// A session of the series.
struct SeriesMember {
  std::string name, measuredOn;
  std::string instrumentName, instrument;  ///< name and serial
  std::string guidewayName, guideway;
  std::size_t file = 0;  ///< index among the input
  DiagnosisVerdict alone = DiagnosisVerdict::WithinNoise;
  std::vector<Cause> causesAlone = {};
  std::vector<Cause> own = {};  ///< causes of this session alone, given the series
  /// The diagnosis given the series: the other sessions' results on shared effects are its prior knowledge.
  Diagnosis diagnosis = {};
  std::vector<KnownNumber> shared = {};  ///< sizes of shared effects from the other sessions
};

/// A file with the same readings as an earlier file. Only the earlier file is used.
struct SeriesCopy {
  std::string file, first;
};

/// The pattern that the sessions share, if no catalogued effect explains it.
struct SharedPattern {
  std::string follows;  ///< "radius along the guideway", …
  int order = 0;        ///< periods per turn; 0: not a harmonic
  /// The share of the gap of all sessions that it explains, 0…1; NaN if each session has its own pattern.
  double share = std::numeric_limits<double>::quiet_NaN();
  CauseOwner owner = CauseOwner::Time;
  std::string serial = {};                 ///< of the owner
  std::vector<std::size_t> sessions = {};  ///< indices of the sessions in which the pattern acts
  double probability = 0;                  ///< that the shared pattern is uncatalogued, 0…1
  bool isOfEach = false;                   ///< each session has a different pattern of its own
  double visibleInOne = 0;                 ///< root mean square of its trace in a session, σ
  double visibleTogether = 0;              ///< its trace in all these sessions together, σ
};

/// A form found in at least three sessions of its owner, as an effect of the user's own.
struct OfferedEffect {
  FoundForm form;    ///< the mean of the sessions (`meanOf`)
  OwnEffect effect;  ///< of the instrument if the form acts on circles, else of the guideway
  std::vector<std::size_t> sessions;
};

struct SeriesDiagnosis {
  DiagnosisVerdict verdict = DiagnosisVerdict::WithinNoise;
  GapSize gap, after;  ///< of all sessions, including the conditions between the positions of each
  Shrinkage shrink;    ///< cross-validated: each session predicted from the sizes of the others
  std::vector<SharedCause> causes;
  std::optional<SharedPattern> pattern;  ///< only with NotInCatalogue
  double unknownChance = 0;           ///< probability that the sessions share an uncatalogued pattern, 0…1
  std::vector<Candidate> candidates;  ///< each effect alone, with its likeliest owner
  std::vector<GapShare> where;        ///< by frame, session, instrument and guideway
  std::vector<UndetectableEffect> undetectable;
  std::vector<SeriesAdvice> advice;
  std::vector<OfferedEffect> offered;                      ///< the form found in most sessions first
  std::vector<SeriesMember> sessions;                      ///< in order of measurement
  std::size_t withoutInstrument = 0, withoutGuideway = 0;  ///< sessions without a serial
  /// Sessions have vertical circles of both kinds. All sizes of their errors are then those on a zenith
  /// circle.
  bool hasBothCircles = false;
  std::vector<SeriesCopy> copies;  ///< files that are not used, in the order given
};

}  // namespace alidade
