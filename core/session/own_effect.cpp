#include "core/session/own_effect.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/file_bytes.h"
#include "core/base/phrase.h"
#include "core/session/json_object_writer.h"
#include "core/session/json_text.h"
#include "core/session/own_effects.h"
#include "core/session/session.h"

namespace alidade {

namespace {

constexpr JsonFormat effectFormat = {
    "alidade-effect",
    PHRASE_LATER("Phrase",
                 "is missing, so this is no effect file: choose a file with \"format\": \"alidade-effect\""),
    PHRASE_LATER("Phrase", "choose an effect file"),
    PHRASE_LATER("Phrase", "%1 is no version of an effect file: it must be %2")};

OwnEffect effectFrom(const ObjectReader& reader) {
  const ObjectReader owner = reader.object("owner");
  OwnEffect effect{.id = reader.text("id"),
                   .name = reader.text("name"),
                   .description = reader.text("description"),
                   .device = owner.text("device"),
                   .instrument = owner.text("instrument"),
                   .formula = reader.text("formula"),
                   .turnsWithFace = reader.flag("turns_with_face"),
                   .remedy = reader.text("remedy"),
                   .from = reader.text("from"),
                   .origin = reader.origin({"parameters"})};
  for (const nlohmann::ordered_json& entry : reader.list("parameters")) {
    const ObjectReader own = reader.member("parameters", effect.parameters.size(), entry);
    effect.parameters.push_back({own.text("name"), own.number("plausible"), own.text("unit"), own.origin()});
  }
  return effect;
}

void fill(ObjectWriter& writer, const OwnEffect& effect) {
  writer.text("id", effect.id);
  writer.text("name", effect.name);
  writer.text("description", effect.description);
  nlohmann::ordered_json owner = nlohmann::ordered_json::object();
  if (!effect.device.empty()) owner["device"] = effect.device;
  if (!effect.instrument.empty()) owner["instrument"] = effect.instrument;
  writer.partIfAny("owner", std::move(owner));
  writer.text("formula", effect.formula);
  nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
  for (const OwnParameter& parameter : effect.parameters) {
    ObjectWriter own(parameter.origin);
    own.text("name", parameter.name);
    own.number("plausible", parameter.plausible);
    own.text("unit", parameter.unit);
    parameters.push_back(own.take());
  }
  writer.partIfAny("parameters", std::move(parameters));
  writer.flag("turns_with_face", effect.turnsWithFace);
  writer.text("remedy", effect.remedy);
  writer.text("from", effect.from);
}

}  // namespace

Result<OwnEffect> readOwnEffect(std::string_view text) {
  nlohmann::ordered_json json;
  if (auto problem = parseJson(text, json)) return *std::move(problem);
  std::optional<Problem> problem;
  const ObjectReader reader(json, {}, problem);
  reader.checkFormat(effectFormat);
  if (problem) return *problem;
  OwnEffect effect = effectFrom(reader);
  if (!problem) problem = ownEffectProblem(effect);
  if (problem) return *problem;
  return effect;
}

std::string writeOwnEffect(const OwnEffect& effect) {
  ObjectWriter writer(effect.origin);
  writer.constant("format", effectFormat.id);
  writer.constant("version", 1);
  fill(writer, effect);
  return layoutJson(writer.take());
}

Result<OwnEffect> loadOwnEffect(const std::string& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.problem();
  return readOwnEffect(*bytes);
}

std::vector<OwnEffect> readOwnEffects(const ObjectReader& session) {
  std::vector<OwnEffect> effects;
  for (const nlohmann::ordered_json& entry : session.list("own_effects"))
    effects.push_back(effectFrom(session.member("own_effects", effects.size(), entry)));
  return effects;
}

nlohmann::ordered_json ownEffectsJson(const std::vector<OwnEffect>& effects) {
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const OwnEffect& effect : effects) {
    ObjectWriter writer(effect.origin);
    fill(writer, effect);
    entries.push_back(writer.take());
    for (const char* key : {"format", "version"}) entries.back().erase(key);  // only a file has these keys
  }
  return entries;
}

bool isOfSession(const OwnEffect& effect, const Session& session) {
  if (effect.device.empty() && effect.instrument.empty()) return true;
  return (!effect.device.empty() && effect.device == session.device.serial) ||
         (!effect.instrument.empty() && effect.instrument == session.instrument.serial);
}

bool takeOwnEffect(Session& session, const OwnEffect& effect) {
  if (!isOfSession(effect, session)) return false;
  const auto same = std::ranges::find(session.ownEffects, effect.id, &OwnEffect::id);
  if (same == session.ownEffects.end())
    session.ownEffects.push_back(effect);
  else
    *same = effect;
  return true;
}

}  // namespace alidade
