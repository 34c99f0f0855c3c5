#pragma once

#include <cstddef>
#include <variant>

#include "core/base/angle.h"

namespace alidade {

/// Reasons why the readings of an arc give no circle; `core/wording/arc_fault.h` has the sentences.
namespace arc_fault {

/// A circle needs three places.
struct TooFewPlaces {
  std::size_t places = 0;  ///< 0…2
};
/// Fewer than three places differ; every further place repeats one of them.
struct PlacesRepeat {
  std::size_t different = 0;  ///< 1 or 2
};
struct PlacesOnALine {};
/// The noise hides the sagitta of the arc.
struct ArcTooShort {
  Angle span;  ///< below 60°
};
/// The noise hides the radius although the arc is not short.
struct RadiusUndetermined {};

/// The published method needs five places.
struct TooFewForPublished {
  int places = 0;  ///< 0…4
};
struct NoUniqueSolution {};
struct NoPublishedCircle {};

}  // namespace arc_fault

using ArcFault =
    std::variant<arc_fault::TooFewPlaces, arc_fault::PlacesRepeat, arc_fault::PlacesOnALine,
                 arc_fault::ArcTooShort, arc_fault::RadiusUndetermined, arc_fault::TooFewForPublished,
                 arc_fault::NoUniqueSolution, arc_fault::NoPublishedCircle>;

}  // namespace alidade
