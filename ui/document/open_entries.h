#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/place.h"
#include "ui/document/readings_patch.h"

namespace alidade::ui {

/// Which entries are still being made, so that typing them again is no change of an observation: the cells of
/// one row, or one pointing zero, until anything else is entered; the fields of the forms until the session
/// is saved. All others stand.
class OpenEntries {
 public:
  /// Nothing is open any more: the session was saved, or undo went over it.
  void close();
  void closeRow() { m_row.reset(); }

  bool isOpen(std::size_t position, std::size_t row, ReadingColumn column) const;
  bool isOpen(const Place& field) const;

  /// What the patch, about to be made, leaves open.
  void enter(std::size_t position, const std::vector<Reading>& rows, const ReadingsPatch& patch);
  void enter(const Place& field, bool wasEmpty);

 private:
  struct Row {
    std::size_t position = 0, row = 0;
    std::set<ReadingColumn> columns = {};
  };
  using FieldKey = std::pair<std::string, std::optional<std::size_t>>;

  std::optional<Row> m_row;
  std::optional<FieldKey> m_zero;
  std::set<FieldKey> m_fields;
  bool m_isNew = true;  ///< the session is in no file: its forms are still being filled in
};

}  // namespace alidade::ui
