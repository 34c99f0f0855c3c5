#include "core/diagnosis/location.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string_view>

namespace alidade {

namespace {

using Eigen::Index;

/// What a component stays with when the guideway is turned and time goes on.
std::string frameOf(const Component& component) {
  if (component.kind == Component::Kind::Jump) return "time";
  if (component.id.find("drift") != std::string::npos ||
      component.id.find("with time") != std::string::npos ||
      component.id.find("round to round") != std::string::npos)
    return "time";
  static const std::set<std::string_view> guideway{"plane_tilt",   "plane_offset",       "arc_ellipticity",
                                                   "arc_lobing",   "gravity_sag",        "plane_warp",
                                                   "slider_scale", "slider_eccentricity"};
  if (guideway.contains(component.id)) return "guideway";
  if (component.kind == Component::Kind::Shape &&
      (component.id.find("guideway") != std::string::npos ||
       component.id.find("place") != std::string::npos || component.id.find("slider") != std::string::npos))
    return "guideway";
  return "instrument";
}

class Tally {
 public:
  void add(const std::string& by, const std::string& of, double square, double expected) {
    Sum& sum = m_sums[by][of];
    sum.square += square;
    sum.expected += expected;
  }

  std::vector<GapShare> shares() const {
    std::vector<GapShare> shares;
    for (const auto& [by, groups] : m_sums) {
      double beyond = 0, all = 0;
      for (const auto& [of, sum] : groups) {
        beyond += std::max(0.0, sum.square - sum.expected);
        all += sum.square;
      }
      for (const auto& [of, sum] : groups) {
        const double part = beyond > 0 ? std::max(0.0, sum.square - sum.expected) / beyond
                            : all > 0  ? sum.square / all
                                       : 1.0 / static_cast<double>(groups.size());
        shares.push_back({by, of, part});
      }
    }
    return shares;
  }

 private:
  struct Sum {
    double square = 0, expected = 0;
  };
  std::map<std::string, std::map<std::string, Sum>> m_sums;
};

std::string sectorOf(double s) {
  constexpr int width = 30;  // degrees of slider coordinate
  const int from = static_cast<int>(std::floor(s * 180 / std::numbers::pi / width)) * width;
  std::string name = std::to_string(from) + "…" + std::to_string(from + width) + "°";
  return name;
}

}  // namespace

std::vector<GapShare> sharesOfReadings(const Leftover& leftover, const Measurement& measurement,
                                       const JointFit& fit) {
  Tally tally;
  const Index readings = leftover.readings();
  const auto isOfSameRow = [&](Index i, Index j) {
    return leftover.reading(i).arc == leftover.reading(j).arc &&
           leftover.reading(i).sighting == leftover.reading(j).sighting;
  };
  for (Index first = 0, next = 0; first < readings; first = next) {
    double squares = 0, expectations = 0;
    bool any = false;
    for (; next < readings && isOfSameRow(first, next); ++next) {
      if (!leftover.reading(next).takesPart) continue;
      const double square = std::pow(leftover.residual()[next], 2), expected = leftover.redundancy(next);
      tally.add("circle", std::string(nameOf(leftover.reading(next).kind)), square, expected);
      squares += square;
      expectations += expected;
      any = true;
    }
    if (!any) continue;
    const LinearReading& reading = leftover.reading(first);
    const ArcMeasurement& arc = measurement.arcs[reading.arc];
    const Sighting& sighting = arc.sightings[reading.sighting];
    const auto quarter = 4 * sighting.sequence / std::max<std::size_t>(measurement.rows, 1);
    const double s = (arc.axisDeg == 0 ? 1 : -1) * fit.arcAngles[reading.arc][reading.sighting];
    const auto add = [&](const char* by, const std::string& of) { tally.add(by, of, squares, expectations); };
    add("position", std::to_string(arc.axisDeg));
    add("face", std::to_string(sighting.face));
    add("round", std::to_string(sighting.round));
    add("sector", sectorOf(s));
    add("time", "quarter " + std::to_string(quarter + 1));
  }
  return tally.shares();
}

std::vector<GapShare> sharesOfFrames(const Leftover& leftover, const std::vector<Component>& candidates,
                                     const std::vector<Explanation>& explanations) {
  std::map<std::string, double> energies{
      {"guideway", 0}, {"instrument", 0}, {"time", 0}, {"readings", 0}, {"noise", 0}};
  for (const Explanation& explanation : explanations) {
    const double chance = explanation.chance;
    if (chance < 1e-6) continue;
    for (const Part& part : explanation.parts) {
      const bool isReading = part.component >= candidates.size();
      const double energy =
          isReading ? std::pow(part.weights[0], 2) *
                          leftover.redundancy(static_cast<Index>(part.component - candidates.size()))
                    : signatureSquare(candidates[part.component], part.weights);
      energies[isReading ? "readings" : frameOf(candidates[part.component])] += chance * energy;
    }
    energies["noise"] += chance * std::max(0.0, explanation.chiSquare - leftover.degreesOfFreedom());
  }
  double sum = 0;
  for (const auto& [frame, energy] : energies) sum += energy;
  std::vector<GapShare> shares;
  shares.reserve(energies.size());
  for (const auto& [frame, energy] : energies)
    shares.push_back({"frame", frame, sum > 0 ? energy / sum : frame == "noise" ? 1.0 : 0.0});
  return shares;
}

}  // namespace alidade
