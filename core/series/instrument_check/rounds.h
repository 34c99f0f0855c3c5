#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/series/instrument_check/check_readings.h"

namespace alidade {

/// One target sighted in both faces within one round. With h half of what the faces differ by, face 1 reads
/// `direction` + h and face 2 `direction` − h, once it is turned into its face 1 equivalent; likewise the
/// vertical circle.
struct FacePair {
  std::size_t target = 0;    ///< index among the station's targets
  Angle direction = {};      ///< mean of both faces, as of face 1; wrapped into [0°, 360°)
  Angle halfDirection = {};  ///< h of the horizontal circle: c/cos e + i tan e; 0 where it was not read
  Angle vertical = {};       ///< mean of both faces, as of face 1
  Angle halfVertical = {};   ///< h of the vertical circle: the index j; 0 where it was not read
  Angle elevation = {};      ///< e; 0 where it was not read
  double distanceM = 0;      ///< along the line of sight; 0: not known
  /// Of the first sighting in each face, from 1; 0: none.
  std::size_t lineOfFaceOne = 0, lineOfFaceTwo = 0;

  bool operator==(const FacePair&) const = default;
};

struct ObservedRound {
  std::string name;             ///< "1", or as the file calls it
  std::vector<FacePair> pairs;  ///< in the order of the targets; complete rounds have one for each
};

/// Why readings take no part.
enum class LeftOut {
  IncompleteRound,  ///< the round lacks a target of the others, or one of its faces
  RareTarget,       ///< the target is missing in too many rounds
  OneFace,          ///< sightings of one face whose other face the round lacks
  FarApart,         ///< the faces differ by more than 1°: two targets under one name, or a misread one
  Repeated,         ///< not left out but averaged: sighted several times in one face of a round
};

struct LeftOutReadings {
  LeftOut why;
  std::string round, target;  ///< either may be empty
  std::string lines = {};     ///< "lines 3 and 6"; empty: not of one target
};

/// The complete rounds of one station, as the standard wants them: each target in both faces in each.
struct StationRounds {
  std::string station;
  std::string file = {};  ///< that it is of; empty where there is one
  CheckCircles circles = CheckCircles::Both;
  std::vector<std::string> targets;
  std::vector<ObservedRound> rounds;
  std::vector<LeftOutReadings> leftOut;  ///< in the order of rounds
  std::string parted = {};  ///< sentence: why these rounds are a station of their own; else empty
};

/// "lines 3 and 6": of both faces.
std::string linesOf(const FacePair& pair);

/// Sorts the readings of each station into rounds and keeps the complete ones. Where the file says the round,
/// that is followed; a round that comes again with the same targets is a further one. Where it does not, and
/// every target was sighted as often in either face, the n-th sighting of a target is of round n. Else a
/// round ends where a target comes again in a face once most of its targets have both; until then a target
/// that comes again, as where the horizon is closed, is averaged. Where rounds lack targets, what is missing
/// most often goes first: a target that most rounds lack, or rounds that lack most targets. Rounds that show
/// the same targets elsewhere are a station of their own (`partedByGeometry`).
std::vector<StationRounds> completeRounds(const CheckReadings& readings);

}  // namespace alidade
