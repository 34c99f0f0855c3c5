#include "core/wording/suspects.h"

#include <cmath>

#include "core/base/angle_text.h"
#include "core/base/quantity_text.h"
#include "core/base/visible_text.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

constexpr std::size_t longestTyped = 40;

/// In arcseconds up to two minutes, then in degrees, minutes and seconds; with its sign.
std::string signedSize(Angle size) {
  const double seconds = size.arcseconds();
  const std::string sign = seconds < 0 ? "" : "+";
  return sign + (std::abs(seconds) < 120 ? displayText(seconds, 1) + "″" : formatDms(size));
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// "0°, point 5, vertical"; round and face where they are not 1.
std::string nameOf(const Suspect& suspect) {
  std::string name = positionName(suspect.axisDeg, suspect.time) + ", point " + std::to_string(suspect.point);
  if (suspect.round != 1) name += ", round " + std::to_string(suspect.round);
  if (suspect.face != 1) name += ", face " + std::to_string(suspect.face);
  return name + ", " + suspect.where.field;
}

}  // namespace

std::string slipName(EntrySlip slip) {
  switch (slip) {
    case EntrySlip::DigitsSwapped:
      return "two digits swapped";
    case EntrySlip::OneDigitWrong:
      return "one digit wrong";
    case EntrySlip::DegreeOff:
      return "one degree off";
    case EntrySlip::TenMinutesOff:
      return "ten minutes off";
    case EntrySlip::MinuteOff:
      return "one minute off";
    case EntrySlip::TenSecondsOff:
      return "ten seconds off";
    case EntrySlip::CirclesSwapped:
      return "the two circles swapped";
    case EntrySlip::WrongFace:
      return "the wrong face";
    case EntrySlip::NeighbouringRow:
      return "swapped with the neighbouring row";
  }
  return "";
}

std::string sentenceOf(const Proposal& proposal) {
  std::string sentence;
  for (const CellChange& change : proposal.changes) {
    const bool otherRow = change.where.reading != proposal.changes.front().where.reading;
    sentence += (sentence.empty() ? "" : ", ") +
                (sentence.empty() ? capitalised(change.where.field) : change.where.field) +
                (otherRow ? " of row " + std::to_string(*change.where.reading + 1) : "") + " " +
                (change.typed.empty() ? "(empty)" : shortened(change.typed, longestTyped)) + " → " +
                change.text;
  }
  return sentence + ": " + slipName(proposal.slip) + "; residual then " + signedSize(proposal.residual) + ".";
}

std::string sentenceOf(const Suspect& suspect) {
  const std::string fault = suspect.where.field == "face"           ? "the other face"
                            : std::isfinite(suspect.size.radians()) ? "off by " + signedSize(suspect.size)
                                                                    : "no angle";
  return nameOf(suspect) + ": " + fault + ". " +
         (suspect.proposals.empty() ? "No single slip explains it: read it again."
                                    : "Probably meant: " + sentenceOf(suspect.proposals.front()));
}

std::optional<Finding> suspectsFinding(const std::vector<Suspect>& suspects) {
  if (suspects.empty()) return std::nullopt;
  std::string names;
  for (const Suspect& suspect : suspects) names += (names.empty() ? "" : "; ") + nameOf(suspect);
  const bool one = suspects.size() == 1;
  const std::string it = one ? "it" : "them";
  return Finding{
      Severity::Warning,
      (one ? "A reading looks misread: " : std::to_string(suspects.size()) + " readings look misread: ") +
          names + ".",
      "Check " + it + " in the field book, then correct or exclude " + it +
          "; until then every usable reading takes part in the result.",
      one ? suspects.front().where : Place{}};
}

}  // namespace alidade
