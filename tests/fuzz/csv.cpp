#include "core/exchange/csv_reader.h"
#include "core/exchange/text_lines.h"
#include "tests/fuzz/imported.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

void throwCsv(std::string_view bytes) {
  if (const Result<std::string> text = utf8Text(bytes)) checkPlaces(readTable(*text, {}), *text);
  importBytes(bytes, {});
  importBytes(bytes, {.unit = AngleUnit::Dms, .zeroPoint = "P1"}, 3);
}

}  // namespace alidade::fuzz
