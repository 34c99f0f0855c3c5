#pragma once

#include <string>

namespace alidade {

/// "0°", and where the axis is measured the second or a later time "0° again", "0° again (3)".
std::string positionName(int axisDeg, int time = 1);

}  // namespace alidade
