#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/effects/catalogue.h"
#include "core/session/session.h"
#include "tests/support/drawn_plan.h"

namespace alidade::test {

// Sessions whose readings are far from any arc, or on an arc that they hardly determine, at any valid size of
// L, R0 and σ. Everything follows from the seed.

enum class FarOff { Anywhere, AtAPoint, OnALine, InAHeap, OnAnArcOfNoise, OnALargeArc, OnASmallArc };

class FarOffSession {
 public:
  explicit FarOffSession(std::uint64_t seed) : m_random(seed), m_kind(static_cast<FarOff>(seed % 7)) {}

  Session session() {
    Session session;
    m_distance = size(1e-3, 9e5);
    m_radius = drawnChance(m_random, 0.5) ? size(1e-3, 9e5) : std::min(9e5, m_distance * size(0.01, 10));
    session.geometry.distanceMm = std::to_string(m_distance);
    session.geometry.radiusMm = std::to_string(m_radius);
    if (chance()) session.geometry.sigmaDistanceMm = std::to_string(size(1e-3, 9e5));
    if (chance()) session.geometry.sigmaRadiusMm = std::to_string(size(1e-3, 9e5));
    if (chance()) session.instrument.sigmaHorizontalArcsec = std::to_string(size(0.01, 3000));
    if (chance()) session.instrument.sigmaVerticalArcsec = std::to_string(size(0.01, 3000));
    if (chance()) session.instrument.sigmaZeroArcsec = std::to_string(size(0.01, 3000));
    session.acceptance.toleranceMm = std::to_string(size(1e-5, 9e5));
    if (chance()) session.acceptance.measurand = "distance";
    session.acceptance.coverage = oneOf<std::string>({"0.95", "0.5", "0.000001", "0.999999"});
    session.model.radius = oneOf<std::string>({"", "common", "known"});
    session.model.verticalAngle = oneOf<std::string>({"", "planar"});
    if (chance()) addEffects(session.model);
    if (drawnChance(m_random, 0.2))
      session.instrument.known.push_back({.effect = "collimation",
                                          .value = std::to_string(size(1, 9e5)),
                                          .sigma = std::to_string(size(1e-4, 9e5)),
                                          .unit = "arcsec"});
    m_hasSlider = chance();
    const auto axes = oneOf<std::vector<int>>({{0, 180}, {0, 180}, {0, 180, 0}, {180}});
    const int points = drawnCount(m_random, 3, 12), rounds = drawnCount(m_random, 1, 2);
    for (const int axis : axes) session.positions.push_back(position(axis, points, rounds));
    return session;
  }

 private:
  struct Direction {
    double a, e;  ///< degrees
  };

  std::mt19937_64 m_random;
  FarOff m_kind;
  double m_distance = 0, m_radius = 0;
  bool m_hasSlider = false;

  bool chance() { return drawnChance(m_random, 0.4); }
  double size(double least, double most) { return drawnSize(m_random, least, most); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }
  double noise(double sigma) { return sigma * std::normal_distribution<double>()(m_random); }
  template <typename Value>
  Value oneOf(const std::vector<Value>& values) {
    return values[static_cast<std::size_t>(drawnCount(m_random, 0, static_cast<int>(values.size()) - 1))];
  }

  void addEffects(Model& model) {
    for (const Effect& effect : effectCatalogue())
      if (drawnChance(m_random, 0.15)) model.effects.emplace_back(effect.id);
  }

  Position position(int axis, int points, int rounds) {
    Position position;
    position.axisDeg = std::to_string(axis);
    const double zero = between(0, 360), turn = between(0, std::numbers::pi), scatter = size(1e-4, 10);
    position.zero.horizontal = degrees(zero);
    position.zero.vertical = "90°";
    const Direction base{between(-75, 75), between(-75, 75)};
    for (int round = 1; round <= rounds; ++round)
      for (int point = 1; point <= points; ++point) {
        const double part = (point - 0.5) / points;
        const Direction seen = sighted(part, base, turn, scatter);
        Reading row;
        row.round = std::to_string(round);
        row.point = std::to_string(point);
        row.horizontal = degrees(std::fmod(zero + seen.a + 360, 360));
        row.vertical = degrees(90 - seen.e);
        if (m_hasSlider) row.slider = degrees((axis == 0 ? 180 : -180) * part + noise(scatter));
        position.readings.push_back(row);
      }
    return position;
  }

  Direction sighted(double part, const Direction& base, double turn, double scatter) {
    constexpr double most = 79;
    const double along = 10 * scatter * (part - 0.5);
    Direction seen{};
    switch (m_kind) {
      case FarOff::Anywhere:
        seen = {between(-most, most), between(-most, most)};
        break;
      case FarOff::AtAPoint:
        seen = base;
        break;
      case FarOff::OnALine:
        seen = {along * std::cos(turn), along * std::sin(turn)};
        break;
      case FarOff::InAHeap:
        seen = {base.a + noise(scatter), base.e + noise(scatter)};
        break;
      case FarOff::OnAnArcOfNoise:
        seen = onArc(part, m_radius, scatter);
        break;
      case FarOff::OnALargeArc:
        seen = onArc(part / 100, 1000 * m_radius, 0);
        break;
      case FarOff::OnASmallArc:
        seen = onArc(part, m_radius / 1000, scatter / 100);
        break;
    }
    return {std::clamp(seen.a, -most, most), std::clamp(seen.e, -most, most)};
  }

  Direction onArc(double part, double radius, double scatter) {
    const double phi = std::numbers::pi * part, x = radius * std::cos(phi), y = radius * std::sin(phi);
    constexpr double degree = std::numbers::pi / 180;
    return {std::atan2(x, m_distance) / degree + noise(scatter),
            std::atan2(y, std::hypot(x, m_distance)) / degree + noise(scatter)};
  }

  static std::string degrees(double value) { return std::to_string(value) + "°"; }
};

}  // namespace alidade::test
