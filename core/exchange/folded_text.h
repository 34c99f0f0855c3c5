#pragma once

#include <string>
#include <string_view>

namespace alidade {

/// `text` for comparing words that people write: with the signs of `plainSigns`, in lower case, and Latin and
/// Cyrillic letters without accents. `Höhe` and `HOHE` are `hohe`, `Приём` is `прием`, `ß` is `ss`, `№` is
/// `no`.
std::string foldedText(std::string_view text);

}  // namespace alidade
