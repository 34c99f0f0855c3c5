#include "core/wording/findings.h"

#include <utility>

#include "core/base/phrase.h"
#include "core/wording/suspects.h"

namespace alidade {

Finding inWords(const FitFinding& finding) {
  Words words = std::visit([](const auto& kind) { return wordsOf(kind); }, finding.what);
  return {finding.severity, std::move(words.text), std::move(words.remedy), finding.where};
}

std::vector<Finding> inWords(const std::vector<FitFinding>& findings) {
  std::vector<Finding> worded;
  worded.reserve(findings.size());
  for (const FitFinding& finding : findings) worded.push_back(inWords(finding));
  return worded;
}

std::vector<Finding> inWords(const std::vector<FitFinding>& findings, const std::vector<Suspect>& suspects) {
  std::vector<Finding> worded = inWords(findings);
  if (auto finding = suspectsFinding(suspects)) worded.insert(worded.begin(), *std::move(finding));
  return worded;
}

std::string inTurn(const std::string& first, const std::string& second) {
  if (first.empty() || second.empty()) return first + second;
  //: two sentences, such as what was found and what to do about it
  return Phrase::of("%1 %2", first, second);
}

}  // namespace alidade
