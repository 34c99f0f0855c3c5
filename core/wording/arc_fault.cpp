#include "core/wording/arc_fault.h"

#include "core/base/list_text.h"
#include "core/base/quantity_text.h"

namespace alidade {

using namespace arc_fault;

namespace {

std::string kindText(const TooFewPlaces& fault) {
  return "has readings of " + counted(fault.places, "place") +
         "; a circle needs three, and five or more for a check: sight more places";
}

std::string kindText(const PlacesRepeat& fault) {
  return "has readings of only " + std::to_string(fault.different) + " different " +
         (fault.different == 1 ? "place" : "places") +
         ", the others repeat them; a circle needs three: move the slider between the points";
}

std::string kindText(const PlacesOnALine&) {
  return "has readings that lie on a straight line, which fixes no circle: check them, and sight places over "
         "a longer arc";
}

std::string kindText(const ArcTooShort& fault) {
  return "spans only " + displayText(fault.span.degrees(), 2) +
         "° of arc: its sagitta drowns in the reading noise, so neither radius nor centre can be told: sight "
         "places over a longer arc";
}

std::string kindText(const NothingTold&) {
  return "has readings that tell neither radius nor centre: look for misread values, the degrees first, and "
         "check the stated σ of the circles";
}

std::string kindText(const TooFewForPublished& fault) {
  return "has readings of " + std::to_string(fault.places) +
         " places; the published method needs five: sight more places";
}

std::string kindText(const NoUniqueSolution&) {
  return "has readings that leave the published system without a unique solution: sight places over a longer "
         "arc";
}

std::string kindText(const NoPublishedCircle&) {
  return "has readings from which the published method finds no circle: check L, R0 and the readings";
}

}  // namespace

std::string textOf(const ArcFault& fault) {
  return std::visit([](const auto& kind) { return kindText(kind); }, fault);
}

}  // namespace alidade
