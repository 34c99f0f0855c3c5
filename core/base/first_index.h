#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace alidade {

/// A hash with all bits well mixed.
inline std::size_t mixedBits(std::uint64_t bits) {
  const std::uint64_t product = (bits ^ bits >> 31U) * 0x9e3779b97f4a7c15U;
  return static_cast<std::size_t>(product ^ product >> 32U);
}

/// The index of the first occurrence of each key, for up to 2³² keys. Keys come in groups, as rows do round
/// by round: as long as the groups are ascending, a key is searched only in its own group, in a small table
/// that stays in the cache; after that in all. `Hash` gives a std::size_t with well-mixed bits (`mixedBits`),
/// `Group` the value that identifies and orders groups.
template <typename Key, typename Hash, typename Group>
class FirstIndex {
 public:
  /// `most`: the maximum number of keys.
  explicit FirstIndex(std::size_t most) : m_table(leastSlots) { m_entries.reserve(most); }

  /// The index with which `key` was first inserted: this one if it is new.
  std::size_t put(const Key& key, std::size_t index) {
    if (!m_isMixed && !m_entries.empty()) {
      const auto before = Group()(m_entries.back().key), now = Group()(key);
      if (before < now) lookFrom(m_entries.size());
      if (now < before) {
        m_isMixed = true;
        lookFrom(0);
      }
    }
    Slot* slot = slotOf(key);
    if (isTaken(*slot)) return m_entries[slot->entry].index;
    if (!hasRoom()) {
      lookFrom(m_first);
      slot = slotOf(key);
    }
    *slot = {m_scope, static_cast<std::uint32_t>(m_entries.size())};
    m_entries.push_back({key, index});
    return index;
  }

 private:
  static constexpr std::size_t leastSlots = 64;

  struct Entry {
    Key key;
    std::size_t index;
  };
  /// A slot of an earlier scope is free.
  struct Slot {
    std::uint32_t scope = 0, entry = 0;
  };

  bool isTaken(const Slot& slot) const { return slot.scope == m_scope; }

  /// Is there room for a further entry? The table stays at most half full, so that a free slot is near.
  bool hasRoom() const { return 2 * (m_entries.size() + 1 - m_first) <= m_table.size(); }

  /// Fills the table with the entries from `first` on, and leaves room for another.
  void lookFrom(std::size_t first) {
    ++m_scope;
    m_first = first;
    while (!hasRoom()) m_table.resize(2 * m_table.size());
    for (std::size_t i = m_first; i < m_entries.size(); ++i)
      *slotOf(m_entries[i].key) = {m_scope, static_cast<std::uint32_t>(i)};
  }

  /// The slot of the key, or the free one for it.
  Slot* slotOf(const Key& key) {
    const std::size_t last = m_table.size() - 1;
    for (std::size_t i = Hash()(key) & last;; i = (i + 1) & last)
      if (!isTaken(m_table[i]) || m_entries[m_table[i].entry].key == key) return &m_table[i];
  }

  std::vector<Entry> m_entries;
  std::vector<Slot> m_table;
  std::size_t m_first = 0;    ///< the first entry in the table
  std::uint32_t m_scope = 1;  ///< of the occupied slots
  bool m_isMixed = false;     ///< a group followed a later one
};

}  // namespace alidade
