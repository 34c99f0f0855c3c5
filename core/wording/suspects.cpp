#include "core/wording/suspects.h"

#include <cmath>
#include <vector>

#include "core/base/angle_text.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/session/face.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

constexpr std::size_t longestTyped = 40;

/// An angle with its sign: below two minutes in arcseconds, otherwise in degrees, minutes and seconds.
std::string signedSize(Angle size) {
  const double seconds = size.arcseconds();
  const std::string sign = seconds < 0 ? "" : "+";
  return sign + (std::abs(seconds) < 120 ? displayText(seconds, 1) + "″" : formatDms(size));
}

/// The field's name for people: "vertical".
std::string fieldName(const std::string& field) {
  if (field == "horizontal") return Phrase::of("horizontal");
  if (field == "vertical") return Phrase::of("vertical");
  if (field == "slider") return Phrase::of("slider");
  return field == "face" ? Phrase::of("face") : field;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

std::string nameOf(const Suspect& suspect) {
  std::vector<std::string> parts{positionName(suspect.axisDeg, suspect.repeat),
                                 Phrase::of("point %1", suspect.point)};
  if (suspect.round != 1) parts.push_back(Phrase::of("round %1", suspect.round));
  if (suspect.face != 1) parts.push_back(faceName(suspect.face));
  parts.push_back(fieldName(suspect.where.field));
  return listed(parts);
}

std::string entryErrorName(EntryError error) {
  switch (error) {
    case EntryError::DigitsSwapped:
      return Phrase::of("two digits swapped");
    case EntryError::OneDigitWrong:
      return Phrase::of("one digit wrong");
    case EntryError::DegreeOff:
      return Phrase::of("one degree off");
    case EntryError::TenMinutesOff:
      return Phrase::of("ten minutes off");
    case EntryError::MinuteOff:
      return Phrase::of("one minute off");
    case EntryError::TenSecondsOff:
      return Phrase::of("ten seconds off");
    case EntryError::CirclesSwapped:
      return Phrase::of("the two circles swapped");
    case EntryError::WrongFace:
      return Phrase::of("the wrong face");
    case EntryError::NeighbouringRow:
      return Phrase::of("swapped with the neighbouring row");
  }
  return "";
}

std::string sentenceOf(const Proposal& proposal) {
  std::vector<std::string> changes;
  for (const CellChange& change : proposal.changes) {
    const bool otherRow = change.where.reading != proposal.changes.front().where.reading;
    const std::string name = fieldName(change.where.field),
                      cell = otherRow ? Phrase::of("%1 of row %2", name, *change.where.reading + 1) : name;
    changes.push_back((changes.empty() ? capitalised(cell) : cell) + " " +
                      (change.typed.empty() ? Phrase::of("(empty)") : shortened(change.typed, longestTyped)) +
                      " → " + change.text);
  }
  return Phrase::of("%1: %2; the residual becomes %3.", listed(changes), entryErrorName(proposal.error),
                    signedSize(proposal.residual));
}

std::string faultOf(const Suspect& suspect) {
  if (suspect.where.field == "face") return Phrase::of("the wrong face");
  return std::isfinite(suspect.size.radians()) ? Phrase::of("off by %1", signedSize(suspect.size))
                                               : Phrase::of("not an angle");
}

std::string intentionOf(const Suspect& suspect) {
  if (suspect.isMasked) return Phrase::of("More than one reading may be wrong here: read it again.");
  return suspect.proposals.empty() ? Phrase::of("No single gross error explains the value: read it again.")
                                   : sentenceOf(suspect.proposals.front());
}

std::string sentenceOf(const Suspect& suspect) {
  const std::string intention = intentionOf(suspect);
  //: the name of a reading, how wrong it is, and what was probably meant or has to be done
  return suspect.isMasked || suspect.proposals.empty()
             ? Phrase::of("%1: %2. %3", nameOf(suspect), faultOf(suspect), intention)
             : Phrase::of("%1: %2. Probably meant: %3", nameOf(suspect), faultOf(suspect), intention);
}

std::optional<Finding> suspectsFinding(const std::vector<Suspect>& suspects) {
  if (suspects.empty()) return std::nullopt;
  std::string names;
  for (const Suspect& suspect : suspects) names += (names.empty() ? "" : Phrase::of("; ")) + nameOf(suspect);
  const bool one = suspects.size() == 1;
  return Finding{
      Severity::Warning,
      one ? Phrase::of("A reading looks misread: %1.", names)
          : Phrase::of("%1 readings look misread: %2.", suspects.size(), names),
      one ? Phrase::of("Check it in the field book, then correct or exclude it; until then every usable "
                       "reading takes "
                       "part in the result.")
          : Phrase::of(
                "Check them in the field book, then correct or exclude them; until then every usable reading "
                "takes part in the result."),
      one ? suspects.front().where : Place{}};
}

}  // namespace alidade
