#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace alidade {

/// What an observer keys in between sightings, as a code block, a text line or a note.
struct FieldMark {
  enum class Kind {
    Axis,   ///< `number` is 0 or 180: how the axis stood for what follows
    Round,  ///< `number` of the round for what follows
    Zero,   ///< the next sighting is of the pointing zero
  };
  Kind kind = Kind::Zero;
  std::string number = {};

  bool operator==(const FieldMark&) const = default;
};

/// Reads `0`, `AXIS0`, `POS 180`, `POSITION180`, `ROUND2`, `ZERO`; capitals and blanks do not matter, and a
/// missing number may stand in `more`. Absent: it says none of these.
std::optional<FieldMark> fieldMark(std::string_view text, std::string_view more = {});

/// The name of the station that what follows was sighted from: `STATION 5`, `STN A`, `STANDPOINT`; it may
/// stand in `more`. Absent: it says none.
std::optional<std::string> stationMark(std::string_view text, std::string_view more = {});

}  // namespace alidade
