#pragma once

#include <string>

namespace alidade {

/// The common name of an effect from its identifier: "trunnion tilt". That of a user's own effect or an
/// unknown one is its identifier without prefix and underscores, made visible.
std::string effectName(const std::string& id);

/// The sign of a unit of the catalogue, with the blank before it: "″", "°", " mm"; empty for others.
std::string signOf(const std::string& unit);

}  // namespace alidade
