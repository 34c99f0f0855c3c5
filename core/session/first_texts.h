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

/// The first entered texts of a row's changed fields, by the names of the fields in the session file. An
/// empty object, as in almost every row, allocates no memory; copies share their content.
class FirstTexts {
 public:
  using Texts = boost::container::small_flat_map<std::string, std::string, 1, std::less<>>;

  const Texts& all() const {
    static const Texts none;
    return m_texts ? *m_texts : none;
  }
  bool empty() const { return !m_texts; }

  /// Absent if the field was not changed.
  std::optional<std::string> of(std::string_view field) const {
    const auto found = all().find(field);
    return found == all().end() ? std::nullopt : std::optional(found->second);
  }

  void set(std::string_view field, std::string text) {
    constexpr std::size_t afterTheFirst = 6;  // enough for a cleared row; a single text is stored inline
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
  /// Returns the texts for modification: makes a copy if they are shared.
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
