#include "app/console/findings_output.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/console/text_layout.h"
#include "core/adjustment/result/session_findings.h"
#include "core/adjustment/result/setup_findings.h"
#include "core/wording/findings.h"

namespace alidade::console {

namespace {

using Json = nlohmann::ordered_json;

std::string findingText(const Finding& finding) {
  std::string text = finding.severity == Severity::Note      ? "Note: "
                     : finding.severity == Severity::Warning ? "Warning: "
                                                             : "Error: ";
  const std::string place = finding.where.path();
  if (!place.empty()) text += place + ": ";
  text += finding.text;
  return "  " + paragraph(finding.remedy.empty() ? text : text + " " + finding.remedy, 4);
}

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

std::string findingsText(const std::vector<Finding>& findings) {
  if (findings.empty()) return "";
  std::string text = "\nFindings\n";
  for (const Finding& finding : findings) text += findingText(finding);
  return text;
}

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

std::optional<Problem> absence(const Measurement& measurement, std::size_t fitted,
                               const std::vector<FitFinding>& findings) {
  if (fitted > 0 && fitted == measurement.arcs.size()) return std::nullopt;
  const auto error = std::ranges::find(findings, Severity::Error, &FitFinding::severity);
  if (error == findings.end())
    return Problem{"there are no readings to fit; enter those of the axis positions"};
  const Finding finding = inWords(*error);
  return Problem{finding.remedy.empty() ? finding.text : finding.text + " " + finding.remedy, finding.where};
}

Result<std::vector<Finding>> findingsBeforehand(const Measurement& measurement, const SessionFit& fit) {
  if (auto problem = absence(measurement, fit.arcs.size(), fit.findings)) return *std::move(problem);
  std::vector<FitFinding> findings = missingPositions(measurement);
  std::ranges::move(setupFindings(measurement, fit), std::back_inserter(findings));
  std::ranges::move(modelFindings(measurement), std::back_inserter(findings));
  return inWords(findings);
}

}  // namespace alidade::console
