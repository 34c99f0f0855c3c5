#include "ui/text/cause_text.h"

#include <gtest/gtest.h>

namespace alidade::ui {
namespace {

using Kind = GapStage::Kind;

QStringList textsOf(const Gap& gap) {
  QStringList texts;
  for (const GapStage& stage : gap.stages) texts.append(stageText(gap, stage));
  return texts;
}

TEST(StageText, CountsTheMisreadValuesThatAreLeftOut) {
  Gap gap;
  gap.stages = {{}, {.kind = Kind::Proposed, .effect = "gross_error", .intersection = {}}};
  EXPECT_EQ(textsOf(gap),
            QStringList({QStringLiteral("as modelled"), QStringLiteral("without the misread value")}));
  gap.stages.push_back({.kind = Kind::Proposed, .effect = "collimation", .intersection = {}});
  gap.stages.push_back({.kind = Kind::Proposed, .effect = "gross_error", .intersection = {}});
  EXPECT_EQ(textsOf(gap),
            QStringList({QStringLiteral("as modelled"), QStringLiteral("without 1 misread value"),
                         QStringLiteral("+ collimation"), QStringLiteral("without 2 misread values")}));
}

TEST(StageText, CountsTheMisreadValuesThatOneStageLeavesOut) {
  Gap gap;
  gap.stages = {{}, {.kind = Kind::Proposed, .effect = "gross_error", .grossErrors = 3, .intersection = {}}};
  EXPECT_EQ(textsOf(gap),
            QStringList({QStringLiteral("as modelled"), QStringLiteral("without 3 misread values")}));
}

}  // namespace
}  // namespace alidade::ui
