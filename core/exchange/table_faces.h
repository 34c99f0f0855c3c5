#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// The names of the faces in one table. D means directo with I under a Spanish heading, direct with R, and
/// droite with G. CD means círculo directo with CI, and cercle droit with CG. Without its counterpart in the
/// table, D or CD is ambiguous and means nothing.
class FaceWords {
 public:
  FaceWords() = default;
  FaceWords(const std::vector<std::string>& cells, bool isSpanish);

  /// "1" or "2"; a cell that names no face is returned unchanged.
  std::string of(const std::string& cell) const;

 private:
  bool has(std::string_view word) const;

  std::vector<std::string> m_letters;  ///< the ambiguous names that occur in the cells
  bool m_isSpanish = false;
};

}  // namespace alidade
