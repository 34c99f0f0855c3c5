#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// The faces as the cells of one table call them. D is directo beside I where the heading is Spanish, direct
/// beside R, droite beside G; CD is círculo directo beside CI and cercle droit beside CG. Alone they mean
/// nothing.
class FaceWords {
 public:
  FaceWords() = default;
  FaceWords(const std::vector<std::string>& cells, bool isSpanish);

  /// "1" or "2"; a cell that means none as it is.
  std::string of(const std::string& cell) const;

 private:
  bool has(std::string_view word) const;

  std::vector<std::string> m_letters;  ///< that stand in the cells, of those that may mean several things
  bool m_isSpanish = false;
};

}  // namespace alidade
