#include "core/wording/gap_shares.h"

#include <algorithm>
#include <string_view>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

/// The identifier of a division or of a part, and its words.
struct Named {
  const char* id;
  const char* words;
};

constexpr Named divisions[] = {
    {"frame", PHRASE_LATER("Phrase", "belongs to")},
    {"position", PHRASE_LATER("Phrase", "axis at")},
    {"time", PHRASE_LATER("Phrase", "in time")},
    {"closure", PHRASE_LATER("Phrase", "shows in")},
    {"sector", PHRASE_LATER("Phrase", "along the arc")},
    {"circle", PHRASE_LATER("Phrase", "circle")},
    {"face", PHRASE_LATER("Phrase", "face")},
    {"round", PHRASE_LATER("Phrase", "round")},
    {"session", PHRASE_LATER("Phrase", "session")},
    {"instrument", PHRASE_LATER("Phrase", "instrument")},
    {"guideway", PHRASE_LATER("Phrase", "guideway")},
};

constexpr Named frames[] = {
    {"guideway", PHRASE_LATER("Phrase", "guideway")},
    {"instrument", PHRASE_LATER("Phrase", "instrument")},
    {"guideway or instrument", PHRASE_LATER("Phrase", "guideway or instrument")},
    {"time", PHRASE_LATER("Phrase", "time")},
    {"readings", PHRASE_LATER("Phrase", "readings")},
    {"noise", PHRASE_LATER("Phrase", "noise")},
};

constexpr Named circles[] = {
    {"horizontal", PHRASE_LATER("Phrase", "horizontal")},
    {"vertical", PHRASE_LATER("Phrase", "vertical")},
    {"slider", PHRASE_LATER("Phrase", "slider")},
};

constexpr Named closures[] = {
    {"radius", PHRASE_LATER("Phrase", "the radii")},
    {"centre", PHRASE_LATER("Phrase", "the centres")},
    {"repeat", PHRASE_LATER("Phrase", "positions at one axis angle")},
    {"zeros", PHRASE_LATER("Phrase", "the pointing zeros")},
    {"readings", PHRASE_LATER("Phrase", "the residuals")},
};

constexpr Named quarters[] = {
    {"quarter 1", PHRASE_LATER("Phrase", "1st quarter")},
    {"quarter 2", PHRASE_LATER("Phrase", "2nd quarter")},
    {"quarter 3", PHRASE_LATER("Phrase", "3rd quarter")},
    {"quarter 4", PHRASE_LATER("Phrase", "4th quarter")},
};

template <std::size_t count>
std::string wordsOf(const Named (&list)[count], const std::string& id) {
  const auto* const found = std::ranges::find(list, id, &Named::id);
  return found == std::end(list) ? id : Phrase::of(found->words);
}

/// "0°" of "0", "0° again" of "0, time 2".
std::string nameOfPosition(const std::string& id) {
  constexpr std::string_view before = ", time ";
  const std::size_t at = id.find(before);
  const Result<int> axisDeg = parseWhole(id.substr(0, at));
  const Result<int> repeat =
      at == std::string::npos ? Result<int>(1) : parseWhole(id.substr(at + before.size()));
  return axisDeg && repeat ? positionName(*axisDeg, *repeat) : id;
}

}  // namespace

std::string divisionName(const GapShare& share) {
  return wordsOf(divisions, share.by);
}

std::string partName(const GapShare& share) {
  if (share.by == "position") return nameOfPosition(share.of);
  if (share.by == "frame") return wordsOf(frames, share.of);
  if (share.by == "circle") return wordsOf(circles, share.of);
  if (share.by == "closure") return wordsOf(closures, share.of);
  return share.by == "time" ? wordsOf(quarters, share.of) : share.of;
}

}  // namespace alidade
