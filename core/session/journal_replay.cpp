#include "core/session/journal_replay.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/sha256.h"
#include "core/session/json_text.h"
#include "core/session/row_fields.h"
#include "core/session/value_text.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* firstTexts = "as_read";
constexpr const char* flagName = "excluded";
constexpr std::string_view describedInWords[] = {"instrument.known", "device.known",  "instrument.record",
                                                 "protocol",         "model.effects", "own_effects"};

/// Removes `name`, a number and `]` from the start of `text`; returns the number, absent if they are missing.
std::optional<std::size_t> takeIndex(std::string_view& text, std::string_view name) {
  if (!text.starts_with(name)) return {};
  std::string_view rest = text.substr(name.size());
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), index);
  if (error != std::errc() || end == rest.data() + rest.size() || *end != ']') return {};
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()) + 1);
  if (rest.starts_with('.')) rest.remove_prefix(1);
  text = rest;
  return index;
}

ValueKind kindOfField(const std::string& field) {
  if (field.ends_with(".return_code")) return ValueKind::Number;
  const bool isCircle = field.ends_with(".horizontal") || field.ends_with(".vertical");
  if (field.starts_with("pointing_zero.") && isCircle) return ValueKind::Angle;
  for (const std::string_view unit : {"_mm", "_arcsec", "_c", "_k", "_deg", "coverage"})
    if (field.ends_with(unit)) return ValueKind::Number;
  return ValueKind::Text;
}

std::string textIn(const Json& object, const std::string& key, ValueKind kind) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  return textOf(*found, kind).value_or(found->dump());
}

/// A key as a part of a JSON pointer.
std::string pointed(const std::string& key) {
  std::string part = "/";
  for (const char c : key) c == '~' ? part += "~0" : c == '/' ? part += "~1" : part += c;
  return part;
}

std::string usedText(const Json& row) {
  const auto found = row.find(flagName);
  return found != row.end() && *found == true ? "excluded" : "used";
}

std::string cellTextOf(const Json& row, const std::string& field) {
  return field == flagName ? usedText(row) : textIn(row, field, kindOfCell(field));
}

Reading readingOf(const Json& row) {
  Reading reading;
  for (const RowField& field : rowFields)
    if (field.text) reading.*field.text = textIn(row, std::string(field.key), kindOf(field));
  reading.excluded = usedText(row) == "excluded";
  return reading;
}

std::string rowTextOf(const Json& row) {
  return rowText(readingOf(row));
}

/// Does the row have all of `texts`, apart from a note?
bool hasTexts(const Json& row, const Json& texts) {
  for (const auto& [field, value] : texts.items())
    if (field != "note" && cellTextOf(row, field) != cellTextOf(texts, field)) return false;
  return true;
}

/// Index of the only row for which `isIt` is true; absent if no row or several rows fulfil it.
template <typename IsIt>
std::optional<std::size_t> onlyRow(const Json& rows, const IsIt& isIt) {
  const auto found = std::find_if(rows.begin(), rows.end(), isIt);
  const bool isOne = found != rows.end() && std::find_if(std::next(found), rows.end(), isIt) == rows.end();
  return isOne ? std::optional(static_cast<std::size_t>(found - rows.begin())) : std::nullopt;
}

/// The inverse of `rowText`: fields have a fixed order, and a value ends at the next field.
Json rowOfText(std::string_view text) {
  constexpr std::string_view excluded = ", excluded";
  Json row = Json::object();
  if (text.ends_with(excluded)) {
    row[flagName] = true;
    text.remove_suffix(excluded.size());
  }
  const auto headOf = [](const RowField& field) { return std::string(field.key) + ' '; };
  for (auto field = rowFields.begin(); field != rowFields.end(); ++field) {
    if (!field->text || !text.starts_with(headOf(*field))) continue;
    text.remove_prefix(headOf(*field).size());
    std::size_t end = text.size();
    for (auto later = std::next(field); later != rowFields.end(); ++later)
      if (later->text) end = std::min(end, text.find(", " + headOf(*later)));
    row[std::string(field->key)] = valueOf(std::string(text.substr(0, end)), kindOf(*field));
    text.remove_prefix(std::min(text.size(), end + 2));
  }
  return row;
}

/// Is a member with this value equivalent to a missing member?
bool saysNothing(const Json& value) {
  const bool isEmptyText = value.is_string() && value.get_ref<const std::string&>().empty();
  return isEmptyText || value == false || value.is_null();
}

/// Collects each non-empty value by its place, without first texts.
void flatten(const Json& value, const std::string& place, std::map<std::string, std::string>& texts) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      if (key != firstTexts) flatten(member, place.empty() ? key : place + '.' + key, texts);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      flatten(value[i], place + '[' + std::to_string(i) + ']', texts);
  } else {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (!saysNothing(value)) texts[place] = text;
  }
}

}  // namespace

JournalReplay::JournalReplay(const std::vector<JournalEntry>& journal, const std::string& content,
                             RowOrder order)
    : m_journal(journal),
      m_order(order),
      m_content(std::make_unique<Json>(Json::parse(content, nullptr, false))) {}

JournalReplay::~JournalReplay() = default;

std::optional<JournalReplay::Path> JournalReplay::pathOf(const std::string& place) {
  std::string_view rest = place;
  Path path;
  path.position = takeIndex(rest, "positions[");
  if (path.position) path.reading = takeIndex(rest, "readings[");
  path.field = rest;
  return place.empty() ? std::nullopt : std::optional(path);
}

bool JournalReplay::isSealedBefore(std::size_t entry) const {
  return std::any_of(m_journal.begin(), m_journal.begin() + static_cast<std::ptrdiff_t>(entry),
                     [](const JournalEntry& one) { return one.why == journal_reasons::sealed; });
}

void JournalReplay::contradict(const std::string& place, const std::string& recorded,
                               const std::string& held) {
  m_isExact = false;
  const auto isOfPlace = [&](const JournalContradiction& one) { return one.place == place; };
  if (std::ranges::none_of(m_contradictions, isOfPlace)) m_contradictions.push_back({place, recorded, held});
}

void JournalReplay::takeBack(std::size_t index) {
  if (index >= m_taken) return;
  m_taken = m_order == RowOrder::FirstFirst ? firstOfEdit(index) : index;
  for (std::size_t i = m_taken; i <= index; ++i) takeBackOne(i);
}

/// The first entry of the edit that `last` ends. In journals of version 0, one deletion of rows has an
/// entry for each row with rising indices, a restoration with falling ones. Any other entry is one edit.
std::size_t JournalReplay::firstOfEdit(std::size_t last) const {
  const auto isBefore = [&](const JournalEntry& one, const JournalEntry& next) {
    const auto a = pathOf(one.place), b = pathOf(next.place);
    const bool isRow = a && b && a->reading && b->reading && a->field.empty() && b->field.empty();
    if (!isRow || a->position != b->position || one.at != next.at || one.why != next.why) return false;
    const bool isUndone = one.why == journal_reasons::undone;
    const bool areGone = one.to.empty() && next.to.empty(), haveCome = one.from.empty() && next.from.empty();
    return isUndone ? haveCome && *a->reading > *b->reading : areGone && *a->reading < *b->reading;
  };
  std::size_t first = last;
  while (first > 0 && isBefore(m_journal[first - 1], m_journal[first])) --first;
  return first;
}

void JournalReplay::takeBackOne(std::size_t index) {
  if (m_isOpaque) return;
  const JournalEntry& entry = m_journal[index];
  const auto path = pathOf(entry.place);
  if (!path || entry.why == journal_reasons::imported) {
    m_isOpaque = true;
  } else if (const auto described = std::ranges::find_if(
                 describedInWords, [&](std::string_view name) { return path->field.starts_with(name); });
             described != std::end(describedInWords)) {
    m_describedPlaces.emplace(*described);
    m_isExact = false;
  } else if (path->reading) {
    path->field.empty() ? takeBackRow(*path, index) : takeBackCell(*path, index);
  } else if (path->position &&
             (path->field.empty() || path->field == "readings" || entry.why == journal_reasons::deleted)) {
    m_isOpaque = true;
  } else {
    takeBackText(*path, entry);
  }
}

JournalReplay::Json* JournalReplay::rowsOf(const Path& path) {
  Json& positions = (*m_content)["positions"];
  if (!positions.is_array() || *path.position >= positions.size()) return nullptr;
  Json& rows = positions[*path.position]["readings"];
  return rows.is_array() ? &rows : nullptr;
}

/// The only row with an entry's point, round and face. Before the first seal, an entry's index is unreliable,
/// as rows added while empty have no entry.
JournalReplay::Json* JournalReplay::rowOf(const Path& path, const JournalEntry& entry) {
  Json* rows = rowsOf(path);
  if (!rows) return nullptr;
  const auto isIt = [&](const Json& row) {
    const std::pair<const char*, const std::string&> names[] = {
        {"point", entry.point}, {"round", entry.round}, {"face", entry.face}};
    return std::ranges::all_of(names, [&](const auto& name) {
      const std::string& text = path.field == name.first ? entry.to : name.second;
      return cellTextOf(row, name.first) == filedText(text, kindOfCell(name.first));
    });
  };
  const auto only = onlyRow(*rows, isIt);
  return only ? &(*rows)[*only] : nullptr;
}

/// Does a row of any position have the text? Before the first seal, rows move to another position without an
/// entry; `rowOf` may then find another row with the same point, round and face.
bool JournalReplay::isAnywhere(const std::string& field, const std::string& text) const {
  const auto positions = m_content->find("positions");
  if (positions == m_content->end() || !positions->is_array()) return false;
  return std::ranges::any_of(*positions, [&](const Json& position) {
    const auto rows = position.find("readings");
    return rows != position.end() &&
           std::ranges::any_of(*rows, [&](const Json& row) { return cellTextOf(row, field) == text; });
  });
}

void JournalReplay::takeBackCell(const Path& path, std::size_t index) {
  const JournalEntry& entry = m_journal[index];
  const bool isSealed = isSealedBefore(index);
  Json* row = isSealed ? nullptr : rowOf(path, entry);
  if (isSealed) {
    Json* rows = rowsOf(path);
    if (!rows || *path.reading >= rows->size()) return contradict(entry.place, entry.to, {});
    row = &(*rows)[*path.reading];
  }
  if (!row) {
    m_isExact = false;
    return;
  }
  const std::string held = cellTextOf(*row, path.field);
  const ValueKind kind = kindOfCell(path.field);
  const std::string recorded = filedText(entry.to, kind);
  // Before the first seal, a different text alone proves nothing: the cell may have been filled in later, or
  // be in another row. Only a cell with a first text contradicts the entry.
  const auto marks = row->find(firstTexts);
  const bool isMarked = marks != row->end() && marks->contains(path.field);
  if (held != recorded && (isSealed || (isMarked && !entry.to.empty()))) {
    if (!isSealed && (isAnywhere(path.field, recorded) || isLaterLeft(path.field, recorded, index))) {
      m_isExact = false;
      return;
    }
    contradict(entry.place, entry.to, held);
  }
  const std::string pointer = "/positions/" + std::to_string(*path.position) + "/readings/" +
                              std::to_string(*path.reading) + pointed(path.field);
  if (path.field == flagName) {
    (*row)[flagName] = entry.from == "excluded";
    if (entry.from != "excluded") m_absent.push_back(pointer);
    return;
  }
  if (entry.to.empty()) m_isExact = false;  // its key was removed, so the order of the keys is lost
  (*row)[path.field] = valueOf(entry.from, kind);
  if (entry.from.empty()) m_absent.push_back(pointer);
  if (!isMarked) return;
  Json& firsts = (*row)[firstTexts];
  if (textIn(firsts, path.field, kind) == filedText(entry.from, kind)) firsts.erase(path.field);
  if (firsts.empty()) row->erase(firstTexts);
}

/// Did an entry after `index` change this text in any row? Before the first seal, that entry may still be
/// unreverted, since its row was not found.
bool JournalReplay::isLaterLeft(const std::string& field, const std::string& text, std::size_t index) const {
  const ValueKind kind = kindOfCell(field);
  const std::string end = "." + field;
  const auto first = m_journal.begin() + static_cast<std::ptrdiff_t>(index) + 1;
  return std::any_of(first, m_journal.end(), [&](const JournalEntry& later) {
    return later.place.ends_with(end) && filedText(later.from, kind) == text;
  });
}

/// `rowOfEntry` before the first seal: texts are filled in, notes change, and empty rows come and go without
/// an entry, so the row may have another index. An entry without texts describes an empty row.
JournalReplay::EntryRow JournalReplay::openRow(const Json& rows, const Path& path, std::size_t index) const {
  const Json recorded = rowOfText(m_journal[index].to);
  const bool isBlankRow = isBlank(readingOf(recorded));
  const auto isIt = [&](const Json& row) {
    return isBlankRow ? isBlank(readingOf(row)) : hasTexts(row, recorded);
  };
  if (*path.reading < rows.size() && isIt(rows[*path.reading])) return {path.reading, true};
  if (isBlankRow || std::ranges::any_of(rows, isIt)) return {onlyRow(rows, isIt), true};
  Json lasting = recorded;  // without the texts that a later entry changed
  for (const auto& [field, value] : recorded.items())
    if (isLaterLeft(field, cellTextOf(recorded, field), index)) lasting.erase(field);
  return {{}, std::ranges::any_of(rows, [&](const Json& row) { return hasTexts(row, lasting); })};
}

/// The row that the entry at `index` describes.
JournalReplay::EntryRow JournalReplay::rowOfEntry(const Json& rows, const Path& path,
                                                  std::size_t index) const {
  if (!isSealedBefore(index)) return openRow(rows, path, index);
  const bool isThere = *path.reading < rows.size();
  const bool isTrue = isThere && rowTextOf(rows[*path.reading]) == rowTextOf(rowOfText(m_journal[index].to));
  return {isThere ? path.reading : std::nullopt, isTrue};
}

void JournalReplay::takeBackRow(const Path& path, std::size_t index) {
  const JournalEntry& entry = m_journal[index];
  Json* rows = rowsOf(path);
  if (!rows) return contradict(entry.place, entry.to, {});
  const auto at = [&](std::size_t row) { return rows->begin() + static_cast<std::ptrdiff_t>(row); };
  if (!entry.to.empty()) {
    const EntryRow found = rowOfEntry(*rows, path, index);
    const bool isThere = *path.reading < rows->size();
    if (!found.isTrue)
      contradict(entry.place, entry.to, isThere ? rowTextOf((*rows)[*path.reading]) : std::string());
    m_isExact = m_isExact && found.row;
    if (!found.row) return;
    m_gone.push_back((*rows)[*found.row]);
    rows->erase(at(*found.row));
    return;
  }
  const auto moved = std::ranges::find_if(
      m_gone, [&](const Json& row) { return rowTextOf(row) == rowTextOf(rowOfText(entry.from)); });
  m_isExact = m_isExact && moved != m_gone.end();
  rows->insert(at(std::min(*path.reading, rows->size())),
               moved != m_gone.end() ? *moved : rowOfText(entry.from));
}

void JournalReplay::takeBackText(const Path& path, const JournalEntry& entry) {
  Json* object = m_content.get();
  std::string pointer;
  if (path.position) {
    Json& positions = (*m_content)["positions"];
    if (!positions.is_array() || *path.position >= positions.size())
      return contradict(entry.place, entry.to, {});
    object = &positions[*path.position];
    pointer = "/positions/" + std::to_string(*path.position);
  }
  std::string key = path.field;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.')) {
    if (!object->contains(key.substr(0, dot))) m_isExact = false;
    object = &(*object)[key.substr(0, dot)];
    pointer += pointed(key.substr(0, dot));
    key.erase(0, dot + 1);
    if (!object->is_object() && !object->is_null()) return contradict(entry.place, entry.to, object->dump());
  }
  const ValueKind kind = kindOfField(path.field);
  const std::string held = object->is_null() ? std::string() : textIn(*object, key, kind);
  const bool isFilledIn =
      entry.to.empty() && !isSealedBefore(static_cast<std::size_t>(&entry - m_journal.data()));
  if (held != filedText(entry.to, kind) && !isFilledIn) contradict(entry.place, entry.to, held);
  if (entry.to.empty()) m_isExact = false;
  (*object)[key] = valueOf(entry.from, kind);
  if (entry.from.empty()) m_absent.push_back(pointer + pointed(key));
}

/// Digests of the content with each of up to six members of `m_absent` present or absent, all absent first.
/// With more members, only the digest of the content with all of them.
std::vector<std::string> JournalReplay::digestsOfAllForms() const {
  constexpr std::size_t mostUnsure = 6;
  std::vector<std::string> places(m_absent.begin(), m_absent.end());
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  if (places.size() > mostUnsure) return {sha256(layoutJson(*m_content))};
  std::vector<std::string> digests;
  for (std::size_t form = 0; form < std::size_t{1} << places.size(); ++form) {
    Json content = *m_content;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if ((form >> i & 1U) != 0) continue;
      const Json::json_pointer pointer(places[i]);
      if (!content.contains(pointer)) continue;
      Json& object = content[pointer.parent_pointer()];
      const Json& value = content[pointer];
      if (saysNothing(value)) object.erase(pointer.back());
    }
    digests.push_back(sha256(layoutJson(content)));
  }
  return digests;
}

bool JournalReplay::isDescribed(const std::string& place) const {
  return std::ranges::any_of(m_describedPlaces,
                             [&](const std::string& name) { return place.starts_with(name); });
}

void JournalReplay::compareWith(const Json& sealed) {
  std::map<std::string, std::string> recorded, held;
  flatten(sealed, {}, recorded);
  flatten(*m_content, {}, held);
  for (const auto& [place, text] : recorded) {
    const auto found = held.find(place);
    if (!isDescribed(place) && (found == held.end() || found->second != text))
      contradict(place, text, found == held.end() ? std::string() : found->second);
  }
  for (const auto& [place, text] : held)
    if (!isDescribed(place) && !recorded.contains(place)) contradict(place, {}, text);
}

CheckedSeal::State JournalReplay::atSeal(std::size_t index) {
  using State = CheckedSeal::State;
  const JournalEntry& entry = m_journal[index];
  const std::size_t before = m_contradictions.size();
  State state = State::Unchecked;
  const std::string copy = sealedContent(entry);
  Json sealed = copy.empty() ? Json() : Json::parse(copy, nullptr, false);
  if (sealed.is_discarded()) sealed = Json();
  if (!m_isOpaque) {
    const auto digests = digestsOfAllForms();
    const bool isDigest = std::ranges::find(digests, entry.to) != digests.end();
    if (isDigest) {
      state = State::Held;
    } else if (sealed.is_object()) {
      compareWith(sealed);
      state = m_contradictions.size() == before && before == 0 ? State::Held : State::Changed;
    } else if (m_isExact || !m_contradictions.empty()) {
      state = State::Changed;
    }
  }
  if (sealed.is_object()) {
    *m_content = std::move(sealed);
    m_isOpaque = false;
    m_isExact = true;
    m_describedPlaces.clear();
    m_absent.clear();
    m_gone.clear();
  }
  return state;
}

}  // namespace alidade
