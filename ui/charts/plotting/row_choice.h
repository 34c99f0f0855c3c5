#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace alidade::ui {

/// The rounds and faces that a picture has, each once and in order.
struct RowKinds {
  std::vector<int> rounds, faces;

  /// `Drawn` has a `round` and a `face`.
  template <typename Drawn>
  static RowKinds of(const std::vector<Drawn>& drawn) {
    RowKinds kinds;
    for (const Drawn& one : drawn) kinds.add(one.round, one.face);
    return kinds;
  }
  void add(int round, int face);
  bool hasTwoFaces() const { return faces.size() > 1; }
};

/// Which of them are drawn: all, or one. What a picture does not have cannot be chosen: then all are drawn.
struct RowChoice {
  std::optional<int> round = {}, face = {};

  bool operator==(const RowChoice&) const = default;
  /// What of it counts for a picture.
  RowChoice among(const RowKinds& kinds) const;
  bool takes(int ofRound, int ofFace) const {
    return (!round || *round == ofRound) && (!face || *face == ofFace);
  }
  /// "only round 2, face 1"; empty: all.
  QString text() const;
};

/// Where the marks of rounds and faces stand that share a place: side by side, in this order.
class RowSlots {
 public:
  RowSlots() = default;
  /// `choice` of `kinds`.
  RowSlots(const RowKinds& kinds, const RowChoice& choice);

  bool areApart() const { return m_count > 1; }
  /// How far off the place itself, in units of `PlotStyle::unit`; the mean of all slots is 0.
  double shift(int round, int face) const;

 private:
  std::vector<int> m_rounds, m_faces;
  std::size_t m_count = 1;
};

}  // namespace alidade::ui
