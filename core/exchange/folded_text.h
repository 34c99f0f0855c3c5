#pragma once

#include <string>
#include <string_view>

namespace alidade {

/// `text` for comparing words that people write: in the plain signs of `plainSigns`, in small letters, and
/// Latin and Cyrillic letters without accents. `Höhe` and `HOHE` are `hohe`, `Приём` is `прием`, `ß` is `ss`,
/// `№` is `no`.
std::string foldedText(std::string_view text);

}  // namespace alidade
