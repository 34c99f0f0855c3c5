#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/session/session_file.h"
#include "tests/support/paper_table.h"

namespace alidade::test {

/// A session with known truth, from an independent ray tracer (tests/reference/trials).
struct Trial {
  std::string id, kind, protocol;
  double intersection = 0;  ///< true Δd, mm
  nlohmann::json effects;   ///< true sizes: arcsec, mm, deg
  nlohmann::json truth;     ///< all that is known of it
  Measurement measurement;
};

inline std::vector<Trial> trials() {
  const std::string folder = std::string(ALIDADE_REFERENCE_DIR) + "/trials/";
  std::ifstream file(folder + "truth.json");
  if (!file) throw std::runtime_error("tests/reference/trials/truth.json is missing");
  std::vector<Trial> all;
  const nlohmann::json truths = nlohmann::json::parse(file);
  for (const auto& [id, truth] : truths.items()) {
    const Result<Session> session = loadSession(folder + "sessions/" + id + ".alidade");
    if (!session) throw std::runtime_error(session.problem().text());
    all.push_back({id, truth.at("kind"), truth.at("protocol"), truth.at("intersection_mm"),
                   truth.at("effects"), truth, measurementOf(*session)});
  }
  return all;
}

/// The measurement of the trial without any effect that was taken by this protocol.
inline Measurement trialMeasurement(const std::string& protocol) {
  for (Trial& trial : trials())
    if (trial.kind == "none" && trial.protocol == protocol) return std::move(trial.measurement);
  throw std::runtime_error("no trial without effect by protocol " + protocol);
}

}  // namespace alidade::test
