#include "core/exchange/table_column.h"

#include <algorithm>

namespace alidade {

namespace {

constexpr std::string_view faceTwoEnding = "_2";
constexpr std::string_view partEndings[] = {"", "_minutes", "_seconds"};

bool takeEnding(std::string_view& text, std::string_view ending) {
  if (!text.ends_with(ending)) return false;
  text.remove_suffix(ending.size());
  return true;
}

}  // namespace

std::string TableColumn::key() const {
  if (!field) return std::string(otherKeys[static_cast<std::size_t>(other)]);
  std::string name(field->key);
  if (isFaceTwo) name += faceTwoEnding;
  return name.append(partEndings[static_cast<std::size_t>(part)]);
}

std::optional<TableColumn> tableColumn(std::string_view key) {
  const auto* const found = std::find(TableColumn::otherKeys.begin(), TableColumn::otherKeys.end(), key);
  if (found != TableColumn::otherKeys.end())
    return TableColumn{nullptr, static_cast<TableColumn::Other>(found - TableColumn::otherKeys.begin())};
  TableColumn column;
  for (const AnglePart part : {AnglePart::Minutes, AnglePart::Seconds})
    if (takeEnding(key, partEndings[static_cast<std::size_t>(part)])) column.part = part;
  column.isFaceTwo = takeEnding(key, faceTwoEnding);
  column.field = rowFieldNamed(key);
  if (!column.field) return std::nullopt;
  const bool isPlain = column.part == AnglePart::Degrees && !column.isFaceTwo;
  const bool isPossible = isPlain || (isAngle(*column.field) && (column.isCircle() || !column.isFaceTwo));
  return isPossible ? std::optional(column) : std::nullopt;
}

}  // namespace alidade
