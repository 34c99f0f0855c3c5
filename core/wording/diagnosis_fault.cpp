#include "core/wording/diagnosis_fault.h"

#include <utility>

#include "core/wording/findings.h"

namespace alidade {

namespace {

Problem kindProblem(const NoModel& fault) {
  if (!fault.why) return {"there are no readings; enter those of the axis positions"};
  Finding finding = inWords(*fault.why);
  return {std::move(finding.text), std::move(finding.where)};
}

Problem kindProblem(const UnknownCause& fault) {
  return {"there is no effect “" + fault.id + "” in the catalogue"};
}

Problem kindProblem(const Stopped&) {
  return {"the diagnosis was stopped"};
}

}  // namespace

Problem problemOf(const NoModel& fault) {
  return kindProblem(fault);
}

Problem problemOf(const DiagnosisFault& fault) {
  return std::visit([](const auto& kind) { return kindProblem(kind); }, fault);
}

}  // namespace alidade
