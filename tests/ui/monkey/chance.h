#pragma once

#include <QStringList>
#include <random>

namespace alidade::ui {

/// Random choices of a monkey: equal for the same seed on every machine.
class Chance {
 public:
  explicit Chance(unsigned seed) : m_random(seed) {}

  int below(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool oneIn(int count) { return below(count) == 0; }
  QChar of(const QString& characters) { return characters.at(below(static_cast<int>(characters.size()))); }
  template <typename List>
  auto of(const List& list) {
    return *std::next(std::begin(list), below(static_cast<int>(std::size(list))));
  }

 private:
  std::mt19937 m_random;
};

}  // namespace alidade::ui
