#include "ui/document/half_typed.h"

#include <algorithm>
#include <utility>

namespace alidade::ui {

void HalfTyped::set(const QObject* entry, HalfTypedText text, bool isChanged) {
  set(entry, std::vector{std::move(text)}, isChanged);
}

void HalfTyped::set(const QObject* entry, std::vector<HalfTypedText> texts, bool isChanged) {
  const auto [open, isNew] = m_open.try_emplace(entry);
  if (isNew) connect(entry, &QObject::destroyed, this, [this, entry] { clear(entry); });
  open->second = {std::move(texts), isChanged};
  emit changed();
}

void HalfTyped::clear(const QObject* entry) {
  if (m_open.erase(entry) == 0) return;
  entry->disconnect(this);
  emit changed();
}

std::vector<HalfTypedText> HalfTyped::texts() const {
  std::vector<HalfTypedText> texts;
  for (const auto& [entry, open] : m_open)
    if (open.isChanged) texts.insert(texts.end(), open.texts.begin(), open.texts.end());
  return texts;
}

bool HalfTyped::isOpenInPosition() const {
  const auto isInPosition = [](const HalfTypedText& text) { return text.place.position.has_value(); };
  return std::ranges::any_of(
      m_open, [&](const auto& open) { return std::ranges::any_of(open.second.texts, isInPosition); });
}

}  // namespace alidade::ui
