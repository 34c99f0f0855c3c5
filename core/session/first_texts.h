#pragma once

#include <boost/container/flat_map.hpp>
#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/sole_holder.h"

namespace alidade {

/// The texts of a row as they were first entered, of those fields that were changed since; by their names in
/// the session file. Empty in almost every row, where it takes no room; copies share what they hold.
class FirstTexts {
 public:
  using Texts = boost::container::small_flat_map<std::string, std::string, 1, std::less<>>;

  const Texts& all() const {
    static const Texts none;
    return m_texts ? *m_texts : none;
  }
  bool empty() const { return !m_texts; }

  /// Absent where the field stands as it was entered.
  std::optional<std::string> of(std::string_view field) const {
    const auto found = all().find(field);
    return found == all().end() ? std::nullopt : std::optional(found->second);
  }

  void set(std::string_view field, std::string text) {
    constexpr std::size_t afterTheFirst = 6;  // a row that is cleared has so many; the first takes no room
    Texts& texts = own();
    if (texts.size() == 1) texts.reserve(afterTheFirst);
    texts.insert_or_assign(std::string(field), std::move(text));
  }

  void drop(std::string_view field) {
    if (!all().contains(field)) return;
    Texts& texts = own();
    texts.erase(texts.find(field));
    if (texts.empty()) m_texts = nullptr;
  }

  bool operator==(const FirstTexts& other) const { return all() == other.all(); }

 private:
  /// To be changed: where others share them, a copy.
  Texts& own() {
    if (!m_texts)
      m_texts = std::make_shared<Texts>();
    else if (!isSoleHolder(m_texts))
      m_texts = std::make_shared<Texts>(*m_texts);
    return *m_texts;
  }

  std::shared_ptr<Texts> m_texts;  ///< null: none
};

}  // namespace alidade
