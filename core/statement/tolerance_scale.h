#pragma once

#include <string>

namespace alidade {

/// The result on a scale that begins at zero: the size of the value, its interval and the limit. Lengths in
/// mm, ≥ 0.
struct ToleranceScale {
  double size = 0;        ///< |value|
  double expanded = 0;    ///< U, finite
  double tolerance = 1;   ///< > 0
  std::string name = {};  ///< what is shown: "|Δd| ± U"
  int decimals = 2;       ///< of value and U as written

  double low() const { return size > expanded ? size - expanded : 0; }
  double high() const { return size + expanded; }
  /// The end of the scale, somewhat beyond limit and interval.
  double end() const;
};

/// "0 =====[==|--]------:----  2.5 mm": `=` up to the size, `|` at the size, brackets at the ends of the
/// interval, a colon at the tolerance; the figure is the tolerance. The scale has `width` characters, ≥ 10.
std::string scaleText(const ToleranceScale& scale, int width);

}  // namespace alidade
