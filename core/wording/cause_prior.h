#pragma once

#include <string>

namespace alidade {

/// 1σ of what is plausible of an effect of the catalogue before anything is read: "30 arcsec", "0.05 mm"; the
/// unit of a pure number is left out. Empty for what is none: a jump, misread values, larger noise.
std::string plausibleSizeText(const std::string& id);

}  // namespace alidade
