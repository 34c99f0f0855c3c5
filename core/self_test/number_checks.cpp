#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/statistics.h"
#include "core/self_test/check_families.h"

namespace alidade {

namespace {

using Json = nlohmann::json;

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

constexpr CheckTolerance tenDigits = {
    .relative = 1e-10,
    .reason = PHRASE_LATER("Phrase",
                           "1e-10: probabilities and coverage factors are shown with five digits at most")};
constexpr CheckTolerance ofAngle = {
    .relative = 1e-15,
    .reason = PHRASE_LATER("Phrase", "1e-15: a few rounding errors in double precision, 2e-16 each")};

constexpr const char* tableDigit =
    PHRASE_LATER("Phrase", "half of the last printed digit (JCGM 100:2008, table G.2)");

double value(const std::string& function, const std::vector<double>& of) {
  if (function == "t" && of.size() == 2) return coverageFactor(of[0], of[1]);
  if (function == "chi2" && of.size() == 2) return chiSquareUpperTail(of[0], of[1]).value_or(noNumber);
  if (function == "F" && of.size() == 3) return fUpperTail(of[0] * of[1], of[1], of[2]).value_or(noNumber);
  if (function == "z" && of.size() == 1) return normalQuantile(of[0]);
  return noNumber;
}

SelfCheck distributionCheck(const Json& row) {
  const std::string function = row.at("function").get<std::string>();
  std::string name = function + "(";
  std::vector<double> arguments;
  for (const Json& argument : row.at("arguments")) {
    const std::string text = argument.get<std::string>();
    name += (arguments.empty() ? "" : "; ") + text;
    arguments.push_back(text == "infinite"  ? std::numeric_limits<double>::infinity()
                        : parseNumber(text) ? *parseNumber(text)
                                            : noNumber);
  }
  return numberCheck(CheckGroup::Distributions, name + ")", row.at("value").get<std::string>(),
                     value(function, arguments), tenDigits);
}

void addTableOfGuide(std::vector<SelfCheck>& checks) {
  struct Row {
    double coverage, freedom;
    const char* printed;
  };
  for (const Row& row : {Row{0.95, 1, "12.71"}, Row{0.95, 10, "2.23"}, Row{0.95, 20, "2.09"},
                         Row{0.9545, 50, "2.05"}, Row{0.9973, 5, "5.51"}})
    checks.push_back(numberCheck(
        CheckGroup::Distributions,
        "t(" + shortestText(row.coverage) + "; " + shortestText(row.freedom) + "), JCGM 100", row.printed,
        coverageFactor(row.coverage, row.freedom), {.absolute = 0.005, .reason = tableDigit}));
}

}  // namespace

std::vector<SelfCheck> distributionChecks(const std::string& numbers) {
  std::vector<SelfCheck> checks;
  try {
    const Json document = Json::parse(numbers);
    for (const Json& row : document.at("distributions")) checks.push_back(distributionCheck(row));
  } catch (const Json::exception& error) {
    checks.push_back(brokenCheck(CheckGroup::Distributions, "numbers.json", error.what()));
  }
  addTableOfGuide(checks);
  return checks;
}

std::vector<SelfCheck> angleChecks(const std::string& numbers) {
  constexpr auto group = CheckGroup::Angles;
  std::vector<SelfCheck> checks;
  try {
    const Json document = Json::parse(numbers);
    for (const Json& row : document.at("angles")) {
      const std::string text = row.at("text").get<std::string>();
      const Result<Angle> angle = parseAngle(text);
      if (!angle) {
        checks.push_back(brokenCheck(group, text, angle.problem().text()));
        continue;
      }
      checks.push_back(numberCheck(group, text + " (rad)", row.at("radians").get<std::string>(),
                                   angle->radians(), ofAngle));
      checks.push_back(numberCheck(group, text + " (″)", row.at("arcseconds").get<std::string>(),
                                   angle->arcseconds(), ofAngle));
    }
  } catch (const Json::exception& error) {
    checks.push_back(brokenCheck(group, "numbers.json", error.what()));
  }
  return checks;
}

}  // namespace alidade
