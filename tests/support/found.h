#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include "core/adjustment/result/fit_finding.h"

namespace alidade::test {

template <typename Kind, typename Variant>
inline constexpr bool holds = false;
template <typename Kind, typename... Kinds>
inline constexpr bool holds<Kind, std::variant<Kinds...>> = (std::is_same_v<Kind, Kinds> || ...);

/// The first finding of this kind; null if there is none.
template <typename Kind>
const Kind* found(const std::vector<FitFinding>& findings) {
  for (const FitFinding& finding : findings) {
    if constexpr (holds<Kind, arc_finding::What>) {
      const auto* ofArc = std::get_if<ArcFinding>(&finding.what);
      if (const Kind* kind = ofArc ? std::get_if<Kind>(&ofArc->what) : nullptr) return kind;
    } else if (const Kind* kind = std::get_if<Kind>(&finding.what)) {
      return kind;
    }
  }
  return nullptr;
}

}  // namespace alidade::test
