#include "core/wording/findings.h"

#include "core/base/number_text.h"
#include "core/base/phrase.h"

namespace alidade {

using namespace arc_fault;

namespace {

std::string kindText(const TooFewPlaces& fault) {
  if (fault.places == 0) return Phrase::of("has no readings yet");
  return fault.places == 1
             ? Phrase::of(
                   "has readings of 1 place; a circle needs three, and five or more for a check: sight more "
                   "places")
             : Phrase::of(
                   "has readings of %1 places; a circle needs three, and five or more for a check: sight "
                   "more places",
                   fault.places);
}

std::string kindText(const PlacesRepeat& fault) {
  return fault.different == 1 ? Phrase::of(
                                    "has readings of only 1 distinct place, the others are repeats; a circle "
                                    "needs three: move the slider between the points")
                              : Phrase::of(
                                    "has readings of only %1 distinct places, the others are repeats; a "
                                    "circle needs three: move the slider between the points",
                                    fault.different);
}

std::string kindText(const PlacesOnALine&) {
  return Phrase::of(
      "has readings that lie on a straight line, which determines no circle: check them, and sight places "
      "over a longer arc");
}

std::string kindText(const ArcTooShort& fault) {
  return Phrase::of(
      "spans only %1° of arc: the reading noise hides its sagitta, so radius and centre are undetermined: "
      "sight places over a longer arc",
      displayText(fault.span.degrees(), 2));
}

std::string kindText(const RadiusUndetermined&) {
  return Phrase::of(
      "has readings that determine neither radius nor centre: look for misread values, the degrees first, "
      "and check the stated σ of the circles");
}

std::string kindText(const TooFewForPublished& fault) {
  return Phrase::of("has readings of %1 places; the published method needs five: sight more places",
                    fault.places);
}

std::string kindText(const NoUniqueSolution&) {
  return Phrase::of(
      "has readings for which the equations of the published method have no unique solution: sight places "
      "over a longer arc");
}

std::string kindText(const NoPublishedCircle&) {
  return Phrase::of(
      "has readings from which the published method finds no circle: check L, R0 and the readings");
}

}  // namespace

std::string textOf(const ArcFault& fault) {
  return std::visit([](const auto& kind) { return kindText(kind); }, fault);
}

}  // namespace alidade
