#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade {

/// Do the bytes have the mark of UTF-16, or a zero in every other byte as ASCII text in UTF-16 has?
bool isUtf16(std::string_view bytes);

/// Bytes of a file as UTF-8, without a byte order mark. UTF-8 and UTF-16 are recognised; GB 18030 if bytes
/// beyond ASCII form pairs of common Chinese characters; Windows-1251 if they form words of Cyrillic letters;
/// else Windows-1252. Fails on invalid UTF-16, and above the size limit.
Result<std::string> decodedText(std::string_view bytes);

}  // namespace alidade
