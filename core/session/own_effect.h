#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/session/json_object_reader.h"
#include "core/session/json_origin.h"

namespace alidade {

struct Session;

/// An amplitude of one of the user's own effects.
struct OwnParameter {
  std::string name = {};       ///< name of the amplitude in the formula
  std::string plausible = {};  ///< plausible size (1σ), > 0
  std::string unit = {};       ///< unit of its line in the formula, "mm" or "arcsec"; may be empty
  JsonOrigin origin = {};

  bool operator==(const OwnParameter&) const = default;
};

/// One of the user's own effects, as typed: in a session, or in its own file `*.alidade-effect`.
struct OwnEffect {
  std::string id = {};  ///< letters, digits, _ and -; results put `ownPrefix` before it
  std::string name = {}, description = {};
  std::string device = {}, instrument = {};  ///< serial number of the owner; both empty: no owner
  std::string formula = {};                  ///< lines as in core/terms/formula.h, including named numbers
  std::vector<OwnParameter> parameters = {};
  bool turnsWithFace = false;  ///< lines of the formula for circles change sign in face 2
  std::string remedy = {};
  std::string from = {};  ///< source of the effect
  JsonOrigin origin = {};

  bool operator==(const OwnEffect&) const = default;
};

/// Reads the text of a `*.alidade-effect` file (JSON, UTF-8, format version 1). Fails, with the place, as
/// `readSession` does, and on every problem that `ownEffectProblem` finds.
Result<OwnEffect> readOwnEffect(std::string_view text);
/// The effect as the text of a file, ending in a newline. Unknown keys and unchanged values are preserved.
std::string writeOwnEffect(const OwnEffect& effect);
/// Reads an effect from a file; the problem says why the file cannot be opened, or what is wrong in it.
Result<OwnEffect> loadOwnEffect(const std::string& path);

/// The effects in the key `own_effects` of a session.
std::vector<OwnEffect> readOwnEffects(const ObjectReader& session);
nlohmann::ordered_json ownEffectsJson(const std::vector<OwnEffect>& effects);

/// Does the effect have no owner, or does the session's device or instrument have its owner's serial number?
bool isOfSession(const OwnEffect& effect, const Session& session);
/// Adds the effect to the session, in place of one with the same id. If the effect is not `isOfSession`,
/// returns false and changes nothing.
bool takeOwnEffect(Session& session, const OwnEffect& effect);

}  // namespace alidade
