#include "core/session/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <vector>

#include "core/base/utf8.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t deepestNesting = 100;
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

/// "line 3, column 7" of a byte; columns count characters.
std::string lineAndColumn(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto lineStart = before.rfind('\n');
  std::string_view onLine = lineStart == std::string_view::npos ? before : before.substr(lineStart + 1);
  std::size_t column = 1;
  for (; !onLine.empty(); ++column) onLine.remove_prefix(firstCharacter(onLine).length);
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Builds the document from the parser's events. Unlike the library's own builder it takes linear time for
/// objects with many keys and notices a key that stands twice.
class DocumentBuilder : public Json::json_sax_t {
 public:
  DocumentBuilder(std::string_view text, Json& document) : m_text(text), m_document(document) {}

  std::optional<Problem> problem;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = m_levels.back();
    level.key = std::move(name);
    if (level.keys.insert(level.key).second) return true;
    problem =
        Problem{"stands twice in one object: delete one of the two, so that neither is lost unseen", place()};
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
    std::string key;
    std::unordered_set<std::string> keys;
  };

  bool add(Json value) {
    place(std::move(value));
    m_isWhole = m_levels.empty();
    return true;
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
    if (m_levels.size() >= deepestNesting) {
      problem = Problem{
          "is nested more than " + std::to_string(deepestNesting) + " levels deep: this is no session file",
          Place{.position = {}, .reading = {}, .field = m_levels.front().key}};
      return false;
    }
    Json* opened = place(std::move(empty));
    m_levels.push_back({opened, {}, {}});
    return true;
  }

  bool close() {
    m_levels.pop_back();
    m_isWhole = m_levels.empty();
    return true;
  }

  /// The place of the member at hand, in the terms of a session where it lies in one.
  Place place() const {
    Place place;
    for (const Level& level : m_levels) {
      const bool inArray = level.value->is_array();
      const bool innermost = &level == &m_levels.back();
      const std::size_t index = inArray ? level.value->size() - (innermost ? 0 : 1) : 0;
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
      return "has a number too large to be worked with before " + lineAndColumn(m_text, at) +
             ": check its exponent";
    if (m_isWhole)
      return "goes on after its end, at " + lineAndColumn(m_text, at) +
             ": a session file holds one JSON document, delete what follows it";
    if (m_text.find_first_not_of(" \t\r\n", at) == std::string_view::npos) {
      return "ends too early, at " + lineAndColumn(m_text, m_text.size()) +
             ": the file is cut short, restore a complete copy";
    }
    return "is not JSON at " + lineAndColumn(m_text, at) + ", at " + quotation(lastToken) +
           ": look there for a missing comma, colon, bracket or quotation mark";
  }

  std::string_view m_text;
  Json& m_document;
  std::vector<Level> m_levels;
  bool m_isWhole = false;  // the document is complete: nothing may follow
};

/// Writes one document; `m_text` grows as it goes.
class Layout {
 public:
  std::string text(const Json& json) {
    write(json, "", 0);
    return std::move(m_text) + "\n";
  }

 private:
  static std::string leaf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  void write(const Json& json, std::string_view path, std::size_t depth) {
    const bool oneLine = path == "/positions/[]/readings/[]" || path == "/positions/[]/pointing_zero";
    if (!json.is_structured() || json.empty()) {
      m_text += leaf(json);
    } else if (oneLine) {
      writeOnOneLine(json);
    } else {
      writeOnLines(json, path, depth);
    }
  }

  void writeOnLines(const Json& json, std::string_view path, std::size_t depth) {
    const bool object = json.is_object();
    m_text += object ? "{" : "[";
    const char* separator = "\n";
    const auto indent = [this](std::size_t levels) { m_text.append(2 * levels, ' '); };
    const auto begin = [&] {
      m_text += separator;
      separator = ",\n";
      indent(depth + 1);
    };
    if (object) {
      for (const auto& [key, value] : json.get_ref<const Json::object_t&>()) {
        begin();
        m_text += leaf(key) + ": ";
        write(value, std::string(path) + "/" + key, depth + 1);
      }
    } else {
      const std::string inside = std::string(path) + "/[]";
      for (const Json& value : json) {
        begin();
        write(value, inside, depth + 1);
      }
    }
    m_text += "\n";
    indent(depth);
    m_text += object ? "}" : "]";
  }

  void writeOnOneLine(const Json& json) {
    const bool object = json.is_object();
    m_text += object ? "{" : "[";
    const char* separator = "";
    for (const auto& item : json.items()) {
      m_text += separator;
      separator = ", ";
      if (object) m_text += leaf(item.key()) + ": ";
      if (item.value().is_structured()) {
        writeOnOneLine(item.value());
      } else {
        m_text += leaf(item.value());
      }
    }
    m_text += object ? "}" : "]";
  }

  std::string m_text;
};

}  // namespace

std::optional<Problem> parseJson(std::string_view text, Json& json) {
  if (text.substr(0, byteOrderMark.size()) == byteOrderMark) text.remove_prefix(byteOrderMark.size());
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Problem{"is empty: choose a session file"};
  }
  if (const auto byte = firstIllFormedByte(text)) {
    return Problem{"is not UTF-8 text at " + lineAndColumn(text, *byte) +
                   ": save the file with UTF-8 encoding"};
  }
  DocumentBuilder builder(text, json);
  if (Json::sax_parse(text.begin(), text.end(), &builder)) return std::nullopt;
  return builder.problem;
}

std::string layoutJson(const Json& json) {
  return Layout().text(json);
}

}  // namespace alidade
