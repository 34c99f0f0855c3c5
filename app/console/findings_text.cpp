#include "app/console/findings_text.h"

#include "app/console/text_layout.h"

namespace alidade::console {

namespace {

std::string findingText(const Finding& finding) {
  std::string text = finding.severity == Severity::Note      ? "Note: "
                     : finding.severity == Severity::Warning ? "Warning: "
                                                             : "Error: ";
  const std::string place = finding.where.path();
  if (!place.empty()) text += place + ": ";
  text += finding.text;
  return "  " + paragraph(finding.remedy.empty() ? text : text + " " + finding.remedy, 4);
}

}  // namespace

std::string findingsText(const std::vector<Finding>& findings) {
  if (findings.empty()) return "";
  std::string text = "\nFindings\n";
  for (const Finding& finding : findings) text += findingText(finding);
  return text;
}

}  // namespace alidade::console
