#include "core/wording/conditions.h"

#include <algorithm>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

std::string rowText(const Dependence& row) {
  const std::string position = positionName(row.axisDeg, row.time);
  if (row.round == 1 && row.face == 1) return Phrase::of("%1 point %2", position, row.point);
  return Phrase::of("%1 point %2 (round %3, face %4)", position, row.point, row.round, row.face);
}

std::string verdictText(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accept:
      return Phrase::of("accepted");
    case Verdict::Reject:
      return Phrase::of("rejected");
    case Verdict::Undecided:
      break;
  }
  return Phrase::of("undecided");
}

/// The rows whose exclusion gives this verdict.
std::string rowsText(const std::vector<Dependence>& dependences, Verdict without) {
  constexpr std::size_t mostNamed = 4;
  std::vector<std::string> rows;
  for (const Dependence& dependence : dependences)
    if (dependence.without == without) rows.push_back(rowText(dependence));
  if (rows.empty()) return "";
  const std::size_t more = rows.size() - std::min(rows.size(), mostNamed);
  rows.resize(rows.size() - more);
  if (more > 0) rows.push_back(Phrase::of("one of %1 others", more));
  return Phrase::of("%1 without %2", verdictText(without), listed(rows, Phrase::of(" or ")));
}

}  // namespace

std::string momentText(const UndetectableJump& jump) {
  const std::string position = positionName(jump.axisDeg, jump.time);
  return jump.isAfterZero ? Phrase::of("between the pointing zero and the first sighting at %1", position)
                          : Phrase::of("during the readings at %1", position);
}

std::string conditionSentence(const Diagnosis* diagnosis, const AcceptanceDecision& decision) {
  if (!diagnosis || decision.conditions.empty()) return "";
  std::vector<std::string> moments;
  double influence = 0;
  for (const std::size_t i : decision.conditions) {
    moments.push_back(momentText(diagnosis->undetectableJumps[i]));
    influence = std::max(influence, diagnosis->undetectableJumps[i].influence);
  }
  return Phrase::of(
      "The verdict holds on the condition that the tripod was not knocked %1. These readings cannot show "
      "such a knock; one of plausible size moves Δd by ± %2 mm. The probability of conformity includes "
      "it.",
      listed(moments, Phrase::of(" or ")), displayText(influence, decimalsFor(influence)));
}

std::string dependenceSentence(const std::vector<Dependence>& dependences) {
  std::vector<std::string> parts;
  for (const Verdict without : {Verdict::Undecided, Verdict::Accept, Verdict::Reject})
    if (std::string rows = rowsText(dependences, without); !rows.empty()) parts.push_back(std::move(rows));
  return parts.empty() ? "" : Phrase::of("The verdict depends on a single row: %1.", listed(parts));
}

}  // namespace alidade
