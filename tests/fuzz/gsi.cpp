#include "core/exchange/gsi_reader.h"

#include "core/exchange/m5_reader.h"
#include "core/exchange/sdr_reader.h"
#include "core/exchange/text_lines.h"
#include "tests/fuzz/imported.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

void throwGsi(std::string_view bytes) {
  if (const Result<std::string> text = utf8Text(bytes)) checkPlaces(readGsi(*text), *text);
  if (const Result<std::string> text = utf8Text(bytes)) {
    checkPlaces(readM5(*text), *text);
    checkPlaces(readSdr(*text), *text);
  }
  importBytes(bytes, {});
  importBytes(bytes, {.zeroPoint = "100", .turnedAtLine = 3});
}

}  // namespace alidade::fuzz
