#include "core/adjustment/gross_errors/suspect_text.h"

#include <cmath>

#include "core/base/angle_text.h"
#include "core/base/quantity_text.h"
#include "core/base/visible_text.h"

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

}  // namespace

std::string nameOf(const Suspect& suspect) {
  std::string name = std::to_string(suspect.axisDeg) + "°, point " + std::to_string(suspect.point);
  if (suspect.round != 1) name += ", round " + std::to_string(suspect.round);
  if (suspect.face != 1) name += ", face " + std::to_string(suspect.face);
  return name + ", " + suspect.where.field;
}

const std::string& textAt(const Session& session, const Place& where) {
  const Reading& reading = session.positions[*where.position].readings[*where.reading];
  if (where.field == "face") return reading.face;
  if (where.field == "horizontal") return reading.horizontal;
  return where.field == "vertical" ? reading.vertical : reading.slider;
}

std::string sentenceOf(const Session& session, const Correction& correction, Angle residual) {
  std::string sentence;
  for (const CellChange& change : correction.changes) {
    const std::string& typed = textAt(session, change.where);
    const bool otherRow = change.where.reading != correction.changes.front().where.reading;
    sentence += (sentence.empty() ? "" : ", ") +
                (sentence.empty() ? capitalised(change.where.field) : change.where.field) +
                (otherRow ? " of row " + std::to_string(*change.where.reading + 1) : "") + " " +
                (typed.empty() ? "(empty)" : shortened(typed, longestTyped)) + " → " + change.text;
  }
  return sentence + ": " + slipName(correction.slip) + "; residual then " + signedSize(residual) + ".";
}

std::string sentenceOf(const Suspect& suspect) {
  const std::string fault = suspect.where.field == "face"           ? "the other face"
                            : std::isfinite(suspect.size.radians()) ? "off by " + signedSize(suspect.size)
                                                                    : "no angle";
  return nameOf(suspect) + ": " + fault + ". " +
         (suspect.proposals.empty() ? "No single slip explains it: read it again."
                                    : "Probably meant: " + suspect.proposals.front().sentence);
}

}  // namespace alidade
