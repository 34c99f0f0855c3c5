#include "core/wording/cause_name.h"

#include "core/base/phrase.h"
#include "core/effects/cause_ids.h"
#include "core/wording/effect_name.h"

namespace alidade {

std::string causeName(const std::string& id) {
  if (id == jumpId) return Phrase::of("a jump of the orientation");
  if (id == grossErrorId) return Phrase::of("misread values");
  if (id == noiseId) return Phrase::of("noise larger than stated");
  if (id == formId) return Phrase::of("the form");
  if (id == relationId) return Phrase::of("the vertical angle relation");
  return effectName(id);
}

}  // namespace alidade
