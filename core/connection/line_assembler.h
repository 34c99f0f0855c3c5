#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// Of any clock that only goes forward.
using Milliseconds = std::int64_t;

// Bytes come over a line as they like: a line in many pieces, many lines in one piece, half a line because
// somebody pulled the cable, a megabyte without an end because the speed is wrong. Out of this come whole
// lines, parted by CR LF, CR or LF, and a sentence for each of the others.

class LineAssembler {
 public:
  /// No line of either protocol has a third of it: GSI-16 with 12 words has 288 characters.
  static constexpr std::size_t longest = 1000;

  /// What is half there when nothing more comes within `lineWithin` is no line any more.
  explicit LineAssembler(Milliseconds lineWithin = 2000) : m_lineWithin(lineWithin) {}

  /// Appends the lines that are whole now, without their ends and never empty, and a sentence for each that
  /// was too long.
  void take(std::string_view bytes, Milliseconds now, std::vector<std::string>& lines,
            std::vector<std::string>& remarks);
  /// Drops a line whose rest did not come, with a sentence.
  void tick(Milliseconds now, std::vector<std::string>& remarks);
  /// When `tick` has something to do; absent: not before more comes.
  std::optional<Milliseconds> wakeAt() const;
  /// Of what has no end yet.
  std::size_t pending() const { return m_line.size(); }

 private:
  Milliseconds m_lineWithin;
  Milliseconds m_last = 0;  ///< when something came
  std::string m_line;
  bool m_isTooLong = false;  ///< all up to the next end belongs to a line that was dropped
};

/// A line for a log: control characters and what is no ASCII as their names or numbers, <CR>, <1B>.
std::string shownLine(std::string_view line);

}  // namespace alidade
