#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/series/instrument_check/check_readings.h"

namespace alidade {

/// One target sighted in both faces within one round. Let h be half the difference of the faces. Face 1 reads
/// `direction` + h; face 2, converted to face 1, reads `direction` − h. The same holds for the vertical
/// circle.
struct FacePair {
  std::size_t target = 0;    ///< index among the station's targets
  Angle direction = {};      ///< mean of both faces, in face 1; wrapped into [0°, 360°)
  Angle halfDirection = {};  ///< h of the horizontal circle (`HalfDifference`); 0 without this circle
  Angle vertical = {};       ///< mean of both faces, in face 1
  Angle halfVertical = {};   ///< h of the vertical circle: the index j; 0 without this circle
  Angle elevation = {};      ///< e; 0 without the vertical circle
  double distanceM = 0;      ///< along the line of sight; 0: unknown
  /// Lines of the first sighting in each face, from 1; 0: none.
  std::size_t lineOfFaceOne = 0, lineOfFaceTwo = 0;

  bool operator==(const FacePair&) const = default;
};

struct ObservedRound {
  std::string name;             ///< "1", or the name in the file
  std::vector<FacePair> pairs;  ///< in the order of the targets; a complete round has one for each
};

/// Reasons why readings are excluded.
enum class LeftOut {
  IncompleteRound,  ///< the round lacks a target, or one face of a target, that other rounds have
  RareTarget,       ///< the target is missing in too many rounds
  OneFace,          ///< the round has sightings of the target in one face only
  FarApart,         ///< |h| > 1°, so the faces differ by more than 2°: two targets of one name, or misread
  Repeated,         ///< not left out: sighted several times in one face of a round, and averaged
};

struct LeftOutReadings {
  LeftOut why;
  std::string round, target;  ///< either may be empty
  std::string lines = {};     ///< "lines 3 and 6", with FarApart; else empty
};

/// The complete rounds of one station as the standard requires: each target in both faces in every round.
struct StationRounds {
  std::string station;
  std::string file = {};  ///< the station's file; empty if there is only one
  CheckCircles circles = CheckCircles::Both;
  std::vector<std::string> targets;
  std::vector<ObservedRound> rounds;
  std::vector<LeftOutReadings> leftOut;  ///< in the order of rounds
  std::string parted = {};               ///< sentence: why these rounds form a separate station; else empty
};

/// The lines of both faces: "lines 3 and 6".
std::string linesOf(const FacePair& pair);

/// Sorts the readings of each station into rounds and keeps the complete ones. Rounds stated in the file are
/// used; a round that recurs with the same targets counts as another round. Otherwise, if every target was
/// sighted equally often in each face, the n-th sighting of a target in a face belongs to round n. Else a
/// round ends when a target recurs in a face after most targets were sighted in both faces. A target that
/// recurs earlier, as in closing the horizon, is averaged. Rounds or targets are then dropped until every
/// round has every target; those with the largest share of missing pairs are dropped first. Rounds that show
/// the same targets at other places form a separate station (`partedByGeometry`).
std::vector<StationRounds> completeRounds(const CheckReadings& readings);

}  // namespace alidade
