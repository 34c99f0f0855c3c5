#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade {

/// Has it the mark of UTF-16, or a zero for every other byte as such text of ASCII has?
bool isUtf16(std::string_view bytes);

/// Bytes of a file as UTF-8, without a byte order mark: UTF-8 and UTF-16 as they are, GB 18030 where bytes
/// beyond ASCII come in pairs that are the common characters of Chinese, Windows-1251 where they are words of
/// Cyrillic letters, else Windows-1252. Fails on UTF-16 that is none, and beyond what is read.
Result<std::string> decodedText(std::string_view bytes);

}  // namespace alidade
