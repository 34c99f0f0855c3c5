#include "core/exchange/file_format.h"
#include "core/exchange/text_lines.h"
#include "tests/fuzz/imported.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

void throwGsi(std::string_view bytes) {
  if (const Result<std::string> text = utf8Text(bytes))
    for (const FileFormat& format : fileFormats())
      if (format.read) checkPlaces(format.read(*text, {}), *text);
  importBytes(bytes, {});
  importBytes(bytes, {.zeroPoint = "100"}, 3);
}

}  // namespace alidade::fuzz
