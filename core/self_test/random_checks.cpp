#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/random_source.h"
#include "core/base/sha256.h"
#include "core/self_test/check_families.h"
#include "core/simulation/simulate.h"

namespace alidade {

namespace {

using Json = nlohmann::json;

constexpr auto group = CheckGroup::Random;
constexpr const char* everyBit =
    PHRASE_LATER("Phrase", "every bit: a seed gives the same numbers on every machine");
constexpr const char* everyReading = PHRASE_LATER(
    "Phrase",
    "every digit of every reading, compared by SHA-256: a seed gives the same session on every machine");
constexpr CheckTolerance ofNormal = {
    .relative = 1e-14,
    .reason =
        PHRASE_LATER("Phrase", "1e-14: the quantile is worked out to 1e-16 and rounded some ten times")};

std::string hexadecimal(std::uint64_t bits) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(bits));
  return text.data();
}

void addNumbers(std::vector<SelfCheck>& checks, const Json& row) {
  const auto seed = row.at("seed").get<std::uint64_t>();
  const auto stream = row.at("stream").get<std::uint64_t>();
  const std::string name = "seed " + std::to_string(seed) + ", stream " + std::to_string(stream);
  RandomSource forBits(seed, stream), forNormal(seed, stream);
  int number = 0;
  for (const Json& bits : row.at("bits"))
    checks.push_back(textCheck(group, name + ": bits " + std::to_string(++number), bits.get<std::string>(),
                               hexadecimal(forBits.bits()), everyBit));
  number = 0;
  for (const Json& normal : row.at("normal"))
    checks.push_back(numberCheck(group, name + ": normal " + std::to_string(++number),
                                 normal.get<std::string>(), forNormal.normal(), ofNormal));
}

double numberOf(const Json& object, const char* key) {
  const Result<double> number = parseNumber(object.at(key).get<std::string>());
  return number ? *number : 0;
}

void addSimulated(std::vector<SelfCheck>& checks, const Json& reference) {
  const Json& given = reference.at("truth");
  Truth truth;
  truth.seed = given.at("seed").get<std::uint64_t>();
  truth.distance = numberOf(given, "distance");
  truth.radius = numberOf(given, "radius");
  truth.centreX = numberOf(given, "centre_x");
  truth.axisHeight = numberOf(given, "axis_height");
  truth.intersection = numberOf(given, "intersection");
  truth.horizontalZero = Angle::fromDegrees(numberOf(given, "horizontal_zero"));
  Protocol protocol;
  protocol.points = given.at("points").get<int>();
  const std::string name = "simulate, seed " + std::to_string(truth.seed);
  const Result<Session> session = simulate(protocol, truth, truth.seed);
  if (!session) return checks.push_back(brokenCheck(group, name, session.problem().text()));
  std::string lines, first, last;
  for (const Position& position : session->positions) {
    lines += position.axisDeg + " zero " + position.zero.horizontal + " " + position.zero.vertical + "\n";
    for (const Reading& reading : position.readings) {
      last = position.axisDeg + " " + reading.point + " " + reading.horizontal + " " + reading.vertical;
      if (first.empty()) first = last;
      lines += last + "\n";
    }
  }
  checks.push_back(
      textCheck(group, name + ": first", reference.at("first").get<std::string>(), first, everyReading));
  checks.push_back(
      textCheck(group, name + ": last", reference.at("last").get<std::string>(), last, everyReading));
  checks.push_back(hashCheck(group, name + ": all", reference.at("sha256").get<std::string>(), sha256(lines),
                             everyReading));
}

}  // namespace

std::vector<SelfCheck> randomChecks(const std::string& numbers) {
  std::vector<SelfCheck> checks;
  try {
    const Json document = Json::parse(numbers);
    for (const Json& row : document.at("random")) addNumbers(checks, row);
    addSimulated(checks, document.at("simulated"));
  } catch (const Json::exception& error) {
    checks.push_back(brokenCheck(group, "numbers.json", error.what()));
  }
  return checks;
}

}  // namespace alidade
