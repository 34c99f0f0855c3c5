#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/session/session.h"

namespace alidade {

/// What the schema asks for, as the session states it; where it is empty a certificate says “not stated”.
struct StatedEntries {
  std::string identifier;   ///< the report's number, or one made of the session's bytes
  std::string country;      ///< ISO 3166-1; "ZZ", which that leaves to its users, where empty
  std::string begin, end;   ///< days of the measurement
  std::string performedAt;  ///< "other" where empty
  std::string laboratory, laboratoryAddress;  ///< empty: not stated; likewise all below
  std::string customer, customerAddress;
  std::string authorisedBy, operatorName;
  std::string device, manufacturer, serial;
  std::vector<const char*> notStated;  ///< nouns for `Phrase::of`, in the order of the schema
};

/// A name with an address behind its first comma, semicolon or line end, as one types both into one entry.
std::pair<std::string, std::string> nameAndAddress(const std::string& text);

}  // namespace alidade
