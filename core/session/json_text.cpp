#include "core/session/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <vector>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/base/utf8.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

/// The place of a byte as "line 3, column 7"; columns count characters.
std::string lineAndColumn(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto lineStart = before.rfind('\n');
  std::string_view onLine = lineStart == std::string_view::npos ? before : before.substr(lineStart + 1);
  std::size_t column = 1;
  for (; !onLine.empty(); ++column) onLine.remove_prefix(firstCharacter(onLine).length);
  //: a place in a file
  return Phrase::of("line %1, column %2", line, column);
}

/// Builds the document from the parser's events, except for the rows of readings, which are passed on one by
/// one. Unlike the library's own builder it takes linear time for objects with many keys and detects
/// duplicate keys.
class DocumentBuilder : public Json::json_sax_t {
 public:
  DocumentBuilder(std::string_view text, Json& document, const TakeRow& takeRow)
      : m_text(text), m_document(document), m_takeRow(takeRow) {}

  std::optional<Problem> problem;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return !isTooLong(value) && add(std::move(value)); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = m_levels.back();
    level.key = std::move(name);
    if (isTooLong(level.key)) return false;
    if (!isDuplicate(level)) return true;
    problem = Problem{Phrase::of("is a duplicate key: delete one of the two"), place()};
    return false;
  }

  bool parse_error(std::size_t byte, const std::string& lastToken,
                   const nlohmann::detail::exception& error) override {
    problem = Problem{describe(byte, lastToken, error)};
    return false;
  }

 private:
  struct Level {
    Json* value;
    bool holdsRows = false;  ///< the value is the list `readings` of a position
    std::size_t taken = 0;   ///< members of a list already passed on
    std::string key = {};
    std::unordered_set<std::string> keys = {};  ///< keys of an object with many members; else empty
  };

  /// Is the key a duplicate? A linear search is faster than a set for a few keys.
  static bool isDuplicate(Level& level) {
    constexpr std::size_t few = 16;
    const auto& members = level.value->get_ref<const Json::object_t&>();
    if (members.size() < few)
      return std::any_of(members.begin(), members.end(),
                         [&](const auto& member) { return member.first == level.key; });
    if (level.keys.empty())
      for (const auto& [key, value] : members) level.keys.insert(key);
    return !level.keys.insert(level.key).second;
  }

  bool isTooLong(const std::string& text) {
    if (text.size() <= limits::longestText) return false;
    problem = Problem{Phrase::of("has a text of more than %1: shorten it, or keep it in a separate file",
                                 limits::asMebibytes(limits::longestText)),
                      m_levels.empty() ? Place() : place()};
    if (problem->where.field.size() > limits::longestText) problem->where = {};
    return true;
  }

  bool add(Json value) {
    if (hasTooMany()) return false;
    place(std::move(value));
    m_isWhole = m_levels.empty();
    return m_levels.empty() || handOnRow();
  }

  Json* place(Json&& value) {
    if (m_levels.empty()) {
      m_document = std::move(value);
      return &m_document;
    }
    Level& level = m_levels.back();
    if (level.value->is_array())
      return &level.value->get_ref<Json::array_t&>().emplace_back(std::move(value));
    auto& members = level.value->get_ref<Json::object_t&>();
    return &static_cast<std::vector<Json::object_t::value_type>&>(members)
                .emplace_back(level.key, std::move(value))
                .second;
  }

  bool open(Json empty) {
    if (m_levels.size() >= limits::deepestNesting) {
      problem = Problem{Phrase::of("is nested more than %1 levels deep: this is no file of this program",
                                   limits::deepestNesting),
                        Place{.position = {}, .reading = {}, .field = m_levels.front().key}};
      return false;
    }
    if (hasTooMany()) return false;
    const bool holdsRows = m_takeRow && empty.is_array() && isInPosition() && m_levels[2].key == "readings";
    Json* opened = place(std::move(empty));
    if (!m_levels.empty() && m_levels.back().holdsRows && opened->is_object()) makeRoomForRow(*opened);
    m_levels.push_back({opened, holdsRows});
    return true;
  }

  /// Reserves room for the members, since a growing container copies them with all keys.
  static void makeRoomForRow(Json& row) {
    constexpr std::size_t usual = 8;
    static_cast<std::vector<Json::object_t::value_type>&>(row.get_ref<Json::object_t&>()).reserve(usual);
  }

  /// Does the current member belong to an object `positions[…]`?
  bool isInPosition() const {
    return m_levels.size() == 3 && m_levels[2].value->is_object() && m_levels[1].value->is_array() &&
           m_levels[0].value->is_object() && m_levels[0].key == "positions";
  }

  bool close() {
    m_levels.pop_back();
    m_isWhole = m_levels.empty();
    return m_isWhole || handOnRow();
  }

  /// Passes on the last value if it is a row, and drops it.
  bool handOnRow() {
    Level& level = m_levels.back();
    if (!level.holdsRows) return true;
    auto& rows = level.value->get_ref<Json::array_t&>();
    const Place where{.position = m_levels[1].value->size() - 1, .reading = level.taken};
    if (++m_rows > limits::mostRows) {
      problem = limits::tooManyRows();
      return false;
    }
    m_takeRow(where, rows.back());
    rows.pop_back();
    ++level.taken;
    m_values = m_valuesOutsideRows;
    return true;
  }

  bool hasTooMany() {
    const bool isInRow = m_levels.size() > 3 && m_levels[3].holdsRows;
    if (!isInRow) m_valuesOutsideRows = m_values + 1;
    if (++m_values <= limits::mostValues) return false;
    problem = Problem{
        Phrase::of("holds more than %1 values besides its rows of readings: this is no file of this program",
                   limits::asCount(limits::mostValues))};
    return true;
  }

  /// The place of the current member, with indices of position and reading as in a session.
  Place place() const {
    Place place;
    for (const Level& level : m_levels) {
      const bool inArray = level.value->is_array();
      const bool innermost = &level == &m_levels.back();
      const std::size_t index = inArray ? level.value->size() + level.taken - (innermost ? 0 : 1) : 0;
      if (inArray && !place.position && place.field == "positions") {
        place = {.position = index};
      } else if (inArray && place.position && !place.reading && place.field == "readings") {
        place = {.position = place.position, .reading = index};
      } else if (inArray) {
        place.field += "[" + std::to_string(index) + "]";
      } else {
        place.field += (place.field.empty() ? "" : ".") + level.key;
      }
    }
    return place;
  }

  std::string describe(std::size_t byte, const std::string& lastToken, const std::exception& error) const {
    const bool overflow = std::string_view(error.what()).find("number overflow") != std::string_view::npos;
    const std::size_t at = std::min(byte > 0 ? byte - 1 : 0, m_text.size());
    if (overflow)
      return Phrase::of("has too large a number before %1: check its exponent", lineAndColumn(m_text, at));
    if (m_isWhole)
      return Phrase::of("continues after the end of the JSON document, at %1: delete what follows",
                        lineAndColumn(m_text, at));
    if (m_text.find_first_not_of(" \t\r\n", at) == std::string_view::npos) {
      return Phrase::of("ends too early, at %1: the file is incomplete, restore a complete copy",
                        lineAndColumn(m_text, m_text.size()));
    }
    return Phrase::of(
        //: %1: line 3, column 7; %2: what stands there
        "is not JSON at %1, at %2: look there for a missing comma, colon, bracket or quotation mark",
        lineAndColumn(m_text, at), quotation(lastToken));
  }

  std::string_view m_text;
  Json& m_document;
  const TakeRow& m_takeRow;
  std::vector<Level> m_levels;
  std::size_t m_rows = 0, m_values = 0, m_valuesOutsideRows = 0;
  bool m_isWhole = false;  // the document is complete: any further text is an error
};

}  // namespace

std::optional<Problem> parseJson(std::string_view text, Json& json, const TakeRow& takeRow) {
  if (text.substr(0, byteOrderMark.size()) == byteOrderMark) text.remove_prefix(byteOrderMark.size());
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Problem{Phrase::of("is empty: choose another file")};
  }
  if (const auto byte = firstIllFormedByte(text)) {
    return Problem{
        Phrase::of("is not UTF-8 text at %1: save the file with UTF-8 encoding", lineAndColumn(text, *byte))};
  }
  DocumentBuilder builder(text, json, takeRow);
  if (Json::sax_parse(text.begin(), text.end(), &builder)) return std::nullopt;
  return builder.problem;
}

}  // namespace alidade
