#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade::test {

/// Table I of the paper as a session, from tests/reference/paper-table-1.csv and the constants of the paper.
inline Session paperSession() {
  Session session = blankSession();
  session.title = "Table I";
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  session.acceptance.toleranceMm = "2.5";
  // The paper does not print the zero at 180°; this one, in whole seconds, reproduces every printed centre.
  session.positions.at(0).zero = {"332°32'54\"", "89°59'57\"", {}};
  session.positions.at(1).zero = {"332°32'50\"", "89°59'58\"", {}};

  std::ifstream file(std::string(ALIDADE_REFERENCE_DIR) + "/paper-table-1.csv");
  if (!file) throw std::runtime_error("tests/reference/paper-table-1.csv is missing");
  std::string line;
  std::getline(file, line);  // the column names
  while (std::getline(file, line)) {
    // axis,point,"α","β" with the seconds mark doubled, as CSV quotes it
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[++i];
      else if (line[i] == '"')
        quoted = !quoted;
      else if (line[i] == ',' && !quoted)
        fields.emplace_back();
      else
        fields.back() += line[i];
    }
    Reading reading;
    reading.point = fields.at(1);
    reading.horizontal = fields.at(2);
    reading.vertical = fields.at(3);
    session.positions.at(fields.at(0) == "0" ? 0 : 1).readings.push_back(reading);
  }
  return session;
}

inline Measurement measurementOf(const Session& session) {
  Examined examined = examine(session);
  if (!examined.problems.empty()) throw std::runtime_error(examined.problems.front().text());
  return *std::move(examined.measurement);
}

inline Measurement paperMeasurement() {
  return measurementOf(paperSession());
}

}  // namespace alidade::test
