#pragma once

#include <functional>

#include "core/session/sighting_protocol.h"

class QMenu;

namespace alidade::ui {

/// Adds the protocols that the program knows, in words; `follow` is called with the one chosen.
void addNamedProtocols(QMenu& menu, const std::function<void(const SightingProtocol&)>& follow);

}  // namespace alidade::ui
