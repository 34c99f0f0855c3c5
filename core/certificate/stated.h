#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/session/session.h"

namespace alidade {

/// The entries required by the schema, as session and options state them. A certificate states empty ones as
/// “not stated”.
struct StatedEntries {
  std::string identifier;   ///< the report's number, or the SHA-256 of the session's bytes
  std::string country;      ///< ISO 3166-1; if empty "ZZ", which is reserved for private use
  std::string begin, end;   ///< days of the measurement
  std::string performedAt;  ///< "other" if empty
  std::string laboratory, laboratoryAddress;  ///< empty: not stated, as for all below
  std::string customer, customerAddress;
  std::string authorisedBy, operatorName;
  std::string device, manufacturer, serial;
  std::vector<const char*> notStated;  ///< nouns for `Phrase::of` of the empty entries
};

/// "report number, customer": the nouns in the language of the thread.
std::string listedNouns(const StatedEntries& stated);

/// Splits a name from an address after its first comma, semicolon or line end, if both were typed into one
/// entry.
std::pair<std::string, std::string> nameAndAddress(const std::string& text);

}  // namespace alidade
