#include "core/wording/guidance.h"

#include <algorithm>
#include <set>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/wording/findings.h"

namespace alidade {

namespace {

std::string placesText(const SightingProtocol& protocol) {
  std::set<std::size_t> counts;
  for (const ProtocolPosition& position : protocol.positions)
    counts.insert(protocol.placesOf(position).size());
  if (counts.empty()) return Phrase::of("no places");
  if (counts.size() > 1) return Phrase::of("%1 to %2 places", *counts.begin(), *counts.rbegin());
  return *counts.begin() == 1 ? Phrase::of("1 place") : Phrase::of("%1 places", *counts.begin());
}

std::string facesText(const SightingProtocol& protocol) {
  bool areBoth = true, isOne = true;
  std::set<int> faces;
  for (const ProtocolPosition& position : protocol.positions)
    for (const ProtocolRound& round : position.rounds) {
      const std::set<int> ofRound(round.faces.begin(), round.faces.end());
      areBoth = areBoth && ofRound.size() > 1;
      isOne = isOne && ofRound.size() == 1;
      faces.insert(ofRound.begin(), ofRound.end());
    }
  if (faces.size() < 2) return Phrase::of("one face");
  if (areBoth) return Phrase::of("both faces");
  return isOne ? Phrase::of("one face per round") : Phrase::of("both faces in some rounds");
}

std::string roundsText(const SightingProtocol& protocol) {
  std::set<std::size_t> counts;
  bool isBack = false;
  for (const ProtocolPosition& position : protocol.positions) {
    counts.insert(position.rounds.size());
    isBack = isBack || std::ranges::any_of(position.rounds, &ProtocolRound::isBack);
  }
  const std::size_t most = counts.empty() ? 1 : *counts.rbegin();
  if (most == 1) return isBack ? Phrase::of("back only") : Phrase::of("there only");
  if (counts.size() > 1) return Phrase::of("up to %1 rounds", most);
  if (!isBack) return Phrase::of("%1 rounds", most);
  return most == 2 ? Phrase::of("there and back") : Phrase::of("%1 rounds, there and back", most);
}

std::string axesText(const SightingProtocol& protocol) {
  std::set<int> seen, again;
  for (const ProtocolPosition& position : protocol.positions)
    if (!seen.insert(position.axisDeg).second) again.insert(position.axisDeg);
  if (seen.size() == 1) return Phrase::of("only at %1°", *seen.begin());
  if (again.size() > 1) return Phrase::of("both positions again");
  return again.empty() ? "" : Phrase::of("%1° again", *again.begin());
}

bool turnsCircle(const SightingProtocol& protocol) {
  return std::ranges::any_of(protocol.positions,
                             [](const ProtocolPosition& position) { return !position.circleTurn.empty(); });
}

/// Names the sightings that satisfy `isIt`: "Skipped: 0°: point 5; 0°: point 6 and 3 more."; may be empty.
template <typename IsIt>
std::string sightingsText(const ProtocolProgress& progress, const char* sentence, const IsIt& isIt) {
  constexpr std::size_t mostNamed = 6;
  std::string names;
  std::size_t count = 0;
  for (const FollowedSighting& followed : progress.sightings) {
    if (!isIt(followed) || ++count > mostNamed) continue;
    names += (names.empty() ? "" : "; ") + sightingNameInSession(followed.planned);
  }
  if (count > mostNamed) names = Phrase::of("%1 and %2 more", names, count - mostNamed);
  return count == 0 ? "" : Phrase::of(sentence, names);
}

}  // namespace

std::string protocolInWords(const SightingProtocol& protocol) {
  const SightingProtocol listed = protocol.isByWorth ? listedOrder(protocol) : protocol;
  std::vector<std::string> parts{placesText(listed), facesText(listed), roundsText(listed)};
  if (listed.readsSlider) parts.push_back(Phrase::of("with slider readings"));
  if (turnsCircle(listed)) parts.push_back(Phrase::of("the circle turned between positions"));
  if (std::string axes = axesText(listed); !axes.empty()) parts.push_back(std::move(axes));
  if (protocol.isByWorth) parts.push_back(Phrase::of("each sighting chosen by its information"));
  return alidade::listed(parts);
}

std::string deviationSentences(const ProtocolProgress& progress) {
  const auto is = [](SightingState state) {
    return [state](const FollowedSighting& followed) { return followed.state == state; };
  };
  std::string sentences =
      Phrase::of("%1 of %2 sightings are taken.", progress.taken, progress.sightings.size());
  for (const std::string& sentence :
       {sightingsText(progress, PHRASE_LATER("Phrase", "Skipped: %1."), is(SightingState::Missed)),
        sightingsText(progress, PHRASE_LATER("Phrase", "Taken out of order: %1."),
                      [](const FollowedSighting& followed) { return followed.isOutOfTurn; }),
        sightingsText(progress, PHRASE_LATER("Phrase", "Taken again: %1."),
                      [](const FollowedSighting& followed) { return followed.isRepeated; }),
        sightingsText(progress, PHRASE_LATER("Phrase", "Excluded: %1."), is(SightingState::Excluded))})
    sentences = inTurn(sentences, sentence);
  return inTurn(sentences, unplannedSentence(progress));
}

}  // namespace alidade
