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

/// An amplitude of an effect of the user's own.
struct OwnParameter {
  std::string name = {};       ///< its letter in the formula
  std::string plausible = {};  ///< 1σ of the plausible size, > 0
  std::string unit = {};       ///< "mm" or "arcsec", that of its carrier; empty: the same
  JsonOrigin origin = {};

  bool operator==(const OwnParameter&) const = default;
};

/// An effect of the user's own, as typed: in a session, or in a file `*.alidade-effect` of its own.
struct OwnEffect {
  std::string id = {};  ///< letters, digits, _ and -; results have it behind `ownPrefix`
  std::string name = {}, description = {};
  std::string device = {}, instrument = {};  ///< serial number of its owner; both empty: none
  std::string formula = {};                  ///< as in core/terms/formula.h, with the numbers of its shape
  std::vector<OwnParameter> parameters = {};
  bool turnsWithFace = false;  ///< lines of circles have the other sign in face 2
  std::string remedy = {};
  std::string from = {};  ///< where it comes from
  JsonOrigin origin = {};

  bool operator==(const OwnEffect&) const = default;
};

/// Reads the text of a `*.alidade-effect` file (JSON, UTF-8, format version 1). Fails, with the place, as
/// `readSession` does, and on whatever `ownEffectProblem` tells.
Result<OwnEffect> readOwnEffect(std::string_view text);
/// The effect as the text of a file, ending in a newline. Unknown keys and unchanged values are preserved.
std::string writeOwnEffect(const OwnEffect& effect);
/// Reads an effect from a file; the problem says why the file cannot be opened.
Result<OwnEffect> loadOwnEffect(const std::string& path);

/// The effects in the key `own_effects` of a session.
std::vector<OwnEffect> readOwnEffects(const ObjectReader& session);
nlohmann::ordered_json ownEffectsJson(const std::vector<OwnEffect>& effects);

/// Does it have no owner, or is the session's device or instrument its owner by serial number?
bool isOfSession(const OwnEffect& effect, const Session& session);
/// Puts it into the session, in place of one with the same id. False, and nothing happens, if the session has
/// another owner.
bool takeOwnEffect(Session& session, const OwnEffect& effect);

}  // namespace alidade
