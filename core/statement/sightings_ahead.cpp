#include "core/statement/sightings_ahead.h"

#include <string>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/session/face.h"

namespace alidade {

namespace {

/// "5", "5 in face 2".
std::string placeText(const NextSighting& next) {
  const std::string point = std::to_string(next.point);
  return next.face == 1 ? point : Phrase::of("%1 in %2", point, faceName(next.face));
}

std::string sentenceOf(const SightingsAhead& ahead, double uncertainty) {
  const std::string wanted = displayShortest(uncertainty), minutes = displayText(ahead.minutes, 0);
  if (ahead.isReached && ahead.sightings.empty())
    return Phrase::of("U of Δd, whatever effect is there, is below %1 mm already.", wanted);
  if (ahead.isReached)
    return Phrase::of("For U = %1 mm of Δd, whatever effect is there: %2 more sightings in %3 min.", wanted,
                      ahead.sightings.size(), minutes);
  if (!ahead.expanded) return Phrase::of("These places do not determine Δd.");
  return Phrase::of("U = %1 mm of Δd is not reached: %2 more sightings come to %3 mm.", wanted,
                    ahead.sightings.size(), displayText(*ahead.expanded, decimalsFor(*ahead.expanded)));
}

}  // namespace

Statement sightingsAheadStatement(const SightingsAhead& ahead, double uncertainty) {
  using Role = Statement::Column::Role;
  Statement statement{.id = "sightings_ahead",
                      .title = Phrase::of("Sightings to come"),
                      .columns = {{"axis", "", Role::Name}, {"points", Phrase::of("points"), Role::Word}},
                      .rows = {},
                      .sentences = {sentenceOf(ahead, uncertainty)}};
  std::vector<std::string> places;
  for (std::size_t i = 0; i < ahead.sightings.size(); ++i) {
    const NextSighting& next = ahead.sightings[i];
    places.push_back(placeText(next));
    const bool isLast = i + 1 == ahead.sightings.size() || ahead.sightings[i + 1].turnsAxis;
    if (!isLast) continue;
    statement.rows.push_back({.cells = {std::to_string(next.axisDeg) + "°", listed(places)}});
    places.clear();
  }
  return statement;
}

}  // namespace alidade
