#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/session/session_file.h"
#include "tests/support/paper_table.h"

namespace alidade::test {

struct ReferenceArc {
  int axisDeg;
  double x, y, radius, sigmaX, sigmaY, sigmaRadius, chiSquare;  // mm
};

/// A session and its fit from tests/reference/high-precision/solve.py.
struct ReferenceFit {
  std::string name;
  Measurement measurement;
  std::vector<ReferenceArc> arcs;
  std::optional<double> intersection, sigmaIntersection;

  bool hasSliders() const {
    for (const ArcMeasurement& arc : measurement.arcs)
      for (const Sighting& sighting : arc.sightings)
        if (sighting.slider) return true;
    return false;
  }
};

inline std::vector<ReferenceFit> referenceFits() {
  const std::string folder = std::string(ALIDADE_REFERENCE_DIR) + "/high-precision/";
  std::ifstream file(folder + "results.json");
  if (!file) throw std::runtime_error("tests/reference/high-precision/results.json is missing");
  const auto number = [](const nlohmann::json& text) { return std::stod(text.get<std::string>()); };
  std::vector<ReferenceFit> fits;
  for (const nlohmann::json& entry : nlohmann::json::parse(file)) {
    const Result<Session> session = loadSession(folder + entry.at("session").get<std::string>());
    if (!session) throw std::runtime_error(session.problem().text());
    ReferenceFit fit{entry.at("name"), measurementOf(*session), {}, {}, {}};
    fit.measurement.relation =
        entry.at("relation") == "exact" ? VerticalAngleRelation::Exact : VerticalAngleRelation::Planar;
    for (const nlohmann::json& arc : entry.at("arcs"))
      fit.arcs.push_back({arc.at("axis_deg"), number(arc.at("x")), number(arc.at("y")),
                          number(arc.at("radius")), number(arc.at("sigma_x")), number(arc.at("sigma_y")),
                          number(arc.at("sigma_radius")), number(arc.at("chi_square"))});
    if (entry.contains("intersection")) {
      fit.intersection = number(entry.at("intersection"));
      fit.sigmaIntersection = number(entry.at("sigma_intersection"));
    }
    fits.push_back(std::move(fit));
  }
  return fits;
}

}  // namespace alidade::test
