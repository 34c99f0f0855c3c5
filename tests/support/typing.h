#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "core/effects/catalogue.h"
#include "core/session/session.h"
#include "core/simulation/simulate.h"
#include "tests/support/drawn_plan.h"

namespace alidade::test {

// A session as it is typed: every state of the table from the first row to the last, including typing slips,
// in plans of any geometry and under any option of the model. Everything follows from the seed.

/// A text after a typing slip; may be unchanged.
inline std::string slipped(std::string text, std::mt19937_64& random) {
  if (text.empty()) return text;
  const auto at = static_cast<std::size_t>(drawnCount(random, 0, static_cast<int>(text.size()) - 1));
  const char digit = static_cast<char>('0' + drawnCount(random, 0, 9));
  switch (drawnCount(random, 0, 6)) {
    case 0:
      text.erase(at);  // incomplete
      break;
    case 1:
      text.erase(at, 1);
      break;
    case 2:
      text.insert(at, 1, digit);
      break;
    case 3:
      text = "-" + text;
      break;
    case 4:
      if (at > 0) std::swap(text[at - 1], text[at]);
      break;
    default: {  // a digit mistyped: by far the most frequent slip
      std::vector<std::size_t> digits;
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
      if (!digits.empty())
        text[digits[static_cast<std::size_t>(drawnCount(random, 0, static_cast<int>(digits.size()) - 1))]] =
            digit;
    }
  }
  return text;
}

class Typing {
 public:
  explicit Typing(std::uint64_t seed) : m_random(seed) {
    const auto named = namedProtocols();
    DrawnPlan plan = drawnPlan(m_random, 24, seed);
    if (drawnChance(m_random, 0.5)) {  // a named plan, in its own geometry
      plan.protocol =
          named[static_cast<std::size_t>(drawnCount(m_random, 0, static_cast<int>(named.size()) - 1))];
      plan.truth = drawTruth(seed);
    }
    const auto session = simulate(plan.protocol, plan.truth, seed);
    m_whole = session ? *session : blankSession();
    drawOptions();
    m_session = m_whole;
    for (Position& position : m_session.positions) position.readings.clear();
    m_slips = drawnChance(m_random, 0.3) ? 0.3 : 0.05;
    m_order.resize(m_whole.positions.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    if (drawnChance(m_random, 0.3)) std::ranges::reverse(m_order);
  }

  const Session& session() const { return m_session; }

  /// The next state: a row typed, with or without a slip, or one retyped, excluded or deleted. False at the
  /// end.
  bool next() {
    if (drawnChance(m_random, 0.15) && touchUp()) return true;
    for (const std::size_t p : m_order) {
      std::vector<Reading>& typed = m_session.positions[p].readings;
      const std::vector<Reading>& all = m_whole.positions[p].readings;
      if (typed.size() >= all.size()) continue;
      Reading row = all[typed.size()];
      for (std::string* cell : cellsOf(row))
        if (drawnChance(m_random, m_slips / 3)) *cell = slipped(*cell, m_random);
      if (drawnChance(m_random, 0.02)) row = typed.empty() ? row : typed.back();
      typed.push_back(std::move(row));
      return true;
    }
    return false;
  }

 private:
  std::mt19937_64 m_random;
  Session m_whole, m_session;
  std::vector<std::size_t> m_order;  ///< order in which the positions are typed
  double m_slips = 0;

  static std::vector<std::string*> cellsOf(Reading& row) {
    std::vector<std::string*> cells{&row.horizontal, &row.vertical};
    for (std::string* cell : {&row.point, &row.face, &row.round, &row.slider})
      if (!cell->empty()) cells.push_back(cell);
    return cells;
  }

  template <typename Choices>
  const auto& oneOf(const Choices& choices) {
    return choices[static_cast<std::size_t>(drawnCount(m_random, 0, static_cast<int>(choices.size()) - 1))];
  }

  void drawOptions() {
    using Texts = std::vector<std::string>;
    static const Texts sigmas{"0.001", "0.1", "2", "2", "10", "3600"},
        lengths{"0", "1e-160", "0.001", "1", "100"};
    Instrument& instrument = m_whole.instrument;
    if (drawnChance(m_random, 0.2)) instrument.sigmaHorizontalArcsec = oneOf(sigmas);
    if (drawnChance(m_random, 0.2)) instrument.sigmaVerticalArcsec = oneOf(sigmas);
    if (drawnChance(m_random, 0.2)) instrument.sigmaZeroArcsec = oneOf(Texts{"0", "0.001", "2", "3600"});
    if (drawnChance(m_random, 0.2)) instrument.sigmaSliderArcsec = oneOf(sigmas);
    if (drawnChance(m_random, 0.2)) m_whole.geometry.sigmaDistanceMm = oneOf(lengths);
    if (drawnChance(m_random, 0.05)) m_whole.geometry.distanceMm = oneOf(Texts{"0.001", "2.405", "1e9"});
    m_whole.model.radius = oneOf(Texts{"", "", "free", "common", "known"});
    if (m_whole.model.radius == "known") m_whole.geometry.sigmaRadiusMm = oneOf(lengths);
    m_whole.model.verticalAngle = oneOf(Texts{"", "", "", "planar"});
    m_whole.acceptance.toleranceMm = oneOf(Texts{"", "0.001", "2.5"});
    m_whole.acceptance.coverage = oneOf(Texts{"", "0.5", "0.95", "0.9999999"});
    m_whole.acceptance.referenceIntersectionMm = oneOf(Texts{"", "", "2"});
    if (drawnChance(m_random, 0.35))
      for (int count = drawnCount(m_random, 1, 4); count > 0; --count)
        m_whole.model.effects.emplace_back(oneOf(effectCatalogue()).id);
    if (drawnChance(m_random, 0.1)) m_whole.positions.resize(1);
    if (drawnChance(m_random, 0.05)) m_whole.positions.push_back(oneOf(m_whole.positions));
  }

  bool touchUp() {
    Position& position = oneOfPositions();
    if (position.readings.empty()) return false;
    auto& rows = position.readings;
    const auto at = static_cast<std::size_t>(drawnCount(m_random, 0, static_cast<int>(rows.size()) - 1));
    switch (drawnCount(m_random, 0, 3)) {
      case 0:
        rows[at].excluded = !rows[at].excluded;
        break;
      case 1:
        std::swap(rows[at], rows.back());
        break;
      case 2:
        position.zero.vertical = slipped(position.zero.vertical, m_random);
        break;
      default: {
        const std::vector<std::string*> cells = cellsOf(rows[at]);
        std::string& cell = *oneOf(cells);
        cell = slipped(cell, m_random);
      }
    }
    return true;
  }

  Position& oneOfPositions() {
    return m_session.positions[static_cast<std::size_t>(
        drawnCount(m_random, 0, static_cast<int>(m_session.positions.size()) - 1))];
  }
};

}  // namespace alidade::test
