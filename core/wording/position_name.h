#pragma once

#include <string>

namespace alidade {

/// "0°"; for a repeat of the axis "0° again", "0° again (3)".
std::string positionName(int axisDeg, int repeat = 1);

}  // namespace alidade
