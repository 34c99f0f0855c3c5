#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>

namespace alidade {

/// The JSON object from which a part of a session was read. The writer starts from this object, so that
/// unknown keys, the order of keys, absent optional keys and the values of unchanged keys survive a load and
/// save. The origin is not content: two parts that differ only in their origin are equal.
class JsonOrigin {
 public:
  JsonOrigin() = default;
  explicit JsonOrigin(const nlohmann::ordered_json& object);

  const nlohmann::ordered_json& object() const;  ///< an empty object if the part was not read from a file

  bool operator==(const JsonOrigin&) const { return true; }

 private:
  std::shared_ptr<const nlohmann::ordered_json> m_object;
};

}  // namespace alidade
