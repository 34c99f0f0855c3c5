#pragma once

#include <functional>

#include "core/session/sighting_protocol.h"

class QMenu;

namespace alidade::ui {

/// Adds the program's own protocols, described in words; `follow` receives the one that the user chooses.
void addNamedProtocols(QMenu& menu, const std::function<void(const SightingProtocol&)>& follow);

}  // namespace alidade::ui
