#include "core/wording/budget.h"

namespace alidade {

std::string textOf(UncertaintySource source) {
  switch (source) {
    case UncertaintySource::Readings:
      return "readings";
    case UncertaintySource::ModelEffects:
      return "model effects";
    case UncertaintySource::KnownRadius:
      return "known radius";
    case UncertaintySource::PointingZeros:
      return "pointing zeros";
    case UncertaintySource::Distance:
      return "distance";
  }
  return "";
}

}  // namespace alidade
