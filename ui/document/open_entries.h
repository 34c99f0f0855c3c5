#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/problem.h"
#include "ui/document/readings_patch.h"

namespace alidade::ui {

/// Open entries: retyping an open entry is not a recorded change. Filled cells of one row, or one text of a
/// pointing zero, stay open until another entry is made. Form fields stay open until the next save.
class OpenEntries {
 public:
  /// Closes all entries; called when the session was saved or comes from a file.
  void close();
  void closeRow() { m_row.reset(); }

  bool isOpen(std::size_t position, std::size_t row, ReadingColumn column) const;
  bool isOpen(const Place& field) const;

  /// Updates the open entries for a patch about to be made.
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
  bool m_isNew = true;  ///< the session is unsaved: its forms are still being filled in
};

}  // namespace alidade::ui
