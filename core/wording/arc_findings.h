#pragma once

#include "core/adjustment/result/fit_finding.h"
#include "core/wording/words.h"

namespace alidade {

/// "0°: the readings scatter 7.3 times their stated noise …".
Words wordsOf(const ArcFinding& finding);

}  // namespace alidade
