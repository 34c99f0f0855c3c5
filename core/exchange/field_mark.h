#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace alidade {

/// A mark that an observer keys in between sightings, as a code block, a text line or a note.
struct FieldMark {
  enum class Kind {
    Axis,   ///< `number` is 0 or 180: the axis angle of the sightings that follow
    Round,  ///< `number` is the round of the sightings that follow
    Zero,   ///< the next sighting is of the pointing zero
  };
  Kind kind = Kind::Zero;
  std::string number = {};

  bool operator==(const FieldMark&) const = default;
};

/// Reads `0`, `AXIS0`, `POS 180`, `POSITION180`, `ROUND2` or `ZERO`, in any case and with any blanks; a
/// missing number may be in `more`. Absent for other texts.
std::optional<FieldMark> fieldMark(std::string_view text, std::string_view more = {});

/// The name of the station of the sightings that follow: `STATION 5`, `STN A`, `STANDPOINT`; a
/// name missing in `text` may be in `more`. Absent for other texts.
std::optional<std::string> stationMark(std::string_view text, std::string_view more = {});

}  // namespace alidade
