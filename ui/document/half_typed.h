#pragma once

#include <QObject>
#include <map>
#include <string>
#include <vector>

#include "core/base/problem.h"

namespace alidade::ui {

/// A typed text that is not committed yet.
struct HalfTypedText {
  /// A field, a cell of a row (the row after the last is a new row), or a text of a known size.
  Place place;
  /// Ids of effect and parameter if the text is for a catalogued number that has no known size yet; then
  /// `place.field` is "value", "sigma" or "from". Empty otherwise.
  std::string effect = {}, parameter = {};
  /// Point, round and face of a new row as the table showed them; in a protocol by worth they cannot be found
  /// again. Empty if the text is not for a new row.
  std::string point = {}, round = {}, face = {};
  std::string text = {};  ///< the text to be committed
  /// With the field "journal": the number of entries from `place.reading` on that the text gives a reason
  /// for.
  std::size_t count = 1;

  bool operator==(const HalfTypedText&) const = default;
};

/// The unfinished texts of one session. Each entry, a widget, reports its own text.
class HalfTyped : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Records that `entry` is open with this text; `isChanged`: the text differs from the session.
  void set(const QObject* entry, HalfTypedText text, bool isChanged);
  /// Likewise for an entry that is for several places.
  void set(const QObject* entry, std::vector<HalfTypedText> texts, bool isChanged);
  /// Removes the text of `entry`, which was committed, cancelled or destroyed.
  void clear(const QObject* entry);

  /// The texts that differ from the session.
  std::vector<HalfTypedText> texts() const;
  bool isEmpty() const { return texts().empty(); }
  /// True if an entry of a position is open, changed or not.
  bool isOpenInPosition() const;

 signals:
  void changed();

 private:
  struct Open {
    std::vector<HalfTypedText> texts;
    bool isChanged = false;
  };

  std::map<const QObject*, Open> m_open;
};

}  // namespace alidade::ui
