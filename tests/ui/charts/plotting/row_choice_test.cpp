#include "ui/charts/plotting/row_choice.h"

#include <gtest/gtest.h>

#include "core/evaluation/evaluation.h"
#include "tests/ui/support.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {
namespace {

struct DrawnRow {
  int round = 1, face = 1;
};

TEST(RowChoice, KnowsEachRoundAndFaceOnce) {
  const RowKinds kinds = RowKinds::of(std::vector<DrawnRow>{{2, 2}, {1, 1}, {2, 1}, {7, 2}, {1, 2}});
  EXPECT_EQ(kinds.rounds, (std::vector{1, 2, 7}));
  EXPECT_EQ(kinds.faces, (std::vector{1, 2}));
}

TEST(RowChoice, WhatIsNotThereCannotBeChosen) {
  const RowKinds kinds = RowKinds::of(std::vector<DrawnRow>{{1, 1}, {2, 1}});
  const RowChoice wanted{.round = 5, .face = 1};
  EXPECT_EQ(wanted.among(kinds), (RowChoice{.round = {}, .face = 1}));
  EXPECT_TRUE(wanted.among(kinds).takes(2, 1));
  EXPECT_FALSE(wanted.among(kinds).takes(2, 2));
}

TEST(RowSlots, StandSideBySideAroundTheirPlace) {
  const RowKinds kinds = RowKinds::of(std::vector<DrawnRow>{{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 1}});
  const RowSlots all(kinds, {});
  double sum = 0, last = -1e9;
  for (const int round : {1, 2, 3})
    for (const int face : {1, 2}) {
      const double shift = all.shift(round, face);
      EXPECT_GT(shift, last);
      last = shift;
      sum += shift;
    }
  EXPECT_NEAR(sum, 0, 1e-9);
  EXPECT_LE(last, 12) << "they do not run into the next place";
  const RowSlots one(kinds, {.round = 2, .face = 1});
  EXPECT_FALSE(one.areApart());
  EXPECT_EQ(one.shift(2, 1), 0);
}

// In one place of a full protocol, no two marks of one kind overlap.
TEST(RowSlots, TellRoundsAndFacesApartWhereMarksShareAPlace) {
  Session session = paperSession();
  for (Position& position : session.positions) {
    const std::vector<Reading> base = position.readings;
    for (const char* round : {"2", "3"})
      for (Reading row : base) {
        row.round = round;
        position.readings.push_back(row);
      }
  }
  const Evaluation evaluation = evaluate(session);
  ResidualPlot residuals;
  ArcPlot arcs;
  for (Plot* plot : {static_cast<Plot*>(&residuals), static_cast<Plot*>(&arcs)}) {
    plot->setStyle(printStyle(QStringLiteral("DejaVu Sans")));
    plot->setEvaluation(evaluation);
    plot->arrange({700, 500});
    const auto& marks = plot->markers().marks();
    for (std::size_t i = 0; i < marks.size(); ++i)
      for (std::size_t k = i + 1; k < marks.size(); ++k) {
        const QPointF away =
            plot->markers().scenePosition(marks[i]) - plot->markers().scenePosition(marks[k]);
        if (marks[i].kind == marks[k].kind && std::abs(away.x()) < 30) {
          EXPECT_GT(std::hypot(away.x(), away.y()), 3);
        }
      }
    bool isListed = false;
    for (const LegendEntry& entry : plot->legend().entries())
      isListed = isListed || entry.text == QStringLiteral("rounds side by side");
    EXPECT_TRUE(isListed);
  }
}

TEST(RowSlots, FaceTwoIsStruckThrough) {
  const Evaluation evaluation = evaluateFit(sessionInTwoFaces());
  ResidualPlot residuals;
  ArcPlot arcs;
  for (Plot* plot : {static_cast<Plot*>(&residuals), static_cast<Plot*>(&arcs)}) {
    plot->setStyle(printStyle(QStringLiteral("DejaVu Sans")));
    plot->setEvaluation(evaluation);
    std::size_t struck = 0;
    for (const LegendEntry& entry : plot->legend().entries()) {
      const auto* marker = std::get_if<Marker>(&entry.sign);
      struck += marker && marker->struck ? 1 : 0;
    }
    EXPECT_EQ(struck, 1u);
    const Mark &first = plot->markers().marks()[0], &second = plot->markers().marks().back();
    EXPECT_TRUE(plot->describe(first).contains(QStringLiteral("face 1")));
    EXPECT_TRUE(plot->describe(second).contains(QStringLiteral("face 2")));
    EXPECT_NE(first.kind, second.kind);
  }
  residuals.setChoice({.rows = {.round = {}, .face = 2}});
  arcs.setChoice({.round = {}, .face = 2});
  for (const Plot* plot : {static_cast<const Plot*>(&residuals), static_cast<const Plot*>(&arcs)})
    for (const Mark& mark : plot->markers().marks())
      EXPECT_TRUE(plot->describe(mark).contains(QStringLiteral("face 2")));
  EXPECT_EQ(arcs.legend().entries().back().text, QStringLiteral("only face 2"));
}

}  // namespace
}  // namespace alidade::ui
