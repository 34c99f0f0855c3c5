#include "core/simulation/truth_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/visible_text.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

using OrderedJson = nlohmann::ordered_json;
using Numbers = std::vector<double>;

constexpr const char* harmonicId = "form_harmonic";
constexpr const char* wrongZeroId = "zero_slip";

/// plane_tilt.x for the parameter "tilt about x" of plane_tilt; the effect's id for an only parameter.
std::string nameOf(const Effect& effect, const EffectParameter& parameter) {
  if (effect.parameters.size() == 1) return std::string(effect.id);
  return std::string(effect.id) + "." + std::string(parameter.name.substr(parameter.name.rfind(' ') + 1));
}

std::vector<const EffectParameter*> parametersNamed(const std::string& name, const OwnEffects* own) {
  std::vector<const EffectParameter*> found;
  for (const Effect* effect : effectsWith(own))
    for (const EffectParameter& parameter : effect->parameters)
      if (name == effect->id || name == nameOf(*effect, parameter)) found.push_back(&parameter);
  return found;
}

Result<Numbers> numbersIn(const std::string& name, std::string text) {
  Numbers numbers;
  while (true) {
    const auto comma = text.find(',');
    const Result<double> number = parseNumber(text.substr(0, comma));
    if (!number) return Problem{"effect " + quotation(name) + ": " + number.problem().what};
    numbers.push_back(*number);
    if (comma == std::string::npos) return numbers;
    text.erase(0, comma + 1);
  }
}

Problem wantsNumbers(const std::string& name, const std::string& what) {
  return {"effect " + quotation(name) + " wants " + what + ", with commas between them"};
}

std::optional<Problem> addJump(Truth& truth, const Numbers& numbers) {
  if (numbers.size() != 3 || !(numbers[0] > 0 && numbers[0] < 1))
    return wantsNumbers(jumpId,
                        "the moment (between 0 and 1), the horizontal and the vertical step (arcsec)");
  truth.jump = {numbers[0], Angle::fromArcseconds(numbers[1]), Angle::fromArcseconds(numbers[2])};
  return std::nullopt;
}

bool isWhole(double number, double least) {
  return number >= least && number == std::floor(number) && number < 1e9;
}

constexpr const char* repeatToo = ", and the number of the position at that axis, if not its first";

/// True for `count` numbers that begin with an axis, or for one more number: the repeat at that axis.
bool areOfAxis(const Numbers& numbers, std::size_t count) {
  if (numbers.size() != count && !(numbers.size() == count + 1 && isWhole(numbers.back(), 1))) return false;
  return numbers[0] == 0 || numbers[0] == 180;
}

int repeatIn(const Numbers& numbers, std::size_t count) {
  return numbers.size() > count ? static_cast<int>(numbers[count]) : 1;
}

std::optional<Problem> addWrongZero(Truth& truth, const Numbers& numbers) {
  if (!areOfAxis(numbers, 3))
    return wantsNumbers(wrongZeroId, "the axis (0 or 180), the horizontal and the vertical step (arcsec)" +
                                         std::string(repeatToo));
  truth.wrongZero = {static_cast<int>(numbers[0]), Angle::fromArcseconds(numbers[1]),
                     Angle::fromArcseconds(numbers[2]), repeatIn(numbers, 3)};
  return std::nullopt;
}

std::optional<Problem> addNoise(Truth& truth, const Numbers& numbers) {
  if (numbers.size() != 1 || !(numbers[0] >= 0))
    return Problem{
        "effect “underestimated_noise” wants one number, 0 or more: the true noise over the stated"};
  truth.noiseFactor = numbers[0];
  return std::nullopt;
}

std::optional<Problem> addGrossError(Truth& truth, const Numbers& n) {
  if (!areOfAxis(n, 6) || !isWhole(n[1], 1) || !isWhole(n[2], 0) || (n[3] != 1 && n[3] != 2))
    return wantsNumbers(grossErrorId,
                        "axis (0 or 180), round, point, face and the horizontal and vertical error (arcsec)" +
                            std::string(repeatToo));
  truth.grossErrors.push_back({static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]),
                               static_cast<int>(n[3]), Angle::fromArcseconds(n[4]),
                               Angle::fromArcseconds(n[5]), repeatIn(n, 6)});
  return std::nullopt;
}

std::optional<Problem> addHarmonic(Truth& truth, const Numbers& numbers) {
  if (numbers.size() != 3 || !isWhole(numbers[0], 1))
    return wantsNumbers(harmonicId, "the order (a whole number), cosine and sine (mm)");
  truth.harmonic = {static_cast<int>(numbers[0]), numbers[1], numbers[2]};
  return std::nullopt;
}

std::optional<Problem> addForeign(Truth& truth, const ForeignEffectName& name, const Numbers& numbers) {
  if (static_cast<int>(numbers.size()) != name.numbers)
    return wantsNumbers(std::string(name.name), std::string(name.usage));
  const auto number = [&](std::size_t i) { return i < numbers.size() ? numbers[i] : 0; };
  truth.foreign = {name.kind, number(0), number(1), number(2)};
  return std::nullopt;
}

struct OtherEffect {
  const char* name;
  const char* usage;
  std::optional<Problem> (*add)(Truth&, const Numbers&);
};

constexpr std::array otherEffects = {
    OtherEffect{jumpId, "moment (0…1),horizontal,vertical (arcsec)", &addJump},
    OtherEffect{wrongZeroId,
                "axis,horizontal,vertical[,time] (arcsec): a jump between its zero and its first place",
                &addWrongZero},
    OtherEffect{grossErrorId, "axis,round,point,face,horizontal,vertical[,time] (arcsec); may be repeated",
                &addGrossError},
    OtherEffect{noiseId, "true noise over the stated", &addNoise},
    OtherEffect{harmonicId, "order,cosine,sine (mm): a form error outside the catalogue", &addHarmonic},
};

void setSize(Truth& truth, ErrorTerm term, double value) {
  const auto known = std::ranges::find(truth.effects, term, &TrueSize::term);
  if (known != truth.effects.end())
    known->value = value;
  else
    truth.effects.push_back({term, value});
}

OrderedJson effectsJson(const Truth& truth) {
  OrderedJson effects = OrderedJson::object();
  for (const Effect* effect : effectsWith(truth.own.get()))
    for (const EffectParameter& parameter : effect->parameters) {
      const auto size = std::ranges::find(truth.effects, parameter.term, &TrueSize::term);
      if (size != truth.effects.end()) effects[nameOf(*effect, parameter)] = size->value;
    }
  if (truth.jump)
    effects[jumpId] = {truth.jump->moment, truth.jump->horizontal.arcseconds(),
                       truth.jump->vertical.arcseconds()};
  if (truth.wrongZero)
    effects[wrongZeroId] = {NumberedPosition{truth.wrongZero->axisDeg, truth.wrongZero->repeat}.number(),
                            truth.wrongZero->horizontal.arcseconds(), truth.wrongZero->vertical.arcseconds()};
  if (truth.harmonic)
    effects[harmonicId] = {truth.harmonic->order, truth.harmonic->cosine, truth.harmonic->sine};
  if (truth.foreign)
    effects[std::string(nameOf(truth.foreign->kind))] = {truth.foreign->size, truth.foreign->first,
                                                         truth.foreign->second};
  return effects;
}

OrderedJson grossErrorsJson(const Truth& truth) {
  OrderedJson grossErrors = OrderedJson::array();
  for (const TrueGrossError& m : truth.grossErrors)
    grossErrors.push_back({NumberedPosition{m.axisDeg, m.repeat}.number(), m.round, m.point, m.face,
                           m.horizontal.arcseconds(), m.vertical.arcseconds()});
  return grossErrors;
}

}  // namespace

std::optional<Problem> addEffect(Truth& truth, const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    return Problem{"effect " + quotation(text) + " has no size: type it as NAME=VALUE"};
  const std::string name = text.substr(0, equals);
  const Result<Numbers> numbers = numbersIn(name, text.substr(equals + 1));
  const auto other = std::ranges::find_if(otherEffects, [&](const OtherEffect& o) { return name == o.name; });
  const auto foreign = std::ranges::find(foreignEffectNames(), name, &ForeignEffectName::name);
  const std::vector<const EffectParameter*> parameters = parametersNamed(name, truth.own.get());
  if (other == otherEffects.end() && foreign == foreignEffectNames().end() && parameters.empty())
    return Problem{quotation(name) + " is no effect: `alidade-cli simulate --help` lists them"};
  if (!numbers) return numbers.problem();
  if (other != otherEffects.end()) return other->add(truth, *numbers);
  if (foreign != foreignEffectNames().end()) return addForeign(truth, *foreign, *numbers);
  if (numbers->size() != parameters.size())
    return Problem{"effect " + quotation(name) + " has " + counted(parameters.size(), "size") + ", not " +
                   std::to_string(numbers->size())};
  for (std::size_t i = 0; i < parameters.size(); ++i) setSize(truth, parameters[i]->term, (*numbers)[i]);
  return std::nullopt;
}

std::string effectNames() {
  std::string lines;
  for (const Effect& effect : effectCatalogue()) {
    std::string values;
    for (const EffectParameter& parameter : effect.parameters)
      values += (values.empty() ? "" : ",") + std::string(parameter.name);
    const std::string unit(effect.parameters.front().unit);
    const bool counted = unit != "-" && unit != "1";
    lines += "  " + std::string(effect.id) + "=" + values + (counted ? " (" + unit + ")" : "") + "\n";
  }
  for (const OtherEffect& other : otherEffects)
    lines += std::string("  ") + other.name + "=" + other.usage + "\n";
  for (const ForeignEffectName& foreign : foreignEffectNames())
    lines +=
        "  " + std::string(foreign.name) + "=" + std::string(foreign.usage) + ": outside the catalogue\n";
  return lines;
}

std::vector<std::string> trueCauses(const Truth& truth) {
  std::vector<std::string> causes;
  for (const Effect* effect : effectsWith(truth.own.get()))
    if (std::ranges::any_of(effect->parameters, [&](const EffectParameter& parameter) {
          const auto size = std::ranges::find(truth.effects, parameter.term, &TrueSize::term);
          return size != truth.effects.end() && size->value != 0;
        }))
      causes.emplace_back(effect->id);
  const auto turns = [](const auto& step) {
    return step.horizontal.radians() != 0 || step.vertical.radians() != 0;
  };
  if ((truth.jump && turns(*truth.jump)) || (truth.wrongZero && turns(*truth.wrongZero)))
    causes.emplace_back(jumpId);
  if (std::ranges::any_of(truth.grossErrors, turns)) causes.emplace_back(grossErrorId);
  if (truth.noiseFactor > 1) causes.emplace_back(noiseId);
  if (truth.harmonic && (truth.harmonic->cosine != 0 || truth.harmonic->sine != 0))
    causes.emplace_back("unknown_harmonic");
  if (truth.foreign && truth.foreign->size != 0)
    causes.push_back("unknown_" + std::string(nameOf(truth.foreign->kind)));
  return causes;
}

std::string kindOf(const Truth& truth) {
  const std::vector<std::string> causes = trueCauses(truth);
  if (causes.empty()) return "none";
  if (causes.size() == 1) return causes.front();
  return causes.size() == 2 ? "two_causes" : "several_causes";
}

std::string truthJson(const std::string& id, const Truth& truth) {
  const std::vector<std::string> causes = trueCauses(truth);
  OrderedJson json = {{"seed", truth.seed},
                      {"effects", effectsJson(truth)},
                      {"intersection_mm", truth.intersection},
                      {"radius_mm", truth.radius},
                      {"centre_x_mm", truth.centreX},
                      {"axis_height_mm", truth.axisHeight},
                      {"distance_mm", truth.distance},
                      {"blunders", grossErrorsJson(truth)},
                      {"kind", kindOf(truth)},
                      {"protocol", truth.protocol},
                      {"reference", truth.sigmaReference.has_value()}};
  if (causes.size() > 1) json["causes"] = causes;
  if (truth.noiseFactor != 1)
    json["true_sigma_arcsec"] = truth.noiseFactor * truth.sigmaHorizontal.arcseconds();
  return OrderedJson{{id, std::move(json)}}.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace alidade
