#pragma once

#include <QString>

#include "core/adjustment/gross_errors/suspects.h"

namespace alidade::ui {

/// The texts of a proposal: "341°25′24″", "face 2", "341°25′24″ and 88°16′49″".
QString proposalText(const Proposal& proposal, CircleUnit unit);

}  // namespace alidade::ui
