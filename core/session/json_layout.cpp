#include "core/session/json_text.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

/// Writes one document by appending to `m_text`.
class Layout {
 public:
  explicit Layout(const RowsOf& rows) : m_rows(rows) {}

  std::string text(const Json& json) {
    write(json, "", 0);
    return std::move(m_text) + "\n";
  }

 private:
  static std::string leaf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  void write(const Json& json, std::string_view path, std::size_t depth) {
    const bool oneLine =
        path == "/positions/[]/readings/[]" || path == "/positions/[]/pointing_zero" || path == "/journal/[]";
    if (m_rows && path == "/positions/[]" && json.is_object()) {
      writeOnLines(json, path, depth);
      ++m_position;
    } else if (m_rows && path == "/positions/[]/readings") {
      writeRows(json.get<std::size_t>(), path, depth);
    } else if (!json.is_structured() || json.empty()) {
      m_text += leaf(json);
    } else if (oneLine) {
      writeOnOneLine(json);
    } else {
      writeOnLines(json, path, depth);
    }
  }

  void beginMember(bool first, std::size_t depth) {
    m_text += first ? "\n" : ",\n";
    m_text.append(2 * (depth + 1), ' ');
  }

  void end(char bracket, std::size_t depth) {
    m_text += "\n";
    m_text.append(2 * depth, ' ');
    m_text += bracket;
  }

  void writeRows(std::size_t count, std::string_view path, std::size_t depth) {
    m_text += "[";
    if (count == 0) {
      m_text += "]";
      return;
    }
    const std::string inside = std::string(path) + "/[]";
    for (std::size_t row = 0; row < count; ++row) {
      beginMember(row == 0, depth);
      write(m_rows(m_position, row), inside, depth + 1);
    }
    end(']', depth);
  }

  void writeOnLines(const Json& json, std::string_view path, std::size_t depth) {
    const bool object = json.is_object();
    m_text += object ? "{" : "[";
    bool first = true;
    if (object) {
      for (const auto& [key, value] : json.get_ref<const Json::object_t&>()) {
        beginMember(std::exchange(first, false), depth);
        m_text += leaf(key) + ": ";
        write(value, std::string(path) + "/" + key, depth + 1);
      }
    } else {
      const std::string inside = std::string(path) + "/[]";
      for (const Json& value : json) {
        beginMember(std::exchange(first, false), depth);
        write(value, inside, depth + 1);
      }
    }
    end(object ? '}' : ']', depth);
  }

  void writeOnOneLine(const Json& json) {
    const bool object = json.is_object();
    m_text += object ? "{" : "[";
    const char* separator = "";
    const auto write = [&](const Json& value) {
      if (value.is_structured())
        writeOnOneLine(value);
      else
        m_text += leaf(value);
    };
    const auto begin = [&] {
      m_text += separator;
      separator = ", ";
    };
    if (object) {
      for (const auto& [key, value] : json.get_ref<const Json::object_t&>()) {
        begin();
        m_text += leaf(key) + ": ";
        write(value);
      }
    } else {
      for (const Json& value : json) {
        begin();
        write(value);
      }
    }
    m_text += object ? "}" : "]";
  }

  const RowsOf& m_rows;
  std::size_t m_position = 0;  ///< index of the position being written
  std::string m_text;
};

}  // namespace

std::string layoutJson(const Json& json, const RowsOf& rows) {
  return Layout(rows).text(json);
}

}  // namespace alidade
