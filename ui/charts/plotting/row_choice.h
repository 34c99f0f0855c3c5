#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "ui/charts/plotting/legend.h"

class QAction;
class QMenu;

namespace alidade::ui {

/// The rounds and faces of a picture, ascending, without repetition.
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

/// The rounds and faces drawn: all, or one. A round or face that the picture lacks counts as all.
struct RowChoice {
  std::optional<int> round = {}, face = {};

  bool operator==(const RowChoice&) const = default;
  /// The part of the choice available in a picture.
  RowChoice among(const RowKinds& kinds) const;
  bool takes(int ofRound, int ofFace) const {
    return (!round || *round == ofRound) && (!face || *face == ofFace);
  }
  /// "only round 2, face 1"; empty: all.
  QString text() const;
};

/// Places marks of several rounds and faces at one place side by side: by round, then by face.
class RowSlots {
 public:
  RowSlots() = default;
  /// A slot for each round and face of `kinds` that `choice` includes.
  RowSlots(const RowKinds& kinds, const RowChoice& choice);

  bool areApart() const { return m_count > 1; }
  /// The shift from the place itself, in units of `PlotStyle::unit`; the mean of all slots is 0.
  double shift(int round, int face) const;

 private:
  std::vector<int> m_rounds, m_faces;
  std::size_t m_count = 1;
};

/// Legend entries on rounds and faces: the stroke of face 2, rounds side by side, and the choice if only some
/// are drawn. Empty for one round in face 1.
std::vector<LegendEntry> rowEntries(const PlotStyle& style, const RowKinds& kinds, const RowChoice& choice,
                                    bool areApart);

/// Adds a checkable entry, alone or as one of several.
QAction* addChoice(QMenu& menu, const QString& text, bool isChosen, const std::function<void()>& choose);

/// Adds menus for the rounds and for the faces in `kinds` if there are several. `choose` receives the choice.
void addRowChoices(QMenu& menu, const RowKinds& kinds, const RowChoice& choice,
                   const std::function<void(const RowChoice&)>& choose);

}  // namespace alidade::ui
