#include "core/self_test/self_test.h"

#include <nlohmann/json.hpp>

#include "core/answers/json_text.h"

namespace alidade {

namespace {

const char* nameOf(SelfCheck::Outcome outcome) {
  switch (outcome) {
    case SelfCheck::Outcome::Passed:
      return "passed";
    case SelfCheck::Outcome::Failed:
      return "failed";
    case SelfCheck::Outcome::LeftOut:
      break;
  }
  return "left-out";
}

nlohmann::ordered_json orNull(const std::optional<double>& share) {
  return share ? nlohmann::ordered_json(*share) : nlohmann::ordered_json(nullptr);
}

}  // namespace

std::string selfTestJson(const SelfTest& test, const std::string& at) {
  using Json = nlohmann::ordered_json;
  Json environment = Json::object(), checks = Json::array();
  for (const auto& [name, value] : test.environment) environment[name] = value;
  for (const SelfCheck& check : test.checks)
    checks.push_back({{"group", alidade::nameOf(check.group)},
                      {"name", check.name},
                      {"expected", check.expected},
                      {"found", check.found},
                      {"deviation", orNull(check.deviation)},
                      {"tolerance", orNull(check.tolerance)},
                      {"reason", check.reason},
                      {"outcome", nameOf(check.outcome)}});
  return answerText({{"at", at},
                     {"verdict", test.hasPassed() ? "pass" : "fail"},
                     {"passed", test.count(SelfCheck::Outcome::Passed)},
                     {"failed", test.count(SelfCheck::Outcome::Failed)},
                     {"left_out", test.count(SelfCheck::Outcome::LeftOut)},
                     {"environment", std::move(environment)},
                     {"checks", std::move(checks)}});
}

}  // namespace alidade
