#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/problem.h"
#include "core/session/json_origin.h"
#include "core/session/value_text.h"

namespace alidade {

/// The name of a type for the sentence "must be a number, not a list".
std::string jsonTypeName(const nlohmann::ordered_json& value);

/// The format of a file, and the sentences for files of other formats. Phrases are for `Phrase::of`.
struct JsonFormat {
  const char* id;         ///< "alidade-session"
  const char* isNone;     ///< sentence for a file without a format
  const char* choose;     ///< what to do instead: "choose a session file"
  const char* noVersion;  ///< sentence for an invalid version, %1; %2 is the newest
};

/// Reads the values of one object of a file. The first problem is kept; later ones are ignored.
class ObjectReader {
 public:
  using Json = nlohmann::ordered_json;

  ObjectReader(const Json& json, Place where, std::optional<Problem>& problem);

  /// The text of a value of this kind; empty if the value is missing. A value of another kind is a problem.
  std::string value(std::string_view key, ValueKind kind) const;
  std::string text(const char* key) const { return value(key, ValueKind::Text); }
  std::string number(const char* key) const { return value(key, ValueKind::Number); }
  std::string angle(const char* key) const { return value(key, ValueKind::Angle); }

  std::string requiredNumber(const char* key, const char* remedy) const {
    return require(key, remedy) ? number(key) : std::string();
  }
  std::string requiredAngle(const char* key, const char* remedy) const {
    return require(key, remedy) ? angle(key) : std::string();
  }
  bool flag(std::string_view key) const;

  ObjectReader object(const char* key) const;
  /// The members of a list; empty if the key is absent. Another type is reported, and the list is empty.
  const Json& list(const char* key) const;
  /// A reader of one object in a list.
  ObjectReader member(const char* key, std::size_t index, const Json& json) const;

  bool require(std::string_view key, const char* remedy) const;
  /// Checks that `"format"` is this one, and `"version"` one that this program reads.
  void checkFormat(const JsonFormat& format) const;

  void report(const std::string& what, const Place& where) const;
  const Json* find(std::string_view wanted) const;
  Place placeOf(std::string_view key) const;

  /// The origin without the values of `parts`, which have their own origins.
  JsonOrigin origin(const std::vector<const char*>& parts = {}) const;

 private:
  const Json& m_json;
  Place m_where;
  std::optional<Problem>& m_problem;
};

}  // namespace alidade
