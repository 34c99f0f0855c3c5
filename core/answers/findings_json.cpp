#include "core/answers/findings_json.h"

#include <nlohmann/json.hpp>

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

std::string severityName(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "";
}

}  // namespace

Json findingsJson(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"severity", severityName(finding.severity)},
                    {"text", finding.text},
                    {"remedy", finding.remedy},
                    {"where", finding.where.path()}});
  }
  return list;
}

}  // namespace alidade
