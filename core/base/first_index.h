#pragma once

#include <cstddef>
#include <vector>

namespace alidade {

/// Under which index each of many keys came first. One table, without a piece of memory for each key, which
/// is what takes the time with 10⁵ of them. `Key` has ==; `Hash` gives a std::size_t whose every bit counts.
template <typename Key, typename Hash>
class FirstIndex {
 public:
  /// `most`: so many keys are put in at most.
  explicit FirstIndex(std::size_t most) {
    std::size_t slots = 2;
    while (slots < 2 * most) slots *= 2;
    m_slots.resize(slots);
  }

  /// The index under which `key` was put in first: this one where it is new.
  std::size_t put(const Key& key, std::size_t index) {
    const std::size_t last = m_slots.size() - 1;
    for (std::size_t i = Hash()(key) & last;; i = (i + 1) & last) {
      Slot& slot = m_slots[i];
      if (!slot.isTaken) {
        slot = {key, index, true};
        return index;
      }
      if (slot.key == key) return slot.index;
    }
  }

 private:
  struct Slot {
    Key key{};
    std::size_t index = 0;
    bool isTaken = false;
  };

  std::vector<Slot> m_slots;
};

}  // namespace alidade
