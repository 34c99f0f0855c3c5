#pragma once

#include <string>
#include <string_view>

namespace alidade {

/// `text` in a form for comparing words: it has the signs of `plainSigns` and lower-case letters, and its
/// Latin and Cyrillic letters have no accents. `Höhe` and `HOHE` become `hohe`, `Приём` becomes `прием`, `ß`
/// becomes `ss`, `№` becomes `no`.
std::string foldedText(std::string_view text);

}  // namespace alidade
