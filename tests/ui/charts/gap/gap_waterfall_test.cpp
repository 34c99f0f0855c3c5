#include "ui/charts/gap/gap_waterfall.h"

#include <gtest/gtest.h>

#include <QImage>

#include "tests/ui/support.h"
#include "ui/charts/plotting/plot_style.h"

namespace alidade::ui {
namespace {

/// The painted widths of the stages' bars in the colour of the model, from the top.
std::vector<int> paintedWidths(const std::vector<double>& rms) {
  Gap gap{.evaluation = std::make_shared<const Evaluation>(evaluateFit(paperSession())),
          .diagnosis = {},
          .reason = {},
          .stages = {}};
  for (const double left : rms) gap.stages.emplace_back().rms = left;
  gap.noiseRms = 1.1 * rms.front();  // keeps the noise line clear of the bars
  GapWaterfall picture;
  picture.setGap(gap);
  picture.resize(600, picture.sizeHint().height());
  const QImage image = picture.grab().toImage().convertToFormat(QImage::Format_RGB32);
  const QColor colour = screenStyle(picture.palette(), picture.font()).upper;
  std::vector<int> widths;
  bool isWithin = false;
  for (int y = 0; y < image.height(); ++y) {
    int width = 0;
    for (int x = 0; x < image.width(); ++x) width += image.pixelColor(x, y) == colour ? 1 : 0;
    if (width > 0 && !isWithin) widths.push_back(width);
    isWithin = width > 0;
  }
  return widths;
}

// On a scale from zero, width is proportional to residual.
TEST(GapWaterfall, DrawsWhatIsLeftInProportion) {
  const std::vector<int> widths = paintedWidths({8, 4, 1});
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_GT(widths[0], 100);
  // One pixel for each rounded end.
  EXPECT_NEAR(widths[1], widths[0] / 2.0, 2);
  EXPECT_NEAR(widths[2], widths[0] / 8.0, 2);
}

TEST(GapWaterfall, LeavesATraceOfWhatIsAsGoodAsNothing) {
  const std::vector<int> widths = paintedWidths({8, 1e-6});
  ASSERT_EQ(widths.size(), 2u);
  EXPECT_GE(widths[1], 1);
  EXPECT_LT(widths[1], 5);
}

}  // namespace
}  // namespace alidade::ui
