#pragma once

#include <span>
#include <string_view>

namespace alidade::fuzz {

// The targets for the core, each in a separate source. A target accepts any bytes; it fails by `require`, by
// an exception, or by a sanitizer's report.

void throwSession(std::string_view bytes);  ///< a session file: read, write, fit, diagnose, plan
void throwTyping(std::string_view bytes);   ///< a session as it is being typed, steered by the bytes
void throwGsi(std::string_view bytes);      ///< an instrument's file
void throwCsv(std::string_view bytes);      ///< a table of readings
void throwAngles(std::string_view bytes);   ///< one entry of a form
void throwTruth(std::string_view bytes);    ///< a truth file, or an effect of the command line
void throwRecords(std::string_view bytes);  ///< a protocol, or the record of an instrument
void throwValues(std::string_view bytes);   ///< values over time, or rounds of an instrument check
void throwTalk(std::string_view bytes);     ///< bytes from an instrument, and bytes sent to a simulated one
void throwFormula(std::string_view bytes);  ///< a formula of an effect of the user's own, or its file

struct Target {
  std::string_view name;  ///< of its program, corpus and dictionary
  void (*run)(std::string_view bytes);
};

std::span<const Target> targets();

}  // namespace alidade::fuzz
