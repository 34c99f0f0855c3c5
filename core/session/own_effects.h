#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/problem.h"
#include "core/session/own_effect.h"
#include "core/terms/effect.h"
#include "core/terms/formula.h"

namespace alidade {

/// Prefix of the id of a user's own effect wherever effects are named; no id of the catalogue begins with it.
inline constexpr std::string_view ownPrefix = "own:";
/// The id in results: "own:dent".
std::string ownId(const OwnEffect& effect);

/// An id made of a name: letters, digits and - stay, all else becomes _. At most 40 bytes.
std::string ownIdFrom(std::string name);

/// A usable effect of the user's own, with its error terms.
struct OwnEntry {
  OwnEffect source;
  std::string id;  ///< `ownPrefix` and the effect's id
  Formula formula;
  std::vector<ErrorTerm> terms = {};  ///< one for each amplitude of the formula
  Effect effect = {};                 ///< refers to the texts of `source`
};

/// The user's own effects in a session that are usable; each amplitude has one of the error terms reserved
/// for them. The entries never move, so pointers to their `Effect` stay valid. Measurements share the object.
class OwnEffects {
 public:
  /// `entries` have their terms; the constructor fills in each `effect`.
  explicit OwnEffects(std::vector<OwnEntry> entries);
  OwnEffects(const OwnEffects&) = delete;
  OwnEffects& operator=(const OwnEffects&) = delete;

  const std::vector<OwnEntry>& entries() const { return m_entries; }
  const Effect* find(std::string_view id) const;
  const Effect* find(ErrorTerm term) const;
  bool has(ErrorTerm term) const { return find(term) != nullptr; }

 private:
  std::vector<OwnEntry> m_entries;
};

/// The first reason why an effect is unusable; absent if it is usable. `where` names the key.
std::optional<Problem> ownEffectProblem(const OwnEffect& effect);

/// The usable effects among the first 20; null if there are none. Adds a problem for each unusable effect,
/// and one problem if there are more than 20.
std::shared_ptr<const OwnEffects> examineOwnEffects(const std::vector<OwnEffect>& effects,
                                                    std::vector<Problem>& problems);

}  // namespace alidade
