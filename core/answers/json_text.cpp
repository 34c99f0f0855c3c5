#include "core/answers/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/base/version.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

class JsonText {
 public:
  explicit JsonText(const std::vector<LongList>& lists) : m_lists(lists) {}

  std::string of(const Json& document) {
    write(document, "", "\n");
    m_text += '\n';
    return std::move(m_text);
  }

 private:
  static constexpr std::string_view step = "  ";
  const std::vector<LongList>& m_lists;
  std::string m_text;

  /// `newline`: and the blanks behind it, before what ends `json`.
  void write(const Json& json, const std::string& path, const std::string& newline) {
    const auto list = std::ranges::find(m_lists, path, &LongList::path);
    const auto holdsList = [&](const LongList& other) { return other.path.starts_with(path + "/"); };
    if (list != m_lists.end())
      writeList(*list, newline);
    else if (std::ranges::any_of(m_lists, holdsList))
      writeMembers(json, path, newline);
    else
      append(json, newline);
  }

  static std::string dumped(const Json& json) {
    return json.dump(static_cast<int>(step.size()), ' ', false, Json::error_handler_t::replace);
  }

  void append(const Json& json, const std::string& newline) {
    for (const char c : dumped(json))  // strings hold no line breaks
      if (c == '\n')
        m_text += newline;
      else
        m_text += c;
  }

  void writeMembers(const Json& json, const std::string& path, const std::string& newline) {
    const std::string inside = newline + std::string(step);
    char separator = '{';
    for (const auto& [key, value] : json.get_ref<const Json::object_t&>()) {
      m_text += std::exchange(separator, ',') + inside;
      append(key, inside);
      m_text += ": ";
      write(value, path + "/" + key, inside);
    }
    m_text += newline + '}';
  }

  void writeList(const LongList& list, const std::string& newline) {
    const std::string inside = newline + std::string(step), member = inside + std::string(step);
    m_text += '[';
    for (std::size_t i = 0; i < list.count; ++i) {
      if (i > 0) m_text += ',';
      m_text += inside;
      char separator = '{';
      list.members(i, [&](const char* key, const Json& value) {
        m_text += std::exchange(separator, ',') + member;
        m_text.append("\"").append(key).append("\": ").append(dumped(value));
      });
      m_text += inside + '}';
      if (i == 0) makeRoom(list.count);
    }
    m_text += list.count == 0 ? "]" : newline + ']';
  }

  /// For a list whose first element has been written: a text that grew to its length would be held twice.
  void makeRoom(std::size_t count) {
    m_text.reserve(m_text.size() + (count - 1) * (m_text.size() - m_text.rfind('[')));
  }
};

}  // namespace

std::string jsonText(const Json& document, const std::vector<LongList>& lists) {
  return JsonText(lists).of(document);
}

std::string answerText(Json document, const std::vector<LongList>& lists) {
  document["program"] = {{"name", "Alidade"}, {"version", programVersion}, {"build", programBuild}};
  return jsonText(document, lists);
}

}  // namespace alidade
