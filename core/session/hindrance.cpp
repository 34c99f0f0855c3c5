#include "core/session/hindrance.h"

#include <algorithm>
#include <iterator>

#include "core/base/phrase.h"
#include "core/session/session_fields.h"
#include "core/session/time_text.h"

namespace alidade {

namespace {

bool hasNumberOn(const Session& session, const std::string& field) {
  const SessionField* known = sessionFieldNamed(field);
  if (isDay(field) || (known && !known->isOfMeasurement)) return false;
  if (field != "environment.temperature_c" && field != "environment.sigma_temperature_c") return true;
  return !session.geometry.distanceExpansionPpmPerK.empty() ||
         !session.geometry.radiusExpansionPpmPerK.empty();
}

}  // namespace

std::vector<Problem> hindrances(const Session& session, const std::vector<Problem>& problems) {
  std::vector<Problem> hindering;
  std::ranges::copy_if(problems, std::back_inserter(hindering),
                       [&](const Problem& problem) { return hasNumberOn(session, problem.where.field); });
  return hindering;
}

std::optional<Problem> firstHindrance(const Session& session, const std::vector<Problem>& problems) {
  const std::vector<Problem> hindering = hindrances(session, problems);
  if (hindering.empty()) return std::nullopt;
  Problem first = hindering.front();
  if (hindering.size() > 1) first.what = Phrase::of("%1 (and %2 more)", first.what, hindering.size() - 1);
  return first;
}

}  // namespace alidade
