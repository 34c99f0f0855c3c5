#pragma once

#include <QObject>
#include <map>
#include <string>
#include <vector>

#include "core/base/place.h"

namespace alidade::ui {

/// A text that is typed and not handed in yet.
struct HalfTypedText {
  /// A field; a cell of a row, where the row after the last is a new one; a text of a known size.
  Place place;
  /// Ids of a number of the catalogue of which nothing is known yet; `place.field` is then "value", "sigma"
  /// or "from". Empty otherwise.
  std::string effect = {}, parameter = {};
  std::string text = {};  ///< as it would be handed in

  bool operator==(const HalfTypedText&) const = default;
};

/// What is being typed into the entries of one session. Each entry tells of its own text.
class HalfTyped : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// `entry` is open with this text; `isChanged` where it is not what the session holds.
  void set(const QObject* entry, HalfTypedText text, bool isChanged);
  /// `entry` was handed in, given up or destroyed.
  void clear(const QObject* entry);

  /// Those that the session does not hold.
  std::vector<HalfTypedText> texts() const;
  bool isEmpty() const { return texts().empty(); }
  /// Is an entry of a position open, changed or not?
  bool isOpenInPosition() const;

 signals:
  void changed();

 private:
  struct Open {
    HalfTypedText text;
    bool isChanged = false;
  };

  std::map<const QObject*, Open> m_open;
};

}  // namespace alidade::ui
