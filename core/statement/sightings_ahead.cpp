#include "core/statement/sighting_choice.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/session/face.h"
#include "core/statement/next_measures.h"

namespace alidade {

namespace {

using Sightings = std::span<const NextSighting>;

/// Removes the first sightings from `rest`, as far as their key (`keyOf`) is the same, and returns them.
template <typename KeyOf>
Sightings firstAlike(Sightings& rest, KeyOf keyOf) {
  const auto end = std::ranges::find_if(
      rest, [&](const NextSighting& next) { return keyOf(next) != keyOf(rest.front()); });
  const Sightings alike(rest.begin(), end);
  rest = rest.subspan(alike.size());
  return alike;
}

/// "5, 9 (2×), 4".
std::string pointsText(Sightings sightings) {
  std::vector<std::string> texts;
  while (!sightings.empty()) {
    const Sightings again = firstAlike(sightings, [](const NextSighting& next) { return next.point; });
    texts.push_back(std::to_string(again.front().point));
    if (again.size() > 1) texts.back() += " (" + std::to_string(again.size()) + "×)";
  }
  return listed(texts);
}

/// "5, 9 (2×), 4; 4, 9 in face 2".
std::string placesText(Sightings sightings) {
  std::string text;
  while (!sightings.empty()) {
    const Sightings ofFace = firstAlike(sightings, [](const NextSighting& next) { return next.face; });
    const std::string points = pointsText(ofFace);
    const int face = ofFace.front().face;
    //: point numbers and their face: "4, 9 in face 2"
    if (text.empty())
      text = face == 1 ? points : Phrase::of("%1 in %2", points, faceName(face));
    else
      text = Phrase::of("%1; %2 in %3", text, points, faceName(face));
  }
  return text;
}

std::string sentenceOf(const SightingsAhead& ahead, double uncertainty) {
  const std::string wanted = displayShortest(uncertainty), minutes = displayText(ahead.minutes, 0);
  if (ahead.isReached && ahead.sightings.empty())
    return Phrase::of("U of Δd is already below %1 mm, whatever effect is present.", wanted);
  if (ahead.isReached)
    return Phrase::of("U = %1 mm of Δd, whatever effect is present, needs further sightings: %2, in %3 min.",
                      wanted, ahead.sightings.size(), minutes);
  if (!ahead.expanded)
    return Phrase::of(
        "The protocol has no position left at the other axis angle: Δd needs readings at 0° and at 180°.");
  return Phrase::of("U = %1 mm of Δd is not reached: %2 more sightings give %3 mm.", wanted,
                    ahead.sightings.size(), displayText(*ahead.expanded, decimalsFor(*ahead.expanded)));
}

}  // namespace

Statement sightingsAheadStatement(const SightingsAhead& ahead, double uncertainty) {
  using Role = Statement::Column::Role;
  Statement statement{.id = "sightings_ahead",
                      .title = Phrase::of("Sightings to come"),
                      .columns = {{"axis", "", Role::Name},
                                  {"sightings", Phrase::of("sightings")},
                                  {"minutes", Phrase::of("minutes")},
                                  {"points", Phrase::of("points"), Role::Text}},
                      .rows = {},
                      .sentences = {sentenceOf(ahead, uncertainty)}};
  if (!ahead.isReached) {
    if (!ahead.instead.empty()) addUncertainties(statement, ahead.instead);
    return statement;
  }
  for (Sightings rest = ahead.sightings; !rest.empty();) {
    const Sightings here = firstAlike(rest, [](const NextSighting& next) { return next.axisDeg; });
    double minutes = 0;
    for (const NextSighting& next : here) minutes += next.minutes;
    statement.rows.push_back(
        {.cells = {std::to_string(here.front().axisDeg) + "°", std::to_string(here.size()),
                   displayText(minutes, 0), placesText(here)}});
  }
  return statement;
}

}  // namespace alidade
