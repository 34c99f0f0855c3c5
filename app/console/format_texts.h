#pragma once

#include <string>

namespace alidade::console {

/// The readable formats for the help of a command: wrapped lines, `Read are …, and tables.`
std::string readableFormatsSentence();

/// The readable formats in short: `Leica GSI, Trimble M5, …`.
std::string formatNames();

}  // namespace alidade::console
