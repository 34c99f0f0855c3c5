#pragma once

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/session/session_file.h"
#include "tests/support/paper_table.h"

namespace alidade::test {

/// A session with known truth, from an independent ray tracer (tests/reference/trials, closures).
struct Trial {
  std::string id, kind, protocol;
  double intersection = 0;  ///< true Δd, mm
  nlohmann::json effects;   ///< true sizes: arcsec, mm, deg
  double visibleSigma = 0;  ///< of the effect in the readings; infinite if it was not calculated
  std::set<std::string> lookAlikes;
  nlohmann::json truth;  ///< the complete truth
  Measurement measurement;
};

inline std::set<std::string> lookAlikesOf(const nlohmann::json& truth) {
  std::set<std::string> ids;
  for (const auto& entry : truth.value("look_alikes", nlohmann::json::array())) ids.insert(entry.at(0));
  return ids;
}

inline std::vector<Trial> trialsIn(const std::string& name) {
  const std::string folder = std::string(ALIDADE_REFERENCE_DIR) + "/" + name + "/";
  std::ifstream file(folder + "truth.json");
  if (!file) throw std::runtime_error(folder + "truth.json is missing");
  std::vector<Trial> all;
  const nlohmann::json truths = nlohmann::json::parse(file);
  for (const auto& [id, truth] : truths.items()) {
    const Result<Session> session = loadSession(folder + "sessions/" + id + ".alidade");
    if (!session) throw std::runtime_error(session.problem().text());
    all.push_back({id, truth.at("kind"), truth.at("protocol"), truth.at("intersection_mm"),
                   truth.at("effects"), truth.value("visible_sigma", std::numeric_limits<double>::infinity()),
                   lookAlikesOf(truth), truth, measurementOf(*session)});
  }
  return all;
}

inline std::vector<Trial> trials() {
  return trialsIn("trials");
}

/// Trials whose effects show in the closures between the two positions.
inline std::vector<Trial> closureTrials() {
  return trialsIn("closures");
}

/// The measurement, by this protocol, of the trial without any effect.
inline Measurement trialMeasurement(const std::string& protocol) {
  for (Trial& trial : trials())
    if (trial.kind == "none" && trial.protocol == protocol) return std::move(trial.measurement);
  throw std::runtime_error("no trial without effect by protocol " + protocol);
}

/// Adds a minute for each row, so that the pause between the positions, in which linear drifts stop, is
/// known.
inline Measurement withTimes(Measurement measurement) {
  for (ArcMeasurement& arc : measurement.arcs)
    for (Sighting& sighting : arc.sightings) sighting.minutes = static_cast<double>(sighting.sequence);
  setMoments(measurement);
  return measurement;
}

}  // namespace alidade::test
