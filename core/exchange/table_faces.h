#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// The names of the faces in one table. Paired with I under a Spanish heading, D is directo; paired with R,
/// it is direct; with G, droite. CD is círculo directo if paired with CI and cercle droit with CG. Without
/// such a pair these letters are ambiguous and mean nothing.
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
