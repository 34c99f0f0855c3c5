#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// Time of any monotonic clock.
using Milliseconds = std::int64_t;

// Bytes arrive in any portions: a line in many pieces, many lines in one piece, half a line after the cable
// was pulled, a megabyte without a line end at a wrong speed. The results are whole lines, separated by CR
// LF, CR or LF, and a sentence for each dropped line.

class LineAssembler {
 public:
  /// The longest line, in bytes: over three times that of both protocols, 288 bytes for 12 words of GSI-16.
  static constexpr std::size_t longest = 1000;

  /// An incomplete line is dropped if nothing follows within `lineWithin`.
  explicit LineAssembler(Milliseconds lineWithin = 2000) : m_lineWithin(lineWithin) {}

  /// Appends the completed lines, non-empty and without line ends, and a sentence for each overlong line.
  void take(std::string_view bytes, Milliseconds now, std::vector<std::string>& lines,
            std::vector<std::string>& remarks);
  /// Drops an incomplete line after the time limit, with a sentence.
  void tick(Milliseconds now, std::vector<std::string>& remarks);
  /// The next time `tick` is needed; absent: only after further bytes.
  std::optional<Milliseconds> wakeAt() const;
  /// The length of the incomplete line in bytes.
  std::size_t pending() const { return m_line.size(); }

 private:
  Milliseconds m_lineWithin;
  Milliseconds m_last = 0;  ///< time of the last bytes
  std::string m_line;
  bool m_isTooLong = false;  ///< the rest up to the next line end belongs to a dropped line
};

/// A line for a log: control and non-ASCII characters as names or numbers, <CR>, <1B>.
std::string shownLine(std::string_view line);

}  // namespace alidade
