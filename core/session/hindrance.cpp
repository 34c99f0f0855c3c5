#include "core/session/hindrance.h"

#include <algorithm>
#include <iterator>

namespace alidade {

namespace {

bool hasNumberOn(const Session& session, const std::string& field) {
  if (field == "measured_on" || field.ends_with(".date")) return false;
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

}  // namespace alidade
