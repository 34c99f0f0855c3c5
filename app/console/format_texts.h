#pragma once

#include <string>

namespace alidade::console {

/// The formats of files of readings, for the help of a command: lines that end, `Read are …, and tables.`
std::string readableFormatsSentence();

/// The same in short: `Leica GSI, Trimble M5, …`.
std::string formatNames();

}  // namespace alidade::console
