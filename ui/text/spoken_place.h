#pragma once

#include <QString>

#include "core/base/place.h"
#include "core/session/session.h"

namespace alidade::ui {

/// "row 3 (point 7)"; rows count from 0 here and from 1 there.
QString spokenRow(std::size_t row, const std::string& point);

/// A place in a session as people call it: "0°, row 3 (point 7), vertical", "180° again, pointing
/// zero β0", "distance L". Rows count from 1. Empty for the session as a whole.
QString spokenPlace(const Session& session, const Place& place);

}  // namespace alidade::ui
