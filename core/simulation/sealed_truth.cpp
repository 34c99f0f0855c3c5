#include "core/simulation/sealed_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "core/base/limits.h"
#include "core/base/utf8.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/truth_text.h"

namespace alidade {

namespace {

using Json = nlohmann::json;

void addGrossError(SealedTruth& truth, GrossErrorCell cell, double horizontal, double vertical) {
  if (horizontal != 0) {
    cell.circle = ReadingKind::Horizontal;
    truth.grossErrors.push_back(cell);
  }
  if (vertical != 0) {
    cell.circle = ReadingKind::Vertical;
    truth.grossErrors.push_back(cell);
  }
}

/// Reads misread cells from `list`. False if a cell does not identify its reading by whole numbers.
bool readGrossErrors(const Json& list, SealedTruth& truth) {
  constexpr double mostCells = 1e9;
  for (const Json& grossError : list) {
    std::array<int, 4> place{};
    for (std::size_t i = 0; i < place.size(); ++i) {
      const double number = grossError.at(i).get<double>();
      if (!(std::abs(number) <= mostCells) || number != std::trunc(number)) return false;
      place[i] = static_cast<int>(number);
    }
    if (place[0] < 0) return false;
    const auto [axisDeg, repeat] = NumberedPosition::of(place[0]);
    addGrossError(
        truth, {.axisDeg = axisDeg, .round = place[1], .point = place[2], .face = place[3], .repeat = repeat},
        grossError.at(4), grossError.at(5));
  }
  std::ranges::sort(truth.grossErrors);
  return true;
}

bool isSeveral(const std::string& kind) {
  return kind == "two_causes" || kind == "several_causes";
}

bool isDiagnosable(const std::string& id) {
  return std::ranges::find(diagnosableEffects(), id) != diagnosableEffects().end();
}

/// True if `id` is an effect that a diagnosis can name, or an uncatalogued effect.
bool isCause(const std::string& id) {
  return id.starts_with("unknown") || id.starts_with(ownPrefix) || isDiagnosable(id);
}

/// The number of letters to insert, delete or replace (Levenshtein).
std::size_t lettersApart(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t before = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = before + (a[i] == b[j] ? 0 : 1);
      before = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, before + 1});
    }
  }
  return row.back();
}

/// True if `kind` looks like a mistyped name of a diagnosable effect.
bool isMistyped(const std::string& kind) {
  constexpr std::size_t longest = 64, mostWrong = 2;
  return !isDiagnosable(kind) && kind.size() <= longest &&
         std::ranges::any_of(diagnosableEffects(),
                             [&](const auto& id) { return lettersApart(kind, id) <= mostWrong; });
}

/// Translates names of other test generators into the effect's id: drifts with repeatedly sighted zeros, and
/// readings rounded to coarse steps, which scatter more than stated. Returns other names unchanged.
std::string kindCalled(const std::string& kind) {
  if (kind == "drift_real_h") return "horizontal_drift";
  if (kind == "drift_real_v") return "vertical_drift";
  return kind == "rounding" ? noiseId : kind;
}

/// Returns the reason why the truth cannot be scored, beginning with the key at fault.
std::optional<std::string> whyUnscorable(const SealedTruth& truth) {
  for (const std::string& cause : truth.causes)
    if (!isCause(cause) && cause != truth.kind)
      return "causes names " + quotation(cause) +
             ", which is neither an effect that can be diagnosed nor unknown_…";
  if (isSeveral(truth.kind) && truth.causes.size() < 2)
    return "causes must name them where the kind is " + truth.kind;
  if (truth.causes.size() < 2 && isMistyped(truth.kind))
    return "kind is " + quotation(truth.kind) + ", which is no effect but nearly one: correct its name";
  if (truth.kind == grossErrorId && truth.grossErrors.empty())
    return "blunders must list the readings that are wrong where the kind is " + truth.kind;
  if (truth.visible && *truth.visible < 0) return "visible_sigma must not be negative";
  return std::nullopt;
}

/// Reads the keys in order. `key` becomes the key read last, which the message on a problem names.
std::optional<SealedTruth> readTruth(const std::string& id, const Json& json, std::string& key) {
  SealedTruth truth{.id = id};
  const auto at = [&](const char* name) -> const Json& { return json.at(key = name); };
  const auto given = [&](const char* name) {
    key = name;
    return json.contains(name) && !json.at(name).is_null();
  };
  truth.kind = kindCalled(at("kind").get<std::string>());
  truth.intersection = at("intersection_mm").get<double>();
  if (given("protocol")) truth.protocol = json.at(key).get<std::string>();
  if (given("plan")) truth.protocol = json.at(key).get<std::string>();
  if (truth.kind == "all" && given("there")) {
    truth.kind = "several_causes";
    for (const auto& [effect, size] : json.at(key).items()) truth.causes.push_back(effect);
  }
  if (given("causes")) truth.causes = json.at(key).get<std::vector<std::string>>();
  if (truth.causes.empty() && truth.kind != "none" && !isSeveral(truth.kind)) truth.causes = {truth.kind};
  if (given("visible_sigma")) truth.visible = json.at(key).get<double>();
  if (given("look_alikes"))
    for (const Json& entry : json.at(key)) truth.lookAlikes.push_back(entry.at(0).get<std::string>());
  if (given("blunders") && !readGrossErrors(json.at(key), truth)) return std::nullopt;
  return truth;
}

}  // namespace

bool isOfNoCatalogue(const std::string& kind) {
  return kind != "none" && !isSeveral(kind) && !isDiagnosable(kind);
}

bool isTruthOfSeries(const Json& entry) {
  return entry.is_object() && entry.contains("kind") && entry["kind"].is_string() &&
         ((entry.contains("shared") && entry.contains("sessions") && entry["sessions"].is_object()) ||
          (entry.contains("intersection_mm") && entry["intersection_mm"].is_object()));
}

SealedTruth sealed(const std::string& id, const Truth& truth, const std::optional<Visibility>& visibility) {
  SealedTruth seal{.id = id,
                   .kind = kindOf(truth),
                   .causes = trueCauses(truth),
                   .protocol = truth.protocol,
                   .intersection = truth.intersection};
  if (visibility) {
    seal.visible = visibility->sigma;
    for (const LookAlike& other : visibility->lookAlikes) seal.lookAlikes.push_back(other.effect);
  }
  for (const TrueGrossError& m : truth.grossErrors)
    addGrossError(
        seal, {.axisDeg = m.axisDeg, .round = m.round, .point = m.point, .face = m.face, .repeat = m.repeat},
        m.horizontal.radians(), m.vertical.radians());
  std::ranges::sort(seal.grossErrors);
  return seal;
}

Result<std::vector<SealedTruth>> readSealedTruths(const std::string& text) {
  if (firstIllFormedByte(text)) return Problem{"it is not UTF-8 text: save it with UTF-8 encoding"};
  std::size_t values = 0;
  const auto isKept = [&](int depth, Json::parse_event_t, const Json&) {
    return ++values <= limits::mostTruthEvents && depth <= static_cast<int>(limits::deepestNesting);
  };
  const Json json = Json::parse(text, isKept, false);
  if (values > limits::mostTruthEvents)
    return Problem{"it holds more than " + limits::asCount(limits::mostTruthEvents) +
                   " keys, values and brackets: score the sessions in several folders"};
  if (json.is_discarded() || !json.is_object())
    return Problem{
        "it is no JSON object of truths by session id: take the truth.json that belongs to the sessions"};
  if (json.empty())
    return Problem{
        "it holds no truth, so there is nothing to score: take the truth.json that belongs to the sessions"};
  std::vector<SealedTruth> truths;
  for (const auto& [id, entry] : json.items()) {
    if (isTruthOfSeries(entry)) continue;
    std::string key;
    std::optional<SealedTruth> truth;
    try {
      truth = readTruth(id, entry, key);
    } catch (const Json::exception&) {
      truth.reset();
    }
    if (!truth) return Problem{"truth of " + quotation(id) + ": " + key + " is missing or of the wrong type"};
    if (const auto reason = whyUnscorable(*truth))
      return Problem{"truth of " + quotation(id) + ": " + *reason};
    truths.push_back(*std::move(truth));
  }
  return truths;
}

}  // namespace alidade
