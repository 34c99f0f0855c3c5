#pragma once

#include <cstddef>
#include <vector>

namespace alidade {

/// Under which index each of many keys came first. While the keys come in ascending order they are only
/// listed; from the first that does not, one table holds them, without a piece of memory for each. `Key` has
/// == and <; `Hash` gives a std::size_t whose every bit counts.
template <typename Key, typename Hash>
class FirstIndex {
 public:
  /// `most`: so many keys are put in at most.
  explicit FirstIndex(std::size_t most) : m_most(most) { m_ascending.reserve(most); }

  /// The index under which `key` was put in first: this one where it is new.
  std::size_t put(const Key& key, std::size_t index) {
    if (m_table.empty()) {
      if (m_ascending.empty() || m_ascending.back().key < key) {
        m_ascending.push_back({key, index});
        return index;
      }
      makeTable();
    }
    return putInTable(key, index);
  }

 private:
  struct Entry {
    Key key;
    std::size_t index;
  };
  struct Slot {
    Entry entry{};
    bool isTaken = false;
  };

  /// At most half full, so that a free slot is never far.
  void makeTable() {
    std::size_t slots = 2;
    while (slots < 2 * m_most) slots *= 2;
    m_table.resize(slots);
    for (const Entry& entry : m_ascending) putInTable(entry.key, entry.index);
    m_ascending = {};
  }

  std::size_t putInTable(const Key& key, std::size_t index) {
    const std::size_t last = m_table.size() - 1;
    for (std::size_t i = Hash()(key) & last;; i = (i + 1) & last) {
      Slot& slot = m_table[i];
      if (!slot.isTaken) {
        slot = {{key, index}, true};
        return index;
      }
      if (slot.entry.key == key) return slot.entry.index;
    }
  }

  std::size_t m_most;
  std::vector<Entry> m_ascending;
  std::vector<Slot> m_table;
};

}  // namespace alidade
