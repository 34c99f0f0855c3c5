#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade {

std::string_view nameOf(CauseOwner owner) {
  switch (owner) {
    case CauseOwner::Instrument:
      return "instrument";
    case CauseOwner::Guideway:
      return "guideway";
    case CauseOwner::Time:
      break;
  }
  return "time";
}

}  // namespace alidade
