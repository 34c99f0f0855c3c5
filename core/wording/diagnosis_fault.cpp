#include "core/wording/diagnosis_fault.h"

#include <utility>

#include "core/base/phrase.h"
#include "core/wording/findings.h"

namespace alidade {

namespace {

Problem kindProblem(const NoModel& fault) {
  if (!fault.why) return {Phrase::of("there are no readings; enter the readings of the axis positions")};
  Finding finding = inWords(*fault.why);
  return {std::move(finding.text), std::move(finding.where)};
}

Problem kindProblem(const UnknownCause& fault) {
  return {Phrase::of("there is no effect “%1” in the catalogue", fault.id)};
}

Problem kindProblem(const Stopped&) {
  return {Phrase::of("the diagnosis was stopped")};
}

}  // namespace

Problem problemOf(const NoModel& fault) {
  return kindProblem(fault);
}

Problem problemOf(const DiagnosisFault& fault) {
  return std::visit([](const auto& kind) { return kindProblem(kind); }, fault);
}

}  // namespace alidade
