#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace alidade {

/// A hash of which every bit counts.
inline std::size_t mixedBits(std::uint64_t bits) {
  const std::uint64_t product = (bits ^ bits >> 31U) * 0x9e3779b97f4a7c15U;
  return static_cast<std::size_t>(product ^ product >> 32U);
}

/// Under which index each of many keys came first, up to 2³² of them. They come in groups, as rows do round
/// by round: as long as no group comes before one that was there, a key is looked for in its own alone, in a
/// table so small that it stays near; from then on among all. `Hash` gives a std::size_t whose every bit
/// counts (`mixedBits`), `Group` what groups are told apart and ordered by.
template <typename Key, typename Hash, typename Group>
class FirstIndex {
 public:
  /// `most`: so many keys are put in at most.
  explicit FirstIndex(std::size_t most) : m_table(leastSlots) { m_entries.reserve(most); }

  /// The index under which `key` was put in first: this one where it is new.
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
  /// Of an earlier scope: free.
  struct Slot {
    std::uint32_t scope = 0, entry = 0;
  };

  bool isTaken(const Slot& slot) const { return slot.scope == m_scope; }

  /// For a further entry: half full at most, so that a free slot is never far.
  bool hasRoom() const { return 2 * (m_entries.size() + 1 - m_first) <= m_table.size(); }

  /// The table holds the entries from there on, and has room for another.
  void lookFrom(std::size_t first) {
    ++m_scope;
    m_first = first;
    while (!hasRoom()) m_table.resize(2 * m_table.size());
    for (std::size_t i = m_first; i < m_entries.size(); ++i)
      *slotOf(m_entries[i].key) = {m_scope, static_cast<std::uint32_t>(i)};
  }

  /// That of the key, or the free one where it belongs.
  Slot* slotOf(const Key& key) {
    const std::size_t last = m_table.size() - 1;
    for (std::size_t i = Hash()(key) & last;; i = (i + 1) & last)
      if (!isTaken(m_table[i]) || m_entries[m_table[i].entry].key == key) return &m_table[i];
  }

  std::vector<Entry> m_entries;
  std::vector<Slot> m_table;
  std::size_t m_first = 0;    ///< entry from which on the table holds them
  std::uint32_t m_scope = 1;  ///< of the slots that are taken
  bool m_isMixed = false;     ///< a group came before one that was there
};

}  // namespace alidade
